/// What is left of the motion of records at their ends.
#pragma once

#include <cstdint>

#include "campaign/campaign_spec.hpp"
#include "motion/drift.hpp"

namespace overturn {

/// Calls `visit` with the number and the drift of each wave that was measured.
template <class Visit> void each_drift(CampaignSpec const& spec, Visit&& visit) {
    auto const count = spec.source->about().available ? spec.wave_count : 0;
    for (std::int64_t wave = 0; wave < count; ++wave) {
        auto const drift = spec.source->drift(wave);
        if (!drift) {
            return;
        }
        visit(wave, *drift);
    }
}

}  // namespace overturn
