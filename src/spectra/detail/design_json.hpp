/// Design spectra as the web services of the USGS answer them (ASCE 7, AASHTO): JSON.
#pragma once

#include <string>
#include <string_view>

#include "motion/pair_table.hpp"
#include "spectra/target_spectrum.hpp"

namespace overturn {

/// Does the text begin as a JSON object does?
[[nodiscard]] bool is_json(std::string_view content);

/// One spectrum of the object as a table named T (s) and Sa (g) (without a unit where no document of the USGS is named,
/// which states ordinates in g). Spectra are arrays `periods` and `ordinates` side by side, or an array of pairs whose
/// name holds "spectrum". Its text is what keys and values beside it and above it say of it, at their lines: units,
/// damping, component, quantity, factor, statistic. \param part its name; empty: the only one
/// \throws InputError at what is no JSON, without a spectrum, without that part, with several and no part, or with a
/// key twice
[[nodiscard]] PairTable table_of_design_json(std::string_view content, std::string const& name, std::string const& part,
                                             TargetKind kind);

}  // namespace overturn
