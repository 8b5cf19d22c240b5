/// Assumptions of a campaign, as text and as JSON.
#pragma once

#include <string>

#include "campaign/assumptions.hpp"
#include "cli/json_values.hpp"

namespace overturn::cli {

/// The table of model assumptions; with a campaign, only those that bear on it.
[[nodiscard]] std::string model_assumptions_text();
[[nodiscard]] Json model_assumptions_json();

/// counts; inputs, assumed ones first, each with basis, source, range and place; model, with `bears`: all,
/// where-not-called-for or none.
[[nodiscard]] Json assumptions_json(CampaignSpec const& spec);

/// The lines of `plan`: counts, what is assumed and what is not stated, and which of the model's assumptions are
/// unsafe. \param full every assumed value with its source, in place of the first keys
[[nodiscard]] std::string assumptions_lines(CampaignSpec const& spec, bool full);

}  // namespace overturn::cli
