/// Rows of a finished file for a campaign of more waves: what was computed is not computed again.
#pragma once

#include <filesystem>

#include "campaign/campaign_input.hpp"
#include "campaign/campaign_spec.hpp"
#include "campaign/plan.hpp"
#include "store/shards.hpp"

namespace overturn {

/// Is there a finished file at `output`, of this campaign or of one with other waves.count, limits or statistics alone?
/// \throws InputError naming the keys that bar it, or the program and libraries if these are others
[[nodiscard]] bool can_be_extended(std::filesystem::path const& output, CampaignInput const& input);

/// Commits each block of the plan whose waves the file at `output` holds all, with their rows, unless it is committed.
/// Before the first, the rows of one wave are computed again and held against the file's.
/// \return how many blocks \throws InputError if these rows differ
[[nodiscard]] std::int64_t take_finished_rows(std::filesystem::path const& output, CampaignSpec const& spec,
                                              Plan const& plan, store::ShardFolder const& shards);

}  // namespace overturn
