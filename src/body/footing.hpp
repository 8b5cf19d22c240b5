/// The support of a body: outline and bedding of its base, and the compliant pad under it. Plain data, not validated.
#pragma once

#include <array>
#include <optional>
#include <vector>

namespace overturn {

/// Square: as wide as the base in the rocking plane, in both directions. Round: of that diameter.
enum class BaseShape { square, round, polygon };

struct BasePlan {
    /// A flat bed: as many give the falls of 41 to 1.5 %, 11 give 8 % fewer, 5 a quarter fewer (type A, 1000 trials).
    /// Results files before format 5 had 11.
    static constexpr int points_across = 15, points_across_before_format_5 = 11;
    /// A round rim where it stands as points: on a pad that yields, in a plane. On 64, 128 and 256, turned or not, as
    /// many bodies fall; the way of slip under one pulse depends on the direction, up to 3.3, 1.3 and 1.2 times.
    static constexpr int points_around = 64;
    static constexpr int fewest_points_around = 16;  ///< fewer would roll from point to point
    static constexpr int most_points_around = 256;   ///< in space; a plane takes points_around at most
    static constexpr int most_points_across = 41;
    /// Points across a square bed that a body which moves in space stands on at most; a finer one counts as this.
    static constexpr int most_across_in_space = 16;

    BaseShape shape = BaseShape::square;
    /// x in the rocking plane, y across it, from the body's axis; of a polygon only, which is convex [m]
    std::vector<std::array<double, 2>> corners_m = {};
    /// w: of the stiffness, on both corners of the rocking plane together [-]. 1: corners alone. Empty: a flat, evenly
    /// bedded base, whose corners stand for half a cell each.
    std::optional<double> corner_share = 1;
    int points = points_across;  ///< evenly spread from corner to corner; of a round base round its rim, 0: continuous
    double inner_radius_m = 0;   ///< of a round base that bears evenly: what is within it does not [m]

    /// Some of the stiffness lies between the corners.
    [[nodiscard]] bool is_bed() const { return shape == BaseShape::square && corner_share != 1; }
    /// A square base that bears on its corners alone.
    [[nodiscard]] bool on_corners() const { return shape == BaseShape::square && corner_share == 1; }
    /// A round base that stands on points of its rim.
    [[nodiscard]] bool is_rim_of_points() const { return shape == BaseShape::round && points != 0; }
    /// A round base that presses along its whole rim, or with all of its face, without points and so without
    /// directions.
    [[nodiscard]] bool continuous() const { return shape == BaseShape::round && points == 0; }
    /// A continuous disc, or ring between two radii, evenly bedded; else it is the rim alone that bears.
    [[nodiscard]] bool is_disc() const { return continuous() && !corner_share; }
};

/// Body, pallet and pad as one mass on one bed of springs: an assumption.
struct Pad {
    double vertical_frequency_hz = 98;       ///< f_v, of the body on its whole base: K = m (2 pi f_v)^2
    double normal_restitution = 0.25;        ///< e_n, of one point in a flat drop, at any speed [-]
    std::optional<double> strength_pa = {};  ///< above it the pad is crushed for good; empty: it stays elastic [Pa]
    double tangential_ratio = 0.8;           ///< k_t / k; Mindlin: 2 (1 - nu) / (2 - nu)
    double tangential_damping = 0.3;         ///< zeta_t, fraction of critical
    /// Whether base and points are tuned until the body rocks with the restitution that it states.
    bool match_restitution = true;
    bool match_is_stated = false;
};

/// A base and points that rock as their body states, as nearly as any do.
struct MatchedFooting {
    BasePlan base;           ///< with the corner share that was found
    Pad pad;                 ///< with the points' restitution that was found
    double restitution = 0;  ///< that they give; not the wanted one where no base or points can give that
};

struct Footing {
    BasePlan base = {};
    Pad pad = {};
    /// Base and pad of the body under every wave, where they are known beforehand.
    std::optional<MatchedFooting> matched = {};
    /// About the horizontal axis in the rocking plane (tilting across it), and about the vertical one. Empty: as in the
    /// rocking plane, and the uniform solid of the base [kg m2]
    std::optional<double> inertia_across_kgm2 = {}, inertia_vertical_kgm2 = {};
    /// Of a continuous rim that stands as points because its pad yields.
    bool rim_as_points = false;
    /// Whether base or pad were stated at all: a body that says nothing stands on a square base on its corners.
    bool stated = false;
};

}  // namespace overturn
