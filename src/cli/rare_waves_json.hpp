/// Waves that overturn a body, for figures.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "results/rare_waves.hpp"

namespace overturn::cli {

/// [s], [m/s2], [rad], thinned to what print can show.
[[nodiscard]] nlohmann::ordered_json rare_waves_json(RareWaves const& waves);

}  // namespace overturn::cli
