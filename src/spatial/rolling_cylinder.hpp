/// The rigid limit of a body on its round rim: a cylinder that rolls on its edge without slip.
#pragma once

#include <array>

#include "spatial/spatial_motion.hpp"

namespace overturn {

/// Newton's and Euler's equations of a cylinder whose lowest point does not slip (Srinivasan and Ruina 2008). Either
/// it pivots on that point freely, or, as on a rim that adheres all along its contact, it does not turn about the
/// vertical at all.
struct RollingCylinder {
    double radius_m = 0, centre_height_m = 0;
    double across_m2 = 0, about_m2 = 0;  ///< moments of inertia through the centre of gravity, over the mass
    double gravity_mps2 = 0;
    bool pivots = true;

    /// Tilt [rad], its rate, azimuth of precession [rad], its rate, angular velocity about the axis [rad/s].
    using State = std::array<double, 5>;
    /// Its spin if it does not pivot: -psi' sin^2(theta) / cos(theta). [rad/s]
    [[nodiscard]] static double spin_without_pivoting(double tilt_rad, double precession_radps);
    /// At which its tilt does not change, if it spins at 0 (pivots) or does not pivot. \pre the weight rights it
    /// [rad/s]
    [[nodiscard]] double steady_precession_radps(double tilt_rad) const;
    [[nodiscard]] State rate(State const& state) const;
    /// Runge-Kutta of fourth order by steps of 0.1 ms.
    [[nodiscard]] State after(State state, double seconds) const;
};

[[nodiscard]] RollingCylinder rolling_cylinder(SpatialBlock const& block, bool pivots = true);

/// A body on its rim that precesses about its lowest point, with this angular velocity about its axis, as deep as it
/// bears what rolling presses. \pre the base is a rim; 0 < tilt_rad < pi / 2
[[nodiscard]] SpatialStart rolling_start(SpatialBlock const& block, double tilt_rad, double precession_radps,
                                         double spin_radps = 0);

}  // namespace overturn
