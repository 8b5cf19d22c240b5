/// Figures of the match of a wave's spectrum to its target, as standards define them.
#pragma once

#include <span>

#include "spectra/target_spectrum.hpp"

namespace overturn {

/// Statistics of computed/target over periods in equal ratios; all 0 where there is nothing to compare.
struct MatchFigures {
    double mean_misfit = 0;          ///< mean |ratio - 1| [-]
    double max_misfit = 0;           ///< largest |ratio - 1| [-]
    double max_misfit_period_s = 0;  ///< where [s]
    double mean_ratio = 0;           ///< [-]
    double cov = 0;                  ///< standard deviation of the ratio over its mean [-]
    double below_fraction = 0;       ///< share of periods where the wave stays below its target [-]
    double lowest_ratio = 0;         ///< [-]
    double lowest_period_s = 0;      ///< where [s]
    double highest_ratio = 0;        ///< [-]
    double highest_period_s = 0;     ///< where [s]
    int longest_below = 0;           ///< most adjacent periods below the target
    double longest_below_to_s = 0;   ///< the longest of them [s]
};

/// Figures of computed/target ratios at periods within [from, to].
[[nodiscard]] MatchFigures match_figures(std::span<double const> periods_s, std::span<double const> ratios,
                                         double from_s, double to_s);

/// The largest mean |ratio - 1| over any decade of periods, or over all where they span less. [T0, T1] of a rocking
/// body is a decade, wherever it lies.
[[nodiscard]] double worst_decade_misfit(std::span<double const> periods_s, std::span<double const> ratios);

/// Spectral intensity of the wave over that of the target, int psv dT over 0.1 s to 2.5 s (Housner 1952; trapezoids
/// between the periods given); 0 where they do not reach that far.
[[nodiscard]] double spectral_intensity_ratio(std::span<double const> periods_s, std::span<double const> ratios,
                                              TargetSpectrum const& target);

}  // namespace overturn
