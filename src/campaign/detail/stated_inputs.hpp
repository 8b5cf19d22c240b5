/// What a campaign states that decides its rows, to compare two campaigns.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "campaign/campaign_input.hpp"
#include "config/stated_values.hpp"

namespace overturn {

/// All values that may decide a row, or the waves of a block, with those of the files that describe bodies.
[[nodiscard]] config::StatedValues decisive_values(CampaignInput const& input);

/// The files whose bytes are compared: all but those of bodies, whose values are, and that of the hazard curve.
[[nodiscard]] std::map<std::string, std::string> compared_files(CampaignInput const& input);

/// The bodies' names as decisive_values() has them, in their order.
[[nodiscard]] std::vector<std::string> stated_bodies(CampaignInput const& input);

/// One record, of `waves.files` or [[waves.records]].
struct StatedRecord {
    std::string name;             ///< of its first file
    std::string text;             ///< all that is stated of it, to be compared
    config::StatedValues values;  ///< the same, by key
    std::set<std::string> stems;  ///< of its files' names, without their folder: what stations' other files have too
};

/// In their order; none where the waves are no records.
[[nodiscard]] std::vector<StatedRecord> stated_records(CampaignInput const& input);

/// The records that only one of two campaigns has.
struct RecordsApart {
    std::vector<StatedRecord> before, now;
};

/// Each record of one goes with an equal one of the other, wherever it stands.
[[nodiscard]] RecordsApart records_apart(CampaignInput const& before, CampaignInput const& now);

}  // namespace overturn
