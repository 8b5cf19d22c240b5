/// Running a campaign on all ranks: blocks from a shared counter, every rank computes and commits, rank 0 merges.
#pragma once

#include <filesystem>
#include <limits>

#include "campaign/campaign_input.hpp"
#include "campaign/plan.hpp"
#include "parallel/communicator.hpp"
#include "runner/merge.hpp"

namespace overturn {

struct RunOptions {
    std::filesystem::path output;
    bool resume = false;
    bool extend = false;  ///< rows of a finished file go into this one; implies resume
    bool shrink = false;  ///< with extend: rows that this campaign does not ask for are given up
    double max_walltime_s = std::numeric_limits<double>::infinity();
    Part part;                   ///< the whole, or one part of an array job, whose blocks wait for merge_parts
    bool quiet = false;          ///< no table on stdout
    bool leaves_blocks = false;  ///< all blocks wait for merge_parts, as those of a part do
    MergeOptions merge{};        ///< layout of the file, and what of the results is printed
};

/// A part, or a run that leaves its blocks, is complete when these are done.
enum class RunEnd { complete, stopped };

/// Collective. Prints progress on stderr and the results on stdout, both from rank 0.
/// \throws InputError on every rank if the output is taken, not writable, not shared by all nodes, or belongs to
/// another campaign. \throws CollectiveError on every rank if one cannot write
[[nodiscard]] RunEnd run_campaign(CampaignInput const& input, RunOptions const& options,
                                  parallel::Communicator const& comm);

/// Rank 0 loads, every rank gets. Collective. \throws InputError on every rank
[[nodiscard]] CampaignInput load_campaign_everywhere(std::filesystem::path const& path,
                                                     std::span<std::string const> settings,
                                                     parallel::Communicator const& comm);

/// Default path of a campaign's results: its own name with .h5, in the current folder.
[[nodiscard]] std::filesystem::path default_output(std::filesystem::path const& campaign);

}  // namespace overturn
