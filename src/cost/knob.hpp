/// Knobs of a cost study: the keys of a campaign that buy accuracy with time, and the values to try.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "campaign/campaign_spec.hpp"

namespace overturn::cost {

/// Part of a campaign that a knob acts on, which is timed and whose error is measured.
enum class Acts { trials, ou_v_e, v_wes, waves, spectra };

/// One position of a knob.
struct Setting {
    std::string label;
    std::vector<std::string> settings;  ///< as after --set
    double value = 0;                   ///< of `label`, for what no key states
};

struct Knob {
    std::string name;   ///< "effects": its group in files
    std::string title;  ///< "effects, model by model"
    std::string error;  ///< meaning of its error
    std::string timed;  ///< unit of its time: "trial"
    Acts acts = Acts::trials;
    std::vector<Setting> settings;
    std::optional<std::size_t> here = {};     ///< place of the campaign's setting; empty if no key states it
    std::vector<std::string> reference = {};  ///< settings of the trials that its own are compared with
    std::set<std::int64_t> bodies = {};       ///< numbers of those it acts on; empty: all
};

/// The knobs this campaign has, each with the campaign's own position among its settings.
[[nodiscard]] std::vector<Knob> knobs_of(CampaignInput const& input, CampaignSpec const& spec);

/// Reference settings of every trial: order 12, 16 sub-steps, every tolerance near rounding, by keys that campaigns
/// themselves no longer state; on compliant points the campaign's own step.
[[nodiscard]] std::vector<std::string> reference_settings();

/// The same with 12 sub-steps: it differs in rounding only, so what differs is what rounding does to rocking.
[[nodiscard]] std::vector<std::string> second_reference_settings();

/// The knob of the step on compliant points: there is one where a trial may come to stand on any.
inline constexpr char const* contact_step = "contact_step";
/// The reference with a tenth of the usual step on compliant points.
[[nodiscard]] std::vector<std::string> contact_reference_settings();

/// The reference with every effect that the scene calls for; where some body's base or pad is stated or waves have a
/// transverse component, with all that can be simulated, so that what auto leaves out shows (not where some bodies have
/// friction and others none: sliding cannot be forced on all).
[[nodiscard]] std::vector<std::string> effects_reference_settings(CampaignSpec const& spec);

/// Setting that asks for automatic effects.
inline constexpr char const* automatic_effects = "effects={mode=\"auto\"}";

/// Phase per panel of the reference quadrature [rad].
inline constexpr double reference_panel_phase_rad = 4;

/// Periods per decade of the reference spectrum.
inline constexpr double reference_periods_per_decade = 1200;

/// The campaign with `settings` on top of its own. \throws InputError
[[nodiscard]] CampaignInput with(CampaignInput const& input, std::vector<std::string> const& settings);

}  // namespace overturn::cost
