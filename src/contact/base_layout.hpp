/// The support of a body on points: the points of its base and the compliant pad under them.
#pragma once

#include <optional>
#include <vector>

#include "body/footing.hpp"
#include "body/rigid_body.hpp"
#include "model/friction.hpp"

namespace overturn {

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
    /// Points damp as elements of a continuous rim do, of which they are samples: those of round and polygonal bases.
    bool of_rim = false;
    Pad pad;
    std::vector<ContactPoint> points;  ///< from one corner to the other

    [[nodiscard]] double vertical_radps() const;      ///< w_v = 2 pi f_v
    [[nodiscard]] double settlement_m() const;        ///< g / w_v^2
    [[nodiscard]] double approach_floor_mps() const;  ///< v_min = g / w_v: speeds below it count as this
    [[nodiscard]] double damping() const;             ///< y of the law of its points
};

/// Friction that nothing overcomes: a point that would need more slips.
inline constexpr double firm_grip = 10;

/// The least corner share that a bed of so many points has: a flat one's, 1 / (points - 1).
[[nodiscard]] double flat_share(int points);

/// The base as the rocking plane sees it: a round base's rim and a polygon's corners are projected onto it.
/// \param friction empty: firm_grip; else its kinetic coefficient: points that slip one by one and lose grip would
/// creep. Strength acts on the base area, shared like the stiffness.
/// \throws InputError, naming the quantity, for a base of fewer than two points or too many, a corner share outside
/// [1 / (points - 1), 1], or a pad without frequency, strength or a restitution in (0, 1].
[[nodiscard]] ContactBlock contact_block(RigidBody const& body, BasePlan const& base, Pad const& pad,
                                         std::optional<Friction> const& friction);

/// y of the normal law F = k d (1 + y d' / v), v the approach speed, whose flat drop rebounds with e_n: the root of
/// y - ln(1 + y) = -e_n y - ln(1 - e_n y) in (0, 1 / e_n), whatever v and k (after Hunt & Crossley 1975).
/// \throws InputError unless 0 < e_n <= 1
[[nodiscard]] double normal_damping(double normal_restitution);

}  // namespace overturn
