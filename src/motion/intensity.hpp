/// Intensity measures of a ground motion.
#pragma once

#include <span>
#include <string>

#include "motion/ground_motion.hpp"

namespace overturn {

/// Peaks are taken over the whole time of the record, not only over its samples.
struct Intensity {
    double pga_mps2 = 0;         ///< max |a|; at a sample, since a is linear between them [m/s2]
    double pgv_mps = 0;          ///< max |v|, from rest [m/s]
    double pgd_m = 0;            ///< max |d|, from rest; no baseline correction is made [m]
    double arias_mps = 0;        ///< pi / (2 g) * integral of a^2 dt, Arias (1970), g = g0 [m/s]
    double vector_pga_mps2 = 0;  ///< max length of the horizontal acceleration [m/s2]
};

/// Exact for acceleration that is linear between samples: velocity is then piecewise quadratic and displacement
/// piecewise cubic, and their extrema inside a step (roots of a and of v) count too.
/// \pre time_step_s > 0
[[nodiscard]] Intensity intensity_of(std::span<double const> acceleration_mps2, double time_step_s);
/// The same of the horizontal component; vector_pga_mps2 of both.
[[nodiscard]] Intensity intensity_of(GroundMotion const& motion);

/// Changes of the peaks of each component: "PGA -4.67 %, PGV +0.02 %, PGD +0 %; vertical PGA -9 %, PGV ...".
[[nodiscard]] std::string changes_text(GroundMotion const& from, GroundMotion const& to);

}  // namespace overturn
