/// Spectra of many waves of a campaign side by side, as a table of the terminal.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "campaign/campaign_spec.hpp"
#include "output/shown_velocity.hpp"

namespace overturn::output {

/// 16 %, 50 % and 84 % of a sample at each period, its lowest and highest value.
struct SpectrumBand {
    std::vector<double> lowest, p16, p50, p84, highest;  ///< percentiles: NaN of fewer waves than fewest_for_quantile
    bool few = false;                                    ///< too few for p16 and p84
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

/// Number of waves, their variability, and the percentiles at every fifth period; accelerations in the campaign's unit.
[[nodiscard]] std::string spectra_text(CampaignSpec const& spec, SpectraOfWaves const& spectra,
                                       ShownVelocity const& velocity);

}  // namespace overturn::output
