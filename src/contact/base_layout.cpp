#include "contact/base_layout.hpp"

#include <cmath>
#include <limits>

#include "contact/detail/pressing.hpp"
#include "core/error.hpp"

namespace overturn {
namespace {

void validate_pad(ContactPad const& pad) {
    validate(pad.vertical_frequency_hz > 0 && std::isfinite(pad.vertical_frequency_hz),
             "the pad's vertical frequency is {} Hz (it must be above 0) state the measured one",
             pad.vertical_frequency_hz);
    validate(!pad.strength_pa || *pad.strength_pa > 0,
             "the pad's strength is {} Pa (a pad without strength bears nothing) leave it out for an elastic pad",
             pad.strength_pa.value_or(0));
    validate(pad.tangential_ratio > 0 && std::isfinite(pad.tangential_ratio),
             "the pad's tangential ratio is {} (it must be above 0) take 0.8", pad.tangential_ratio);
    validate(pad.tangential_damping >= 0 && std::isfinite(pad.tangential_damping),
             "the pad's tangential damping is {} (it must be at least 0) take 0.3", pad.tangential_damping);
}

std::vector<ContactPoint> layout(ContactBase const& base, double half_width_m) {
    validate(base.points >= 2 && base.points <= contact::most_points,
             "a base of {} points (it takes 2 to {}) take 2 for corners, 11 for a flat bed", base.points,
             contact::most_points);
    double const flat = ContactBase::flat_share(base.points);
    constexpr double slack = 1e-12;
    validate(base.corner_share >= flat * (1 - slack) && base.corner_share <= 1,
             "the corners' share of the stiffness is {} (a base of {} points takes {} to 1) 1 is corners alone",
             base.corner_share, base.points, flat);
    int const count = base.corner_share == 1 ? 2 : base.points;
    std::vector<ContactPoint> points;
    for (int i = 0; i < count; ++i) {
        bool const corner = i == 0 || i == count - 1;
        points.push_back({half_width_m * (2 * i - (count - 1)) / (count - 1),
                          corner ? base.corner_share / 2 : (1 - base.corner_share) / (count - 2)});
    }
    return points;
}

}  // namespace

double ContactBlock::vertical_radps() const { return 2 * pi * pad.vertical_frequency_hz; }
double ContactBlock::settlement_m() const { return gravity_mps2 / (vertical_radps() * vertical_radps()); }
double ContactBlock::approach_floor_mps() const { return gravity_mps2 / vertical_radps(); }

ContactBlock contact_block(RigidBody const& body, ContactBase const& base, ContactPad const& pad,
                           std::optional<Friction> const& friction, double base_depth_m) {
    validate_pad(pad);
    static_cast<void>(normal_damping(pad.normal_restitution));
    double const width = 2 * body.half_width_m();
    double const area = width * (base_depth_m > 0 ? base_depth_m : width);
    ContactBlock block{.half_width_m = body.half_width_m(),
                       .centre_height_m = body.centre_height_m(),
                       .inertia_over_mass_m2 = body.inertia_kgm2() / body.mass_kg(),
                       .gravity_mps2 = body.gravity_mps2(),
                       .friction = friction ? friction->kinetic_coefficient : firm_grip,
                       .yield_depth_m = std::numeric_limits<double>::infinity(),
                       .pad = pad,
                       .points = layout(base, body.half_width_m())};
    if (pad.strength_pa) {
        block.yield_depth_m =
            *pad.strength_pa * area / (body.mass_kg() * block.vertical_radps() * block.vertical_radps());
    }
    return block;
}

double normal_damping(double normal_restitution) {
    double const e = normal_restitution;
    validate(e > 0 && e <= 1, "a point's restitution of {} (it must lie above 0 and be at most 1) take 0.25", e);
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
