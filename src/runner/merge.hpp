/// From a folder of blocks to the one results file.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>

#include "campaign/campaign_input.hpp"
#include "campaign/campaign_spec.hpp"
#include "campaign/plan.hpp"
#include "results/rare_rows.hpp"
#include "stats/fragility.hpp"
#include "store/shards.hpp"

namespace overturn {

/// Writes the results file from all blocks of `plan`, in the memory of one and a million trials (for the curves), and
/// removes them once it is durable, those beyond the plan too.
/// \param goes_on asked before every block
/// \param rare one per body, or none \param velocities in which the tables tell them; none: the levels' unit, or m/s
/// \return the tables for the terminal; nothing, and all blocks as they were, if `goes_on` said no
/// \throws SystemError if a block is missing or damaged, or the file cannot be written; the blocks stay
[[nodiscard]] std::optional<std::string> merge_blocks(std::filesystem::path const& output, CampaignInput const& input,
                                                      CampaignSpec const& spec, Plan const& plan,
                                                      store::ShardFolder const& shards,
                                                      std::function<bool()> const& goes_on,
                                                      std::span<RareBody const> rare = {},
                                                      std::optional<IntensityUnit> const& velocities = {});

/// How merging the parts of an array job ended.
enum class MergeEnd { complete, missing };

/// Merges what `overturn run --part` left beside `output`, however many parts it was. Prints the tables.
/// \param velocities as of merge_blocks
/// \throws InputError if nothing was begun there, or a run is writing there now
[[nodiscard]] MergeEnd merge_parts(std::filesystem::path const& output,
                                   std::optional<IntensityUnit> const& velocities = {});

/// \throws InputError if nothing was begun beside `output`, saying so, or what it was is not on record
void require_begun(store::ShardFolder const& shards, std::filesystem::path const& output);

/// \throws InputError if another program began it
void require_same_program(CampaignInput const& begun, std::filesystem::path const& output);

/// "overturn run c.toml -o c.h5 --resume --set seed=3", to be pasted into a shell: what computes the rest.
[[nodiscard]] std::string resume_command(CampaignInput const& input, std::filesystem::path const& output);

}  // namespace overturn
