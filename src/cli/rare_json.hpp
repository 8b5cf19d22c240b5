/// Rare events as JSON, by the names that scripts depend on. What cannot be trusted is null.
#pragma once

#include <span>

#include <nlohmann/json_fwd.hpp>

#include "results/rare_waves.hpp"
#include "runner/rare_run.hpp"

namespace overturn::cli {

/// [{body, amplitude, probability, interval_95, method, state, reason, runs, crude_runs}, ...]
[[nodiscard]] nlohmann::ordered_json rare_json(CampaignSpec const& spec, std::span<RareBody const> bodies);

/// Waves that overturn a body, for figures: [s], [m/s2], [rad], thinned to what print can show.
[[nodiscard]] nlohmann::ordered_json rare_waves_json(RareWaves const& waves);

}  // namespace overturn::cli
