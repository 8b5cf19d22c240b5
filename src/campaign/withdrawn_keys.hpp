/// Keys that campaigns could state once and that are constants now. A file of results that states them is still read,
/// and its trials are followed as it states; no reference lists them.
#pragma once

#include <vector>

#include "campaign/campaign_input.hpp"
#include "config/key.hpp"

namespace overturn {

/// The keys of a table, and those it has from others, that references list: all but withdrawn ones.
[[nodiscard]] std::vector<config::Key const*> listed_keys(config::KeyTable const& table);

/// \throws InputError at a withdrawn key that differs from its constant
void refuse_withdrawn_keys(CampaignInput const& input);

}  // namespace overturn
