/// A finished file held against what this program computes, row by row and bit by bit.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "campaign/campaign_spec.hpp"
#include "parallel/communicator.hpp"
#include "store/results_file.hpp"

namespace overturn {

struct VerifyWish {
    std::optional<std::int64_t> sample;  ///< so many rows drawn at random, each once; none: all
    std::int64_t seed = 1;               ///< of that drawing; it has no part in any result
};

/// What was found; complete on rank 0 only.
struct Verified {
    std::int64_t trials = 0, waves = 0, rare = 0;  ///< rows computed again
    std::int64_t differing_trials = 0, differing_waves = 0, differing_rare = 0;
    std::string first;  ///< "trial 17 (wave 0, type-b, 600 gal): v_wes, v_resp"; empty if nothing differs

    [[nodiscard]] bool all_equal() const { return first.empty(); }
};

/// Every rank computes its share. Compared are the rows of /trials with their models' own, the waves they belong to
/// (/waves, /waves/<body>), and those of rare events. Collective.
/// \throws InputError if more rows are to be drawn than there are
[[nodiscard]] Verified verify_rows(store::ResultsReader const& file, CampaignSpec const& spec, VerifyWish const& wish,
                                   parallel::Communicator const& comm);

}  // namespace overturn
