/// Names in a results file, in this program's terms. Files of programs with more or fewer columns, verdicts and models
/// stay readable, because names are compared and never places or numbers.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "campaign/campaign_spec.hpp"
#include "model/verdict.hpp"
#include "store/results_file.hpp"

namespace overturn {

/// The verdicts of the file's trials by name. One that this program does not know has the value of a known verdict that
/// means the same: overturned where the body fell, contact-lost where it is not decided, else rocked or at rest (from
/// the attributes `fell`, `decided` and `moved` of /trials/verdict; not decided where they are missing).
[[nodiscard]] std::vector<Category> verdicts_in(store::ResultsReader const& file);

/// Verdicts that this program does not know, each with the value of the verdict that it counts as.
[[nodiscard]] std::vector<Category> unknown_verdicts(store::ResultsReader const& file);

/// A model that answered trials of the file and is not known to this program.
struct UnknownModel {
    std::string name;
    std::int64_t trials = 0;  ///< that count under no model
};
[[nodiscard]] std::vector<UnknownModel> unknown_models(store::ResultsReader const& file);

/// Columns that this program does not know, by path: they are kept, and nothing is made of them. Those of /trials,
/// models' own among them, /waves and /waves/<body> follow from the campaign, those of results from the page of
/// columns.
[[nodiscard]] std::vector<std::string> unknown_columns(store::ResultsReader const& file, CampaignSpec const& spec);

/// Those of results alone, which need no campaign.
[[nodiscard]] std::vector<std::string> unknown_columns_of_results(store::ResultsReader const& file);

/// Columns of /trials, models' own among them, /waves and /waves/<body> that this program would write and the file does
/// not have, by path.
[[nodiscard]] std::vector<std::string> absent_columns(store::ResultsReader const& file, CampaignSpec const& spec);

/// A column of numbers; NaN for each of so many rows where the file does not have it.
[[nodiscard]] std::vector<double> reals_or_unknown(store::ResultsReader const& file, std::string const& column,
                                                   std::size_t rows);

/// Verdict of each trial, in the order of /trials.
[[nodiscard]] std::vector<Verdict> stored_verdicts(store::ResultsReader const& file);

/// /trials as trial_table has it, with the verdicts of the file.
[[nodiscard]] store::TableSpec stored_trial_table(store::ResultsReader const& file, CampaignSpec const& spec);

/// The columns of a table that the file has.
[[nodiscard]] store::TableSpec held_in(store::ResultsReader const& file, store::TableSpec table);

}  // namespace overturn
