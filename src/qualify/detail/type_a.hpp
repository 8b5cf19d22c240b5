/// The body that several known answers are of.
#pragma once

#include "body/rigid_body.hpp"

namespace overturn::qualify {

/// Cask and pallet of type A at model scale, of one density (campaigns/bodies/type_a_model.toml).
[[nodiscard]] inline RigidBody type_a() {
    constexpr double mass = 12.6e3, half_width = 0.68, height = 1.045;
    return RigidBody({.mass_kg = mass,
                      .half_width_m = half_width,
                      .centre_height_m = height,
                      .inertia_kgm2 = mass * (half_width * half_width + height * height) / 3});
}

}  // namespace overturn::qualify
