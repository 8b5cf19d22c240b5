/// Limit states as a campaign file states them: [[limits]] and what a run may stop at.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "campaign/body_spec.hpp"
#include "campaign/limit_state.hpp"
#include "campaign/site.hpp"
#include "config/table.hpp"

namespace overturn {

/// Waves of the levels: shared, independent for each level, or the same points of a grid.
enum class WavesOfLevels { shared, independent, grid };

extern config::KeyTable const limit_table;      ///< of [[limits]]
extern config::KeyTable const precision_table;  ///< precision at which it ends, in [statistics] or a limit

/// Reads [[limits]], behind overturning, which is always there, and those that a site brings. Targets that a limit does
/// not state are those of [statistics]. \param statistics [statistics], whose targets are read too \param falls_pass of
/// limits that do not say what a trial that overturned counts as \param effects gets what limits call for \throws
/// InputError
[[nodiscard]] std::vector<LimitState> read_limits(config::Table const& root, config::Table const& statistics,
                                                  WavesOfLevels waves, bool falls_pass, Site const& site,
                                                  EffectRequest& effects);

/// Why a body, as it is stated, cannot pass a limit: slip without friction, crush without a strength. "": it can.
[[nodiscard]] std::string unreachable(LimitState const& limit, BodySpec const& body);

/// Refuses limits that no body can pass. \throws InputError
void check_reachable(config::Table const& root, std::span<LimitState const> limits, std::span<BodySpec const> bodies);

}  // namespace overturn
