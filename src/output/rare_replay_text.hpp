/// A trial of rare events that was computed again, in words.
#pragma once

#include <cstdint>
#include <string>

#include "output/json.hpp"
#include "results/rare_replay.hpp"

namespace overturn::output {

/// "row 3 of cask: subset, replicate 0, ...", then how it ended at each factor. \param limit name of the limit state
[[nodiscard]] std::string rare_replay_text(RareReplay const& replay, std::int64_t row, std::string const& body,
                                           std::string const& limit);
/// The same as JSON, with the columns that are not bit-equal.
[[nodiscard]] Json rare_replay_json(RareReplay const& replay, std::int64_t row, std::string const& body,
                                    std::string const& limit);

}  // namespace overturn::output
