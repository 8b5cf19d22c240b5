/// Text of a report's page as a calculation package: its question, its method, and the checks that were made.
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "campaign/campaign_spec.hpp"
#include "output/json.hpp"
#include "results/hand_check.hpp"

namespace overturn::output {

/// The campaign's own question, or one made of its bodies and levels.
[[nodiscard]] std::string question_text(CampaignSpec const& spec);

/// Method of the calculation and what it leaves out, a sentence each.
[[nodiscard]] std::vector<std::string> method_lines(CampaignSpec const& spec);

/// The calculation by hand: its method, then a line for each body; empty without checks.
[[nodiscard]] std::vector<std::string> hand_check_lines(CampaignSpec const& spec, std::span<HandCheck const> checks);

/// Who prepared, checked and approved: {what, name}; an empty name is a line to sign.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> signatures(CoverText const& cover);

/// Kind of a record, by the verb that wrote it.
enum class RecordKind { verify, qualify, published, cost, sensitivity };

/// By the fields of the record. \throws InputError where it is none of these \param name of its file
[[nodiscard]] RecordKind kind_of_record(Json const& record, std::string const& name);

/// A row of the page's table of checks.
struct CheckRow {
    std::string check;   ///< the comparison
    std::string result;  ///< "not run" without a record
    std::string record;  ///< the record's program, machine and date; without one: the command that writes it
    bool failed = false;
};

/// \param maker of the results file, as maker_of() names it: a record of another program says so
[[nodiscard]] CheckRow check_row(RecordKind kind, Json const& record, std::string const& maker);
/// `checks` of a report's page.
[[nodiscard]] Table check_table(std::span<CheckRow const> rows);
/// Row of a check of which there is no record. \param file the results file
[[nodiscard]] CheckRow missing_check(RecordKind kind, std::string const& file);

}  // namespace overturn::output
