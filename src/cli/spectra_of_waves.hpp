/// Spectra of many waves of a campaign side by side, and what their targets are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "campaign/campaign_spec.hpp"

namespace overturn::cli {

/// 16 %, 50 % and 84 % of a sample at each period, and its largest.
struct SpectrumBand {
    std::vector<double> p16, p50, p84, highest;
};

struct SpectraOfWaves {
    struct Wave {
        std::int64_t number = 0;
        std::string label;
        std::vector<double> psa_mps2, v_e_mps;
    };
    double damping = 0.05;        ///< of psa: the target's
    double energy_damping = 0.1;  ///< of V_E
    std::vector<double> period_s;
    std::vector<Wave> waves;
    std::int64_t left_out = 0;  ///< waves that cannot be made
    SpectrumBand psa_mps2, v_e_mps;
    std::string target;                   ///< its name; empty where the source has none, or one of energy
    std::vector<double> stated_psa_mps2;  ///< the target as stated; NaN where it says nothing
    std::optional<SpectrumBand> targets;  ///< of the waves' own targets [m/s2], where these vary
};

/// Spectra of the first `count` waves, unscaled, along their first axis. \throws InputError if there is none to show
[[nodiscard]] SpectraOfWaves spectra_of_waves(CampaignInput const& input, CampaignSpec const& spec, std::int64_t count,
                                              double energy_damping);

/// Data of the figure, as --json prints them: SI, null where nothing is known.
[[nodiscard]] nlohmann::ordered_json spectra_json(CampaignSpec const& spec, SpectraOfWaves const& spectra);

}  // namespace overturn::cli
