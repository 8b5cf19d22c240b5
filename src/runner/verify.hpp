/// Comparison of a finished file with this program's rows, bit by bit.
#pragma once

#include <cstdint>
#include <optional>

#include "campaign/campaign_spec.hpp"
#include "parallel/communicator.hpp"
#include "results/verified.hpp"
#include "store/results_file.hpp"

namespace overturn {

struct VerifyRequest {
    std::optional<std::int64_t> sample;  ///< so many rows drawn at random, each once; none: all
    std::int64_t seed = 1;               ///< of that drawing; it has no part in any result
};

/// Every rank computes its share. Compared are the rows of /trials with their models' own, the waves they belong to
/// (/waves, /waves/<body>), and those of rare events. Collective; complete on
/// rank 0 alone.
/// \throws InputError if more rows are to be drawn than there are
[[nodiscard]] Verified verify_rows(store::ResultsReader const& file, CampaignSpec const& spec,
                                   VerifyRequest const& request, parallel::Communicator const& comm);

}  // namespace overturn
