/// Residual velocity and displacement at the end of a recorded motion. The ground has come to rest by then, so it is
/// the record's baseline that drifts, and PGV and PGD drift with it.
#pragma once

#include <string>
#include <vector>

#include "motion/ground_motion.hpp"

namespace overturn {

/// Symbols of units for texts of a motion.
struct MotionUnits {
    std::string velocity = "m/s", length = "m";
};

/// Residuals of the horizontal component, from rest.
struct Drift {
    double pgv_mps = 0;              ///< [m/s]
    double pgd_m = 0;                ///< [m]
    double end_velocity_mps = 0;     ///< [m/s]
    double end_displacement_m = 0;   ///< [m]
    double factor = 1;               ///< by which the record was multiplied
    std::string component = {};      ///< "": horizontal
    std::vector<Drift> others = {};  ///< of other components, those that are excessive

    /// |end velocity| over PGV; 0 where nothing moves.
    [[nodiscard]] double share() const;
    /// True if more than 5 % of PGV is left, or PGD, unscaled, is beyond 15 m: PGV and PGD are then the baseline's as
    /// much as the ground's.
    [[nodiscard]] bool excessive() const;
    /// True if that, or another component, is.
    [[nodiscard]] bool any_excessive() const { return excessive() || !others.empty(); }
    /// "ends at 0.012 m/s (3.1 % of its PGV), 0.32 m from where it began; its vertical component ends at ..."
    [[nodiscard]] std::string text(MotionUnits const& units = {}) const;
};

/// \param factor by which the record was multiplied
[[nodiscard]] Drift drift_of(GroundMotion const& motion, double factor = 1);

}  // namespace overturn
