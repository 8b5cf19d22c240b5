/// Outlines of bases: where their points are, what each bears, and what the solid above them is.
#pragma once

#include "spatial/spatial_block.hpp"

namespace overturn::spatial {

struct BaseOutline {
    std::vector<SpatialPoint> points;  ///< in pairs, as SpatialBlock has them
    double area_m2 = 0;
    double edge_m = 0;            ///< from the axis to the nearest edge
    double polar_radius2_m2 = 0;  ///< mean squared distance from the axis: I_z / m of the uniform solid
};

/// \param row the planar layout across it
[[nodiscard]] BaseOutline square_outline(std::vector<ContactPoint> const& row, double half_width_m);
/// Without points.
[[nodiscard]] BaseOutline rim_outline(double radius_m);
[[nodiscard]] BaseOutline round_outline(int points, double radius_m);
/// \throws InputError as spatial_block does
[[nodiscard]] BaseOutline polygon_outline(std::vector<std::array<double, 2>> const& corners_m);

}  // namespace overturn::spatial
