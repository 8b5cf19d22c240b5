/// Why a stored row may not be what this program computes.
#pragma once

#include <string>

#include "store/results_file.hpp"

namespace overturn::cli {

/// "(made by overturn 0.1.0, revision abc; this is def). Ask that program": as the end of a message.
[[nodiscard]] std::string why_bits_differ(store::ResultsReader const& file);

}  // namespace overturn::cli
