#include "spatial/spatial_block.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "spatial/detail/base_outline.hpp"

namespace overturn {
namespace {

// Along one axis of a square base, a finer bed than space holds as fine as it does; under other outlines the planar
// body stands on corners, which are not used.
BasePlan across(BasePlan base) {
    if (base.shape != BaseShape::square) {
        return {};
    }
    constexpr int most_across = BasePlan::most_across_in_space;
    static_assert(most_across * most_across <= most_spatial_points);
    base.points = std::min(base.points, most_across);
    if (base.corner_share && *base.corner_share > 0) {
        base.corner_share = std::max(*base.corner_share, flat_share(base.points));
    }
    return base;
}

spatial::BaseOutline outline_of(BasePlan const& base, ContactBlock const& planar) {
    switch (base.shape) {
        case BaseShape::round:
            return base.continuous() ? spatial::rim_outline(planar.half_width_m)
                                     : spatial::round_outline(base.points, planar.half_width_m);
        case BaseShape::polygon:
            return spatial::polygon_outline(base.corners_m);
        case BaseShape::square:
            break;
    }
    return spatial::square_outline(planar.points, planar.half_width_m);
}

double inertia_over_mass(std::optional<double> const& stated_kgm2, char const* axis, double otherwise, double mass_kg) {
    validate(!stated_kgm2 || (*stated_kgm2 > 0 && std::isfinite(*stated_kgm2)),
             "the moment of inertia about the {} axis is {} kg m2 (it must be positive). State it about the centre of "
             "gravity, or leave it out",
             axis, stated_kgm2.value_or(0));
    return stated_kgm2 ? *stated_kgm2 / mass_kg : otherwise;
}

// About each of the body's axes: springs under the base, and those along it at the arm h.
double rotation_stiffness(SpatialBlock const& block) {
    double xx = 0;
    double yy = 0;
    for (auto const& point : block.points) {
        xx += point.stiffness_share * point.x_m * point.x_m;
        yy += point.stiffness_share * point.y_m * point.y_m;
    }
    if (block.rim) {
        xx = yy = block.mean_square_m2();
    }
    double const ratio = block.planar.pad.tangential_ratio;
    double const h = block.planar.centre_height_m;
    auto const& [about_x, about_y, about_z] = block.inertia_over_mass_m2;
    return std::max({(yy + ratio * h * h) / about_x, (xx + ratio * h * h) / about_y, ratio * (xx + yy) / about_z});
}

}  // namespace

SpatialBlock spatial_block(RigidBody const& body, Footing const& footing, std::optional<Friction> const& friction) {
    SpatialBlock block;
    block.planar = contact_block(body, across(footing.base), footing.pad, friction);
    block.planar.of_rim = footing.base.shape != BaseShape::square;
    static_cast<void>(block.planar.damping());
    auto outline = outline_of(footing.base, block.planar);
    double const w = block.planar.vertical_radps();
    block.planar.yield_depth_m = footing.pad.strength_pa
                                     ? *footing.pad.strength_pa * outline.area_m2 / (body.mass_kg() * w * w)
                                     : std::numeric_limits<double>::infinity();
    double const rocking = block.planar.inertia_over_mass_m2;
    block.inertia_over_mass_m2 = {
        inertia_over_mass(footing.inertia_across_kgm2, "horizontal", rocking, body.mass_kg()), rocking,
        inertia_over_mass(footing.inertia_vertical_kgm2, "vertical", outline.polar_radius2_m2, body.mass_kg())};
    block.edge_m = outline.edge_m;
    block.rim = footing.base.continuous();
    block.reach_m = block.rim ? block.edge_m : 0;
    if (footing.base.is_disc()) {
        block.inner_m = footing.base.inner_radius_m;
    }
    validate(!block.inner_m || !footing.pad.strength_pa,
             "a disc or ring on a pad of {} Pa strength (what it crushes it would have to remember by place). State a "
             "flat square base, whose bed yields, or leave strength out",
             footing.pad.strength_pa.value_or(0));
    validate(!block.rim || !footing.pad.strength_pa,
             "a continuous rim on a pad of {} Pa strength (what it crushes it would have to remember by place). State "
             "the base's points: {}",
             footing.pad.strength_pa.value_or(0), BasePlan::points_around);
    block.points = std::move(outline.points);
    for (auto const& point : block.points) {
        block.reach_m = std::max(block.reach_m, std::hypot(point.x_m, point.y_m));
    }
    block.rotation_stiffness = rotation_stiffness(block);
    constexpr double most = 300;
    validate(block.rotation_stiffness < most,
             "the moments of inertia over the mass are {}, {} and {} m2 (so small that steps would have to be {:.0f} "
             "times shorter). State them about the centre of gravity in kg m2",
             block.inertia_over_mass_m2[0], block.inertia_over_mass_m2[1], block.inertia_over_mass_m2[2],
             block.rotation_stiffness / 3);
    return block;
}

}  // namespace overturn
