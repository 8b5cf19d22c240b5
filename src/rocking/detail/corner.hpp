/// The two base corners as the equations see them: angles, frequency, what lifts the block or holds it, impact law and
/// potential.
#pragma once

#include <array>

#include "rocking/detail/impact_law.hpp"
#include "rocking/detail/potential.hpp"
#include "rocking/planar_rocking.hpp"

namespace overturn::rocking {

struct Corner {
    double alpha_rad, base_angle_rad, p_radps, restitution, inertia_ratio;
    double sine_alpha, cosine_alpha;
    double uplift_ratio;  ///< tan(alpha)
    double hold_ratio;    ///< |a| / gv up to which the block neither tips towards it nor slides
    double base_ratio;    ///< b / h: friction below it slides and never tips
    double r, radius_m;   ///< R / g [s2], R
    ImpactLaw law;
    Potential potential;
    double impact_demand;  ///< |P_x| / P_z of an impact that leaves it, after which the other one sticks
    double reach = 1;      ///< the weaker corner's alpha over this one's
    double weight = 1;     ///< this corner's m g R over the weaker one's
};

/// At +x and at -x. \param limited friction has a limit that is looked at
[[nodiscard]] std::array<Corner, 2> corners_of(RockingBlock const& block, Restoring restoring, bool limited);

}  // namespace overturn::rocking
