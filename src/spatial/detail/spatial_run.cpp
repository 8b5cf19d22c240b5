#include "spatial/detail/spatial_run.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace overturn::spatial {
namespace {

// After the wave: nothing shakes, and energy is looked at every so many samples.
constexpr std::size_t still_samples = 8;
constexpr std::array<double, still_samples + 1> stillness{};

}  // namespace

SpatialRun::SpatialRun(SpatialBlock const& block, Excitation const& shaking, ContactAccuracy const& accuracy,
                       std::optional<SpatialStart> const& start)
    : block_(block), planar_(block.planar), shaking_(shaking) {
    auto const samples = shaking_.horizontal_mps2.size();
    last_ = samples < 2 || !(shaking_.time_step_s > 0) ? 0 : samples - 1;
    OVERTURN_EXPECT(block_.points.size() >= 4 && block_.points.size() <= most_spatial_points);
    OVERTURN_EXPECT(block_.points.size() % 2 == 0);
    auto const kind = kind_of(block_.points);
    lane_.points = kind.points;
    lane_.opposite = kind.opposite;
    fill_trial(accuracy);
    fill_points();
    place(start.value_or(SpatialStart{}));
    if (!accuracy.rest_gate || start) {
        phase_ = Phase::shaken;
        if (last_ > 0) {
            show_sample();
        }
    }
}

bool SpatialRun::advance() {
    if (!(half_tilt_sine2() < 0.5)) {
        return false;
    }
    auto index = static_cast<std::size_t>(get(State::index));
    if (phase_ == Phase::running_out) {
        bool const stopped = index < still_samples;  // lanes stopped before the end: it is quiet
        double const reached = get(State::origin) + still_samples * get(State::time_step);
        double const after = reached - static_cast<double>(last_) * shaking_.time_step_s;
        if (stopped || decided() || after > run_out_s_) {
            return false;
        }
        put(State::origin, reached);
        put(State::index, 0);
        return true;
    }
    if (phase_ == Phase::shaken && index < last_ && get(State::steps) > 0) {
        phase_ = Phase::resting;  // lanes found it quiet
        held_ = shaking_at(index);
    }
    if (phase_ == Phase::resting) {
        while (index < last_ && calm(index) && calm(index + 1)) {
            ++index;
        }
        put(State::index, static_cast<double>(index));
        if (index >= last_) {
            return false;
        }
        wake();
        return true;
    }
    if (index >= last_) {
        begin_run_out();
        return run_out_s_ > 0;
    }
    return true;
}

// Too weak for the base to part or to leave its place. Between two such samples all are: the bound is convex.
bool SpatialRun::calm(std::size_t sample) const {
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

// Of the points that touch: by pairs, as forces are summed.
SpatialRun::BedMoments SpatialRun::bed_moments() const {
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

// What resists a lean: springs less the weight that leans with them.
SpatialRun::LeanStiffness SpatialRun::lean_stiffness(BedMoments const& bed) const {
    double const falling = planar_.centre_height_m * (planar_.gravity_mps2 + held_.z);
    return {bed.xx - bed.x * bed.x / bed.k - falling, bed.xy - bed.x * bed.y / bed.k,
            bed.yy - bed.y * bed.y / bed.k - falling};
}

// To a change of the shaking.
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

// The shaking grew while the body was held: it stands where springs that still touch have let it sink, sway and lean.
void SpatialRun::wake() {
    phase_ = Phase::shaken;
    show_sample();
    if (get(State::index) == 0) {
        return;  // whatever the first sample holds comes suddenly
    }
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
    put(State::rise, get(State::rise) + way.rise);
    auto const r = rotation();
    put(State::wx, r[3] * speed.slope_x - r[0] * speed.slope_y);
    put(State::wy, r[4] * speed.slope_x - r[1] * speed.slope_y);
    put(State::wz, r[5] * speed.slope_x - r[2] * speed.slope_y);
    put(State::vx, speed.x);
    put(State::vy, speed.y);
    put(State::vz, speed.rise);
}

void SpatialRun::begin_run_out() {
    phase_ = Phase::running_out;
    if (last_ == 0) {  // no wave: free motion
        double const length = 0.01;
        double const substeps = std::ceil(length / longest_step_s_);
        put(State::time_step, length);
        put(State::step, length / substeps);
        put(State::substeps, substeps);
        put(State::inverse_substeps, 1 / substeps);
    }
    put(State::origin, static_cast<double>(last_) * shaking_.time_step_s);
    put(State::index, 0);
    put(State::last, still_samples);
    for (auto const wave : {Wave::x, Wave::y, Wave::z}) {
        lane_.body.at(wave, 0) = stillness.data();
    }
    for (auto const field :
         {State::ax, State::ax_change, State::ay, State::ay_change, State::az, State::az_change, State::substep}) {
        put(field, 0);
    }
    put(State::quiet_energy, quiet_energy());
}

// A body that can neither fall nor swing higher than it did. One that has slipped may slip on: it is followed until
// it rests.
bool SpatialRun::decided() const {
    if (slipped()) {
        return false;
    }
    double const b = block_.edge_m;
    double const h = planar_.centre_height_m;
    double const radius = std::hypot(b, h);
    double const alpha = std::atan2(b, h);
    double const tilt = 2 * std::asin(std::sqrt(half_tilt_sine2()));
    constexpr double safe = 0.99;  // soft corners lower the top by a few settlements; crushed ones by what is gone
    double const energy = mechanical_energy() / (planar_.gravity_mps2 * radius) + deepest_crush() / radius;
    if (energy > safe * (1 - std::cos(alpha)) || tilt >= alpha) {
        return false;
    }
    double const turning = alpha - std::acos(std::min(1.0, energy + std::cos(alpha)));
    return turning <= 2 * std::asin(std::sqrt(get(State::most_tilt)));
}

}  // namespace overturn::spatial
