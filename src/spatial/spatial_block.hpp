/// A body on the points of its base, in space.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "body/footing.hpp"
#include "contact/base_layout.hpp"

namespace overturn {

/// Points of a base at most: a flat square bed of 16 x 16, a rim or a polygon of 256.
inline constexpr int most_spatial_points = 256;
/// Least number of points on a rim: fewer would give it directions of its own.
inline constexpr int fewest_rim_points = BasePlan::fewest_points_around;

struct SpatialPoint {
    double x_m = 0, y_m = 0;     ///< from the body's axis
    double stiffness_share = 0;  ///< k / K
};

/// A body on its pad in space, as the equations need it. Made by spatial_block.
struct SpatialBlock {
    /// The same body in its rocking plane: sizes, gravity, friction, pad. Its points are not used; its half width is
    /// the base's own along x.
    ContactBlock planar;
    std::array<double, 3> inertia_over_mass_m2{};  ///< about the body's own axes x, y (rocking) and z
    double edge_m = 0;   ///< from the axis to the nearest edge: over it the body falls easiest
    double reach_m = 0;  ///< to the farthest point
    /// A continuous base of the radius edge_m = reach_m, which presses along its rim, or evenly within it: it has no
    /// points.
    bool rim = false;
    /// Of a continuous base that bears evenly from this radius on, a disc where it is 0; empty: on its rim alone.
    std::optional<double> inner_m = {};
    /// Stiffness of the quickest rotation on all points, over its inertia and w_v^2; at most 3 for uniform solids.
    double rotation_stiffness = 0;
    /// An even number, in pairs: opposite ones of a symmetric base are neighbours. One that has no partner stands as
    /// two of half its stiffness.
    std::vector<SpatialPoint> points;

    /// Of a continuous base: second moment of its stiffness about a diameter, over the stiffness.
    [[nodiscard]] double mean_square_m2() const {
        return inner_m ? (edge_m * edge_m + *inner_m * *inner_m) / 4 : edge_m * edge_m / 2;
    }
};

/// Square: the planar layout in x times that in y (of 16 points at most), so that it looks along either axis like the
/// planar bed. Round: a continuous rim, disc or ring, or equal points round it where their number is stated. Polygon:
/// its corners, with the shares nearest to equal ones that keep the weight on the axis. Inertia about y is the body's;
/// about x the same and about z the uniform solid of the base unless stated. Strength acts on the base's area, shared
/// like the stiffness. \param friction empty: firm_grip \throws InputError for what contact_block refuses; a continuous
/// base on a pad that yields; a rim of fewer than fewest_rim_points; more than most_spatial_points; a polygon of fewer
/// than three corners, not convex, without the axis inside, or with a corner that would have to pull; inertia that is
/// not positive, or so small that the body would shiver on its points a hundred times quicker than a uniform solid
[[nodiscard]] SpatialBlock spatial_block(RigidBody const& body, Footing const& footing,
                                         std::optional<Friction> const& friction);

}  // namespace overturn
