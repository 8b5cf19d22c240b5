/// Settings of rare-event estimation in a campaign.
#pragma once

#include <cstdint>
#include <optional>

#include "campaign/level_spec.hpp"
#include "config/table.hpp"
#include "generators/wave_source.hpp"
#include "rare/estimate.hpp"

namespace overturn {

struct RareSpec {
    std::optional<rare::Method> method;  ///< empty: what each level calls for
    double target_cov = 0.1;             ///< wanted standard error over probability, where max_runs allows it
    std::int64_t replicates = 8;         ///< independent ones, for the interval
    std::int64_t max_runs = 1'000'000;   ///< waves per estimator, body and level
};

/// Keys of [rare].
extern config::KeyTable const rare_keys_table;

/// Nothing where there is no [rare]. \throws InputError where the campaign's levels or waves are not for these
/// estimators, with the reason and what to do
[[nodiscard]] std::optional<RareSpec> read_rare(config::Table const& root, LevelSpec const& levels,
                                                WaveSource const& source);

}  // namespace overturn
