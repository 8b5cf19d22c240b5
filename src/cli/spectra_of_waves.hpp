/// Spectra of many waves of a campaign side by side, and what their targets are.
#pragma once

#include <cstdint>

#include <nlohmann/json_fwd.hpp>

#include "campaign/campaign_spec.hpp"
#include "output/spectra_text.hpp"

namespace overturn::cli {

using output::SpectraOfWaves;
using output::SpectrumBand;

/// Spectra of the first `count` waves, unscaled, along their first axis. \throws InputError if there is none to show
[[nodiscard]] SpectraOfWaves spectra_of_waves(CampaignInput const& input, CampaignSpec const& spec, std::int64_t count,
                                              double energy_damping);

/// Data of the figure, as --json prints them: SI, null where nothing is known.
[[nodiscard]] nlohmann::ordered_json spectra_json(CampaignSpec const& spec, SpectraOfWaves const& spectra);

}  // namespace overturn::cli
