/// From blocks of rows to the results file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "campaign/campaign_input.hpp"
#include "campaign/campaign_spec.hpp"
#include "campaign/plan.hpp"
#include "results/analysis.hpp"
#include "results/rare_rows.hpp"
#include "results/statistics.hpp"
#include "store/results_file.hpp"

namespace overturn {

/// Writes the program, format and campaign that made a file as attributes of its root.
void write_provenance(store::ResultsWriter& file, std::string const& format, std::int64_t version,
                      CampaignInput const& input, std::string const& title);

/// Other processes that make results beside this one: what is empty this process does alone.
struct WritingHelp {
    /// Writes the rows of all waves of a plan into their places, in a plain file of waves whose counts add up
    /// (Statistics::add_up), and adds their counts and the first trials to the statistics.
    std::function<void(store::RowPlaces const& places, Plan const& plan, Statistics& statistics)> rows = {};
    store::HashStretches hash = {};
    FitCurves curves = {};
};

/// One process's part of WritingHelp::rows: writes the rows of blocks of `drawn`, of which all waves count, into their
/// places. \return what they count, with the trials that are among the first of the plan
Statistics write_rows_in_place(CampaignSpec const& spec, Plan const& drawn, store::BlockRange blocks,
                               std::function<std::vector<std::byte>(std::int64_t)> const& block,
                               store::RowPlaces const& places);

/// Writes the finished file from the blocks of `drawn`, given in order by `block`: of their waves those that are
/// `chosen`, and beside them those that a rule refused on the way. \return what the trials say, as stored
/// \param rare one per body, or none \param help the file is the same without it, byte by byte
std::vector<BodyAnalysis> write_results(std::filesystem::path const& path, CampaignInput const& input,
                                        CampaignSpec const& spec, Plan const& drawn, Plan const& chosen,
                                        std::function<std::vector<std::byte>(std::int64_t)> const& block,
                                        Statistics& statistics, std::span<RareBody const> rare = {},
                                        store::Layout layout = store::Layout::plain, WritingHelp const& help = {});

}  // namespace overturn
