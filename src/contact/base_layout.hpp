/// What a body stands on: the points of its base and the compliant pad under them.
#pragma once

#include <optional>
#include <vector>

#include "body/rigid_body.hpp"
#include "model/friction.hpp"

namespace overturn {

/// How the stiffness is shared along the base. 1: two corners alone. 1 / (points - 1): a flat, evenly bedded base,
/// whose corners stand for half a cell each.
struct ContactBase {
    double corner_share = 1;  ///< w: of the stiffness, on both corners together [-]
    int points = 11;          ///< evenly spread from corner to corner; below 11 a physical parameter of its own

    /// The share that makes a flat base of so many points.
    [[nodiscard]] static double flat_share(int points) { return 1.0 / (points - 1); }
};

/// Body, pallet and pad as one mass on one bed of springs: an assumption.
struct ContactPad {
    double vertical_frequency_hz = 98;       ///< f_v, of the body on its whole base: K = m (2 pi f_v)^2
    double normal_restitution = 0.25;        ///< e_n, of one point in a flat drop, at any speed [-]
    std::optional<double> strength_pa = {};  ///< above it the pad is crushed for good; empty: it stays elastic [Pa]
    double tangential_ratio = 0.8;           ///< k_t / k; Mindlin: 2 (1 - nu) / (2 - nu)
    double tangential_damping = 0.3;         ///< zeta_t, fraction of critical
};

struct ContactPoint {
    double offset_m = 0;         ///< X, from the body's axis
    double stiffness_share = 0;  ///< k / K
};

/// A body on its pad, as the equations need it. Made by contact_block.
struct ContactBlock {
    double half_width_m = 0;          ///< b
    double centre_height_m = 0;       ///< h
    double inertia_over_mass_m2 = 0;  ///< I_G / m
    double gravity_mps2 = g0;
    double friction = 0;       ///< mu, of every point, at rest and in motion
    double yield_depth_m = 0;  ///< depth at which the pad yields; infinite: never
    ContactPad pad;
    std::vector<ContactPoint> points;  ///< from one corner to the other

    [[nodiscard]] double vertical_radps() const;      ///< w_v = 2 pi f_v
    [[nodiscard]] double settlement_m() const;        ///< g / w_v^2
    [[nodiscard]] double approach_floor_mps() const;  ///< v_min = g / w_v: speeds below it count as this
};

/// Friction that nothing overcomes: a point that would need more slips.
inline constexpr double firm_grip = 10;

/// \param friction empty: firm_grip; else its kinetic coefficient: points that slip one by one and lose grip would
/// creep. \param base_depth_m across the rocking plane; 0: as wide as the base. Strength acts on the base area, shared
/// like the stiffness.
/// \throws InputError, naming the quantity, for a base of fewer than two points or too many, a corner share outside
/// [1 / (points - 1), 1], or a pad without frequency, strength or a restitution in (0, 1].
[[nodiscard]] ContactBlock contact_block(RigidBody const& body, ContactBase const& base, ContactPad const& pad,
                                         std::optional<Friction> const& friction, double base_depth_m = 0);

/// y of the normal law F = k d (1 + y d' / v), v the approach speed, whose flat drop rebounds with e_n: the root of
/// y - ln(1 + y) = -e_n y - ln(1 - e_n y) in (0, 1 / e_n), whatever v and k (after Hunt & Crossley 1975).
/// \throws InputError unless 0 < e_n <= 1
[[nodiscard]] double normal_damping(double normal_restitution);

}  // namespace overturn
