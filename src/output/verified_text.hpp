/// Rows of a finished file that were computed again: a line, a record that can be filed, and its page.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "campaign/campaign_spec.hpp"
#include "output/json.hpp"
#include "results/verified.hpp"
#include "store/results_file.hpp"

namespace overturn::output {

/// The request, and where it was computed.
struct Verification {
    std::string file;
    std::string date;                    ///< as the user states it; empty: not stated
    std::optional<std::int64_t> sample;  ///< rows drawn at random; empty: all
    std::int64_t seed = 1;               ///< of that drawing
    int ranks = 1;
};

/// "7 of 200"; all of them: "200".
[[nodiscard]] std::string share_of(std::int64_t some, std::int64_t all);

[[nodiscard]] Json verified_json(Verification const& of, store::ResultsReader const& file, CampaignSpec const& spec,
                                 Verified const& found);

/// "c.h5: 200 trials, 10 waves recomputed, all bit-equal to the stored rows"; of a sample "7 of 200 trials, 5 of
/// 10 waves". \param json of verified_json
[[nodiscard]] std::string verified_text(Verification const& of, Verified const& found, Json const& json);

/// Columns that were not compared, a line for each reason. \param json of verified_json
[[nodiscard]] std::vector<std::string> not_compared(Json const& json);

/// The page of the record. \param json of verified_json
[[nodiscard]] std::string verified_page(Json const& json);

}  // namespace overturn::output
