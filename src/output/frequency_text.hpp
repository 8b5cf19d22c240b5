/// Annual frequencies for the terminal.
#pragma once

#include <span>
#include <string>

#include "results/hazard_frequency.hpp"

namespace overturn::output {

/// "type-a", or with the limit state where it is not overturning: "type-a, slides".
[[nodiscard]] std::string frequency_name(BodyFrequency const& f);

/// Notes on an annual frequency: its parts without trials or hazard, its limits, and how to learn more.
[[nodiscard]] std::vector<std::string> frequency_notes(BodyFrequency const& f, HazardCurve const& hazard);

/// "6 points from 0.05 g (0.01 1/a) to 2 g (3e-07 1/a)".
[[nodiscard]] std::string range_text(HazardCurve const& hazard);

/// Intensities in the unit that the hazard curve states, with what lies outside what was tried or stated.
[[nodiscard]] std::string frequency_text(std::span<BodyFrequency const> frequencies, HazardCurve const& hazard,
                                         double confidence);

}  // namespace overturn::output
