/// A trial of rare events computed again from what the results file holds of it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "campaign/campaign_spec.hpp"
#include "results/rare_rows.hpp"
#include "store/results_file.hpp"

namespace overturn {

/// A stored trial computed again from the file alone.
struct RareReplay {
    RareRow stored;                      ///< the row, as it is in the file
    std::vector<double> factors;         ///< on the level, at each of which it was tried
    std::vector<bool> passed;            ///< the limit state, by factor
    std::vector<std::string> different;  ///< columns that are not bit-equal
};
/// \param limit name of the limit state \throws InputError if there is no such body, limit or row
[[nodiscard]] RareReplay replay_rare(store::ResultsReader const& file, CampaignSpec const& spec,
                                     std::string const& body, std::string const& limit, std::int64_t row);

}  // namespace overturn
