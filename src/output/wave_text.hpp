/// Quality of a wave, as text and as JSON.
#pragma once

#include <string>

#include "campaign/campaign_spec.hpp"
#include "campaign/wave_check.hpp"

namespace overturn::output {

/// Lines on the match, on [T0, T1] of every body, and on every clause of the acceptance rule.
[[nodiscard]] std::string wave_text(CampaignSpec const& spec, GeneratedWave const& wave, WaveCheck const& check);

/// The same as one JSON object.
[[nodiscard]] std::string wave_json(CampaignSpec const& spec, GeneratedWave const& wave, WaveCheck const& check);

}  // namespace overturn::output
