/// A campaign that takes the rows of a smaller one, or of another cut of the same: what was computed is not computed
/// again.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "campaign/campaign_input.hpp"
#include "campaign/campaign_spec.hpp"
#include "campaign/plan.hpp"
#include "runner/detail/earlier_rows.hpp"
#include "store/shards.hpp"

namespace overturn {

/// Is there a finished file at `output`, of this campaign or of one whose rows this one can use?
/// \param may_shrink rows of the file may be left out \throws InputError naming the keys that bar it, the program and
/// libraries if these are others, or what would be lost
[[nodiscard]] bool can_be_extended(std::filesystem::path const& output, CampaignInput const& input, bool may_shrink);

/// Can this campaign use the blocks of a run that was begun with another, and of those that were set aside for it?
/// \param may_shrink as above \throws InputError likewise
/// \return false where nothing but what moves no block differs
[[nodiscard]] bool can_take_over(store::ShardFolder const& shards, CampaignInput const& begun,
                                 CampaignInput const& input, bool may_shrink);

/// Waves of a group, or shared by all levels, that earlier campaigns left: the finished file's, or blocks set aside.
[[nodiscard]] std::int64_t waves_held(std::filesystem::path const& output, store::ShardFolder const& shards,
                                      CampaignInput const& input);

/// A target that is met early leaves out what is held beyond. \throws InputError if that is something
void refuse_lost_waves(std::int64_t held, Plan const& chosen, std::string const& place);

/// Rows to be kept, and their places; a text that goes to all ranks.
struct KeptPlaces {
    std::string text;
    std::int64_t blocks = 0;   ///< taken whole
    std::int64_t in_part = 0;  ///< of whose trials some are known
    KeptCount rows;

    [[nodiscard]] bool any() const { return blocks + in_part > 0; }
};

/// What is known of the plan's blocks by the finished file or by blocks that were set aside. Of the first block of each
/// place the rows of one wave are computed again and compared. \throws InputError if these rows differ
[[nodiscard]] KeptPlaces find_known_blocks(std::filesystem::path const& output, CampaignInput const& input,
                                           CampaignSpec const& spec, Plan const& plan,
                                           store::ShardFolder const& shards);

/// Their rows, for every rank. \param text of KeptPlaces; empty: nothing is known
[[nodiscard]] std::unique_ptr<KeptRows> kept_rows(std::string const& text, CampaignInput const& input,
                                                  CampaignSpec const& spec, Plan const& plan);

}  // namespace overturn
