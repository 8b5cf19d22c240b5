/// How a trial is set up, and what a corner lends to the equations. Part of rocking_integrator.hpp.
#pragma once

#include "rocking/detail/rocking_integrator.hpp"

namespace overturn::rocking {

template <int Order, class Restoring, bool Vertical, Slip Friction>
Integrator<Order, Restoring, Vertical, Friction>::Integrator(RockingBlock const& block, Excitation const& shaking,
                                                             RockingAccuracy const& accuracy, RockingObserver* observer)
    : block_(block),
      shaking_(shaking),
      accuracy_(accuracy),
      lopsided_(block.lopsided.has_value()),
      incline_(lopsided_ ? Incline{std::sin(block.lopsided->slope_rad), std::cos(block.lopsided->slope_rad)}
                         : Incline{}),
      corner_(corner_of(block)),
      top_(Restoring::top(block.alpha_rad)),
      hold_friction_(block.friction_static * (1 + 1e-13)),
      log_(top_, observer) {
    if (lopsided_) {
        auto const& [at_plus, at_minus] = block.lopsided->corners;
        corners_ = {corner_of(block, at_plus, 1), corner_of(block, at_minus, -1)};
        corners_[0].law.sine_next = corners_[1].law.sine_alpha * (corners_[1].radius_m / corners_[0].radius_m);
        corners_[1].law.sine_next = corners_[0].law.sine_alpha * (corners_[0].radius_m / corners_[1].radius_m);
        stand_on(side_);
    }
}

template <int Order, class Restoring, bool Vertical, Slip Friction>
auto Integrator<Order, Restoring, Vertical, Friction>::corner_of(RockingBlock const& block) -> Corner {
    double const alpha = block.alpha_rad;
    double const tips = Restoring::uplift_ratio(alpha);
    double const sine = std::sin(alpha);
    double const cosine = std::cos(alpha);
    return {alpha,
            alpha,
            block.p_radps,
            block.restitution,
            block.inertia_ratio,
            sine,
            cosine,
            tips,
            limited ? std::min(block.friction_static, tips) : tips,
            tips,
            block.inertia_ratio / (block.p_radps * block.p_radps),
            block.radius_m(),
            {sine, cosine, 1 / block.inertia_ratio - 1, block.restitution, block.friction_static,
             block.friction_kinetic, sine}};
}

template <int Order, class Restoring, bool Vertical, Slip Friction>
auto Integrator<Order, Restoring, Vertical, Friction>::corner_of(RockingBlock const& block, RockingCorner const& corner,
                                                                 double side) -> Corner {
    auto one = block;
    one.alpha_rad = corner.alpha_rad;
    one.p_radps = corner.p_radps;
    one.restitution = corner.restitution;
    one.inertia_ratio = corner.inertia_ratio;
    auto made = corner_of(one);
    made.base_angle_rad = corner.base_angle_rad;
    made.base_ratio = std::tan(corner.base_angle_rad);
    made.law.sine_alpha = std::sin(corner.base_angle_rad);
    made.law.cosine_alpha = std::cos(corner.base_angle_rad);
    if (limited && block.friction_static < made.base_ratio) {
        made.hold_ratio = std::tan(std::atan(block.friction_static) - side * block.lopsided->slope_rad);
    } else {
        made.hold_ratio = made.uplift_ratio;
    }
    made.side = side;
    made.reach = block.alpha_rad / corner.alpha_rad;
    made.weight = made.radius_m / block.radius_m();
    return made;
}

}  // namespace overturn::rocking
