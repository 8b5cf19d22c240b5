/// Names in a results file of another program that this one does not know, in words.
#pragma once

#include <string>
#include <vector>

#include "store/results_file.hpp"

namespace overturn::output {

/// "verdict 'crushed' is not known to this program: its trials count as rocked", "model 'tether' is not known to this
/// program: its 3 trials count under no model": a line of verdicts and one of models, where there are such.
[[nodiscard]] std::vector<std::string> unknown_names_text(store::ResultsReader const& file);

}  // namespace overturn::output
