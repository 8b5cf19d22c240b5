/// Makes the median response spectrum of many drawn waves meet the target, once, before any wave is drawn.
#pragma once

#include "core/shared_rows.hpp"
#include "generators/detail/noise_lines.hpp"
#include "generators/match_figures.hpp"

namespace overturn {

/// Corrects the lines' amplitudes by the median spectrum of a fixed set of draws, the same for every campaign and apart
/// from all its waves: the correction depends on the arguments alone, not on who shares the draws. Where periods are
/// long, spectra scatter most and thinned waves suffice: there the set is thirty times as large. \returns how the
/// median of fresh draws, 128 at short periods and 1000 at long ones, follows the target. Gaussian noise cannot have
/// every spectrum: the peak acceleration of RG 1.60 is a fifth too low, that of mlit-ka1 an eighth, for what longer
/// periods ask for, and no further correction mends it.
[[nodiscard]] MatchFigures calibrate(NoiseLines& lines, TargetSpectrum const& target, std::span<double const> periods_s,
                                     ShareRows const& share);

}  // namespace overturn
