/// The similarity law between a prototype and its scale model (the paper's table 1).
#pragma once

#include <cmath>

#include "body/rigid_body.hpp"

namespace overturn {

/// Ratios model / prototype; divide by them to go from the model to the prototype. Gravity and materials are the same
/// in both, so acceleration, angle and friction have the ratio 1 and time goes with the root of length.
///
/// With the paper's factors, the defaults here, mass, inertia, stiffness and force are 0.0915, 0.0146, 0.220 and
/// 0.0897. Its table prints 0.091, 0.015, 0.216 and 0.088: no factors that round to the printed ones give its stiffness
/// and force, so they were computed from others. The factors decide here, not the printed
/// products.
struct SimilarityLaw {
    double length = 0.4;             ///< s, model length / prototype length [-]
    double mass_factor = 1.43;       ///< alpha_m: mass is this many times geometrically similar mass [-]
    double stiffness_factor = 0.55;  ///< beta: the same for longitudinal stiffness [-]

    [[nodiscard]] double time() const { return std::sqrt(length); }                     ///< s^1/2
    [[nodiscard]] double frequency() const { return 1 / std::sqrt(length); }            ///< s^-1/2
    [[nodiscard]] double velocity() const { return std::sqrt(length); }                 ///< s^1/2
    [[nodiscard]] double acceleration() const { return 1; }                             ///< 1
    [[nodiscard]] double angle() const { return 1; }                                    ///< 1
    [[nodiscard]] double friction() const { return 1; }                                 ///< 1
    [[nodiscard]] double mass() const { return mass_factor * std::pow(length, 3); }     ///< alpha_m s^3
    [[nodiscard]] double inertia() const { return mass_factor * std::pow(length, 5); }  ///< alpha_m s^5
    [[nodiscard]] double stiffness() const { return stiffness_factor * length; }        ///< longitudinal, beta s
    /// Longitudinal impact force, velocity * sqrt(mass * stiffness): (alpha_m beta)^1/2 s^5/2. (Weight goes with mass.)
    [[nodiscard]] double force() const { return std::sqrt(mass_factor * stiffness_factor) * std::pow(length, 2.5); }
};

/// The model of a prototype; restitution and gravity stay. \throws InputError unless all of the law is positive.
[[nodiscard]] BodyInput model_of(BodyInput const& prototype, SimilarityLaw const& law);

/// The prototype of a model: the inverse of model_of. \throws InputError unless all of the law is positive.
[[nodiscard]] BodyInput prototype_of(BodyInput const& model, SimilarityLaw const& law);

}  // namespace overturn
