/// Who made a results file, and why a stored row may not be what this program computes.
#pragma once

#include <string>

#include "store/results_file.hpp"

namespace overturn::output {

/// Compiled from the sources that made the file?
[[nodiscard]] bool is_of_this_program(store::ResultsReader const& file);

/// "overturn 1.0.0 (f46588f980a6, sources 1b2c3d4e5f60)"
[[nodiscard]] std::string maker_of(store::ResultsReader const& file);

/// "(made by overturn 1.0.0, revision abc; this is def). Ask that program": as the end of a message.
[[nodiscard]] std::string why_bits_differ(store::ResultsReader const& file);

}  // namespace overturn::output
