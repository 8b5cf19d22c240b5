/// The checks that a report's page lists, by the records that verbs wrote of them.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "campaign/campaign_spec.hpp"
#include "cli/json_values.hpp"
#include "output/answer.hpp"
#include "output/package_text.hpp"
#include "results/analysis.hpp"
#include "results/statistics.hpp"
#include "store/results_file.hpp"

namespace overturn::cli {

struct CheckRecord {
    std::string name;  ///< of its file
    output::RecordKind kind = output::RecordKind::verify;
    Json content;
};

/// \throws InputError where a file cannot be read, is no record, or two are of one kind
[[nodiscard]] std::vector<CheckRecord> read_check_records(std::span<std::string const> files);

/// Adds `checks`, a row for each kind: its result, or that it was not run; and `sensitivity`, where it is recorded.
/// \throws InputError where a record of verify is of another results file
void add_checks(std::span<CheckRecord const> records, std::string const& path, store::ResultsReader const& file,
                Json& data);

/// The error of P that a record of `cost` found; none without one, or of a grid of waves. \pre add_checks took them
[[nodiscard]] std::optional<output::NumericalError> numerical_error_of(std::span<CheckRecord const> records);

/// Adds the table `hand_check` to what the page has of `overturn fit --json`; empty where no wave can be made.
void add_hand_checks(CampaignSpec const& spec, Statistics const& statistics, std::span<BodyAnalysis const> analysis,
                     Json& data);

}  // namespace overturn::cli
