#include "spatial/detail/spatial_run.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace overturn::spatial {
SpatialRun::SpatialRun(SpatialBlock const& block, Excitation const& shaking, ContactAccuracy const& accuracy,
                       std::optional<SpatialStart> const& start)
    : Base(block.planar, shaking), block_(block) {
    OVERTURN_EXPECT(block_.rim == block_.points.empty());
    OVERTURN_EXPECT(block_.rim || (block_.points.size() >= 4 && block_.points.size() <= most_spatial_points));
    OVERTURN_EXPECT(block_.points.size() % 2 == 0);
    auto const kind = kind_of(block_);
    lane_.points = kind.points;
    lane_.opposite = kind.opposite;
    lane_.disc = kind.disc;
    lane_.of_rim = kind.of_rim;
    fill_trial(accuracy);
    fill_points();
    place(start.value_or(SpatialStart{}));
    if (!accuracy.rest_gate || start) {
        begin_shaken();
    }
}

// Too weak for the base to part or to leave its place. Between two such samples all are: the bound is convex.
bool SpatialRun::weak(std::size_t sample) const {
    auto const a = shaking_at(sample);
    if (!std::isfinite(a.x + a.y + a.z)) {
        return false;  // nothing holds against it
    }
    return std::sqrt(a.x * a.x + a.y * a.y) <= get(State::rest_ratio) * (planar_.gravity_mps2 + a.z);
}

SpatialRun::Acceleration SpatialRun::shaking_at(std::size_t sample) const {
    auto const of = [&](std::span<double const> wave) { return wave.empty() ? 0 : wave[sample] * shaking_.scale; };
    return {of(shaking_.horizontal_mps2), of(shaking_.transverse_mps2), of(shaking_.vertical_mps2)};
}

void SpatialRun::show_sample() {
    auto const index = static_cast<std::size_t>(get(State::index));
    auto const here = shaking_at(index);
    auto const next = shaking_at(index + 1);
    put(State::ax, here.x);
    put(State::ax_change, next.x - here.x);
    put(State::ay, here.y);
    put(State::ay_change, next.y - here.y);
    put(State::az, here.z);
    put(State::az_change, next.z - here.z);
    put(State::substep, 0);
}

// Of what touches of a disc, beyond its chord at the angle that its depth has.
SpatialRun::TouchingMoments SpatialRun::segment(double radius_m) const {
    auto const [middle, change, p, s, c, towards] = rim_depth(radius_m);
    double const square = radius_m * radius_m;
    double const both = s * c * (1 - 2 * s * s);
    return {square * (p - s * c), 2 * square * radius_m * s * s * s / 3, square * square * (p - both) / 4,
            square * square * (p / 4 - s * c / 3 + both / 12)};
}

SpatialRun::TouchingMoments SpatialRun::touching_moments() const {
    double const r = block_.edge_m;
    if (!block_.inner_m) {
        auto const rim = rim_depth(r);
        double const k = get(State::stiffness) / (2 * pi);
        return {2 * k * rim.arc, 2 * k * r * rim.sine, k * r * r * (rim.arc + rim.sine * rim.cosine),
                k * r * r * (rim.arc - rim.sine * rim.cosine)};
    }
    auto const all = segment(r);
    auto const hole = segment(*block_.inner_m);
    double const k = get(State::ring);
    return {k * (all.k - hole.k), k * (all.x - hole.x), k * (all.xx - hole.xx), k * (all.yy - hole.yy)};
}

SpatialRun::BedMoments SpatialRun::rim_moments() const {
    auto const touching = touching_moments();
    auto const [k, x, xx, yy] = touching;
    auto const [c, s] = rim_depth(block_.edge_m).towards;
    return {k, x * c, x * s, xx * c * c + yy * s * s, (xx - yy) * c * s, xx * s * s + yy * c * c};
}

// Of the points that touch: by pairs, as forces are summed.
SpatialRun::BedMoments SpatialRun::bed_moments() const {
    if (block_.rim) {
        return rim_moments();
    }
    auto const of = [&](int i) {
        auto const point = placed(i);
        double const k = point.depth > 0 ? point.stiffness : 0;
        return BedMoments{
            k, k * point.x, k * point.y, k * point.x * point.x, k * point.x * point.y, k * point.y * point.y};
    };
    BedMoments sum{};
    for (int i = 0; i < lane_.points; i += 2) {
        auto const one = of(i);
        auto const other = of(i + 1);
        sum = {sum.k + (one.k + other.k),    sum.x + (one.x + other.x),    sum.y + (one.y + other.y),
               sum.xx + (one.xx + other.xx), sum.xy + (one.xy + other.xy), sum.yy + (one.yy + other.yy)};
    }
    return sum;
}

// Moment that resists a lean, over the mass and per radian: that of the springs that touch, about their own centre,
// less that of the weight, which tips the body further.
SpatialRun::LeanStiffness SpatialRun::lean_stiffness(BedMoments const& bed) const {
    double const falling = planar_.centre_height_m * (planar_.gravity_mps2 + held_.z);
    return {bed.xx - bed.x * bed.x / bed.k - falling, bed.xy - bed.x * bed.y / bed.k,
            bed.yy - bed.y * bed.y / bed.k - falling};
}

// How the springs give way to a change of the shaking, in static balance.
SpatialRun::Yielding SpatialRun::yielding(BedMoments const& bed, Acceleration const& by) const {
    double const h = planar_.centre_height_m;
    auto const [xx, xy, yy] = lean_stiffness(bed);
    double const compliance = h / (xx * yy - xy * xy);
    double const slope_x = -compliance * (yy * by.x - xy * by.y);
    double const slope_y = -compliance * (xx * by.y - xy * by.x);
    double const grip = bed.k * planar_.pad.tangential_ratio;
    return {slope_x, slope_y, h * slope_x - by.x / grip, h * slope_y - by.y / grip,
            (slope_x * bed.x + slope_y * bed.y - by.z) / bed.k};
}

// While the body was held the shaking grew. It starts to move from where that shaking has let the springs sink, sway
// and lean, and as fast as the shaking changes.
void SpatialRun::wake() {
    auto const bed = bed_moments();
    auto const stiff = lean_stiffness(bed);
    if (!(bed.k > 0) || !(stiff.xx > 0) || !(stiff.xx * stiff.yy > stiff.xy * stiff.xy)) {
        return;
    }
    auto const way = yielding(bed, {get(State::ax) - held_.x, get(State::ay) - held_.y, get(State::az) - held_.z});
    double const rate = 1 / shaking_.time_step_s;
    auto const speed =
        yielding(bed, {get(State::ax_change) * rate, get(State::ay_change) * rate, get(State::az_change) * rate});
    turn_by({-way.slope_y, way.slope_x, 0});
    put(State::x, get(State::x) + way.x);
    put(State::y, get(State::y) + way.y);
    double const h = planar_.centre_height_m;
    put(State::shear_x, get(State::shear_x) + way.x - h * way.slope_x);  // of a rim: points have anchors
    put(State::shear_y, get(State::shear_y) + way.y - h * way.slope_y);
    put(State::rise, get(State::rise) + way.rise);
    auto const r = rotation();
    put(State::wx, r[3] * speed.slope_x - r[0] * speed.slope_y);
    put(State::wy, r[4] * speed.slope_x - r[1] * speed.slope_y);
    put(State::wz, r[5] * speed.slope_x - r[2] * speed.slope_y);
    put(State::vx, speed.x);
    put(State::vy, speed.y);
    put(State::vz, speed.rise);
}

}  // namespace overturn::spatial
