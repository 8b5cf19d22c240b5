#include "rocking/detail/corner.hpp"

#include <algorithm>
#include <cmath>

namespace overturn::rocking {
namespace {

Corner symmetric_corner(RockingBlock const& block, Restoring restoring, bool limited) {
    double const alpha = block.alpha_rad;
    double const sine = std::sin(alpha);
    double const cosine = std::cos(alpha);
    double const e = block.restitution;
    Potential const potential(restoring, alpha);
    double const tips = potential.uplift_ratio();
    return {
        .alpha_rad = alpha,
        .base_angle_rad = alpha,
        .p_radps = block.p_radps,
        .restitution = e,
        .inertia_ratio = block.inertia_ratio,
        .sine_alpha = sine,
        .cosine_alpha = cosine,
        .uplift_ratio = tips,
        .hold_ratio = limited ? std::min(block.friction_static, tips) : tips,
        .base_ratio = tips,
        .r = block.inertia_ratio / (block.p_radps * block.p_radps),
        .radius_m = block.radius_m(),
        .law = {sine, cosine, 1 / block.inertia_ratio - 1, e, block.friction_static, block.friction_kinetic, sine},
        .potential = potential,
        // ImpactLaw::friction_demand, h (1 - e) / [b (1 + e)], of equal corners: with b / h as one number, tan(alpha)
        // (alpha itself of the linearised block). Last bits of the two differ, and results keep this one's.
        .impact_demand = (1 - e) / ((1 + e) * tips)};
}

Corner differing_corner(RockingBlock const& block, double side, Restoring restoring, bool limited) {
    auto const& of = block.lopsided->corners[side < 0 ? 1 : 0];
    auto one = block;
    one.alpha_rad = of.alpha_rad;
    one.p_radps = of.p_radps;
    one.restitution = of.restitution;
    one.inertia_ratio = of.inertia_ratio;
    auto corner = symmetric_corner(one, restoring, limited);
    corner.base_angle_rad = of.base_angle_rad;
    corner.base_ratio = std::tan(of.base_angle_rad);
    corner.law.sine_alpha = std::sin(of.base_angle_rad);
    corner.law.cosine_alpha = std::cos(of.base_angle_rad);
    corner.hold_ratio = limited && block.friction_static < corner.base_ratio
                            ? std::tan(std::atan(block.friction_static) - side * block.lopsided->slope_rad)
                            : corner.uplift_ratio;
    corner.reach = block.alpha_rad / of.alpha_rad;
    corner.weight = corner.radius_m / block.radius_m();
    return corner;
}

}  // namespace

std::array<Corner, 2> corners_of(RockingBlock const& block, Restoring restoring, bool limited) {
    if (!block.lopsided) {
        auto const both = symmetric_corner(block, restoring, limited);
        return {both, both};
    }
    std::array corners{differing_corner(block, 1, restoring, limited), differing_corner(block, -1, restoring, limited)};
    auto& [plus, minus] = corners;
    plus.law.sine_next = minus.law.sine_alpha * (minus.radius_m / plus.radius_m);
    minus.law.sine_next = plus.law.sine_alpha * (plus.radius_m / minus.radius_m);
    for (auto& corner : corners) {
        corner.impact_demand = corner.law.friction_demand();
    }
    return corners;
}

}  // namespace overturn::rocking
