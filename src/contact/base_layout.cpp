#include "contact/base_layout.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/detail/contact_step.hpp"
#include "contact/detail/rim_law.hpp"
#include "core/error.hpp"

namespace overturn {
namespace {

void validate_pad(Pad const& pad) {
    validate(pad.vertical_frequency_hz > 0 && std::isfinite(pad.vertical_frequency_hz),
             "the pad's vertical frequency is {} Hz (it must be above 0). State the measured one",
             pad.vertical_frequency_hz);
    validate(!pad.strength_pa || *pad.strength_pa > 0,
             "the pad's strength is {} Pa (a pad without strength bears nothing). Leave it out for an elastic pad",
             pad.strength_pa.value_or(0));
    validate(pad.tangential_ratio > 0 && std::isfinite(pad.tangential_ratio),
             "the pad's tangential ratio is {} (it must be above 0). Take 0.8", pad.tangential_ratio);
    validate(pad.tangential_damping >= 0 && std::isfinite(pad.tangential_damping),
             "the pad's tangential damping is {} (it must be at least 0). Take 0.3", pad.tangential_damping);
}

// A rim as the rocking plane sees it: points on either side of the plane coincide in pairs, as one of twice the share.
std::vector<ContactPoint> rim(int around, double radius_m) {
    validate(
        around >= BasePlan::fewest_points_around && around <= BasePlan::most_points_around && around % 4 == 0,
        "a round base of {} points (it takes {} to {}, a multiple of 4). Leave them out: its rim is then continuous",
        around, BasePlan::fewest_points_around, BasePlan::most_points_around);
    around = std::min(around, BasePlan::points_around);
    std::vector<ContactPoint> points;
    for (int i = around / 2; i >= 0; --i) {
        bool const edge = i == 0 || i == around / 2;
        // Exactly on the axis where a cosine would only be small.
        double const cosine = 4 * i == around ? 0 : std::cos(2 * pi * i / around);
        points.push_back({radius_m * cosine, (edge ? 1.0 : 2.0) / around});
    }
    return points;
}

double area(BasePlan const& base, double half_width_m) {
    double const square = 4 * half_width_m * half_width_m;
    return base.shape == BaseShape::round ? square * (pi / 4) : square;
}

std::vector<ContactPoint> layout(BasePlan const& base, double half_width_m) {
    validate(base.shape != BaseShape::polygon, "a polygonal base (it has no bed in a plane). Simulate it in space");
    if (base.shape == BaseShape::round) {
        return rim(base.continuous() ? BasePlan::points_around : base.points, half_width_m);
    }
    validate(base.points >= 2 && base.points <= contact::most_points,
             "a base of {} points (it takes 2 to {}). Take 2 for corners, 15 for a flat bed", base.points,
             contact::most_points);
    double const flat = flat_share(base.points);
    double const share = base.corner_share.value_or(flat);
    constexpr double slack = 1e-12;
    validate(share >= flat * (1 - slack) && share <= 1,
             "the corners' share of the stiffness is {} (a base of {} points takes {} to 1; 1 is corners alone). State "
             "one of these",
             share, base.points, flat);
    int const count = share == 1 ? 2 : base.points;
    std::vector<ContactPoint> points;
    for (int i = 0; i < count; ++i) {
        bool const corner = i == 0 || i == count - 1;
        points.push_back(
            {half_width_m * (2 * i - (count - 1)) / (count - 1), corner ? share / 2 : (1 - share) / (count - 2)});
    }
    return points;
}

}  // namespace

double ContactBlock::vertical_radps() const { return 2 * pi * pad.vertical_frequency_hz; }
double ContactBlock::settlement_m() const { return gravity_mps2 / (vertical_radps() * vertical_radps()); }
double ContactBlock::approach_floor_mps() const { return gravity_mps2 / vertical_radps(); }
double ContactBlock::damping() const {
    return of_rim ? rim_damping(pad.normal_restitution) : normal_damping(pad.normal_restitution);
}

double flat_share(int points) { return 1.0 / (points - 1); }

ContactBlock contact_block(RigidBody const& body, BasePlan const& base, Pad const& pad,
                           std::optional<Friction> const& friction) {
    validate_pad(pad);
    ContactBlock block{.half_width_m = body.half_width_m(),
                       .centre_height_m = body.centre_height_m(),
                       .inertia_over_mass_m2 = body.inertia_kgm2() / body.mass_kg(),
                       .gravity_mps2 = body.gravity_mps2(),
                       .friction = friction ? friction->kinetic_coefficient : firm_grip,
                       .yield_depth_m = std::numeric_limits<double>::infinity(),
                       .of_rim = base.shape == BaseShape::round,
                       .pad = pad,
                       .points = layout(base, body.half_width_m())};
    static_cast<void>(block.damping());
    double bed = 0;  // against turning, over the stiffness
    for (auto const& point : block.points) {
        bed += point.stiffness_share * point.offset_m * point.offset_m;
    }
    if (base.is_disc()) {
        double const inner = base.inner_radius_m;
        validate(
            inner >= 0 && inner < body.half_width_m(),
            "a ring of {} m within, {} m without (of radius: nothing is left that bears). Lower the inner diameter",
            inner, body.half_width_m());
        bed = (body.half_width_m() * body.half_width_m() + inner * inner) / 4;
    }
    double const w = block.vertical_radps();
    // At 1 the springs no longer hold the body upright against its own weight. Empirical: how near to that the model
    // still means something was not measured.
    constexpr double upright_margin = 1.2;
    validate(w * w * bed > upright_margin * block.gravity_mps2 * block.centre_height_m,
             "a body of alpha {:.2g} rad on a pad of {} Hz (so soft a bed hardly holds so slender a body upright). "
             "Check its "
             "base width and centre height, or state the measured vertical frequency",
             body.alpha_rad(), pad.vertical_frequency_hz);
    double const weight = body.mass_kg() * block.gravity_mps2;
    validate(!pad.strength_pa || *pad.strength_pa * area(base, body.half_width_m()) > 2 * weight,
             "the pad's strength is {} Pa (a corner could not bear the body's weight). State it with its unit: 30 MPa",
             pad.strength_pa.value_or(0));
    if (pad.strength_pa) {
        block.yield_depth_m = *pad.strength_pa * area(base, body.half_width_m())
                              / (body.mass_kg() * block.vertical_radps() * block.vertical_radps());
    }
    return block;
}

double normal_damping(double normal_restitution) {
    double const e = normal_restitution;
    validate(e > 0 && e <= 1, "a point's restitution of {} (it must lie above 0 and be at most 1). Take 0.25", e);
    if (e == 1) {
        return 0;
    }
    double low = 0;
    double high = 1 / e;
    for (int i = 0; i < 200 && std::nextafter(low, high) < high; ++i) {
        double const y = low + (high - low) / 2;
        double const left = y - std::log1p(y);
        double const right = -e * y - std::log1p(-e * y);
        (left > right ? low : high) = y;
    }
    return low;
}

}  // namespace overturn
