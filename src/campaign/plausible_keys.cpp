#include <algorithm>
#include <array>
#include <limits>

#include "campaign/detail/plausible.hpp"
#include "core/units.hpp"
#include "core/usual_range.hpp"

namespace overturn {
namespace {

/// A key of a campaign that is a number, wherever tables of that name lie, and where it usually is [SI].
struct UsualKey {
    std::string_view key;
    double low, high;
    std::string_view known;
};

constexpr std::array usual_keys{
    UsualKey{"waves.duration", 3, 600, "earthquakes shake for 10 s to 5 min"},
    UsualKey{"waves.period", 0.02, 20, "casks rock at 0.5 to 10 s"},
    UsualKey{"waves.target.pga", 0.05 * g0, 3 * g0, "design earthquakes 0.1 to 1 g"},
    UsualKey{"waves.target.scale", 0.05, 10, "1"},
    UsualKey{"target.damping", 0.005, 0.2, "0.05 of design spectra"},
    UsualKey{"target.stated_damping", 0.005, 0.2, "0.05 of design spectra"},
    UsualKey{"waves.target.time_scale", 0.2, 2, "1, or the root of a model's length: 0.632 of 2/5"},
    UsualKey{"waves.time_scale", 0.2, 2, "1, or the root of a model's length: 0.632 of 2/5"},
    UsualKey{"waves.match_tolerance", 0, 0.2, "0.05"},
    UsualKey{"waves.vertical.ratio", 0.1, 1, "half to two thirds, near a fault up to 1"},
    UsualKey{"waves.transverse.ratio", 0.3, 1.5, "horizontal components are much alike"},
    UsualKey{"waves.aftershock.scale", 0.1, 1.5, "half to 1"},
    UsualKey{"waves.rms", 0.1, 10, "0.02 to 0.4 g"},
    UsualKey{"waves.ground_frequency", 0.3, 15, "0.5 Hz of soft soil to 10 Hz of rock"},
    UsualKey{"waves.ground_damping", 0.1, 1.5, "0.2 to 0.9"},
    UsualKey{"waves.variability.sigma", 0.05, 1.2, "0.5 to 0.8 of recorded spectra"},
    UsualKey{"waves.variability.between", 0.05, 1, "0.2 to 0.5 of recorded spectra"},
    UsualKey{"waves.variability.within", 0.05, 1.2, "0.4 to 0.7 of recorded spectra"},
    UsualKey{"baseline.high_pass", 0.005, 0.5, "0.02 to 0.2 Hz: slower motion, which rocks casks, is taken off"},
    UsualKey{"measures.slid_from", 1e-5, 0.05, "1 mm"},
    UsualKey{"measures.rocked_from", 1e-5, 0.05, "1 mm"},
    UsualKey{"statistics.confidence", 0.5, 0.999, "0.9 or 0.95"}};

// "waves.records[0].baseline.high_pass" is of the entry "baseline.high_pass".
bool is_of(std::string const& key, std::string_view entry) {
    return key == entry || (!entry.starts_with("waves.") && key.ends_with("." + std::string(entry)));
}

bool is_stated(config::InputValue const& input) { return input.basis != config::Basis::by_default; }

void add_keys(CampaignSpec const& spec, std::vector<std::string>& lines) {
    for (auto const& input : spec.inputs) {
        auto const usual =
            std::ranges::find_if(usual_keys, [&](UsualKey const& entry) { return is_of(input.key, entry.key); });
        double const value = input.number.value_or(std::numeric_limits<double>::quiet_NaN());
        if (usual != usual_keys.end() && is_stated(input) && (value < usual->low || value > usual->high)) {
            lines.push_back(fmt::format("{} {} ({}). Check it and its unit", input.key, input.text, usual->known));
        }
    }
}

config::InputValue const* input_of(CampaignSpec const& spec, std::string_view key) {
    auto const found = std::ranges::find(spec.inputs, key, &config::InputValue::key);
    return found == spec.inputs.end() || !is_stated(*found) ? nullptr : &*found;
}
std::string_view word_of(CampaignSpec const& spec, std::string_view key) {
    auto const* const input = input_of(spec, key);
    return input == nullptr ? std::string_view() : std::string_view(input->text);
}

// The vertical target's pga over the horizontal one's, where both are of these spectra.
double vertical_share(CampaignSpec const& spec, bool of_one_spectrum) {
    auto const across = word_of(spec, "waves.target.spectrum");
    auto const up = word_of(spec, "waves.vertical.target.spectrum");
    bool const both = of_one_spectrum ? across == up : across == "rg-1.60" && up == "rg-1.60-vertical";
    double const share = stated_number(spec, "waves.vertical.target.pga") / stated_number(spec, "waves.target.pga");
    return both && !across.empty() ? share : std::numeric_limits<double>::quiet_NaN();
}
double same_spectrum(CampaignSpec const& spec) { return vertical_share(spec, true); }
double own_spectrum(CampaignSpec const& spec) { return vertical_share(spec, false); }

std::string pga_said(CampaignSpec const& spec, double share) {
    return fmt::format("waves.vertical.target is {} of pga {}, {:.3g} times the horizontal pga",
                       word_of(spec, "waves.vertical.target.spectrum"), word_of(spec, "waves.vertical.target.pga"),
                       share);
}

constexpr double close = 0.02;
constexpr std::array target_ranges{
    UsualRange<CampaignSpec>{&same_spectrum, 0.2, 0.9, &pga_said,
                             "the horizontal spectrum itself; a vertical one is half to two thirds of it",
                             "Name a vertical spectrum, or state waves.vertical.ratio"},
    UsualRange<CampaignSpec>{&own_spectrum, 1 - close, 1 + close, &pga_said,
                             "RG 1.60 prints its vertical spectra for the horizontal pga, already reduced",
                             "Leave pga out: it is the horizontal one's"}};

}  // namespace

double stated_number(CampaignSpec const& spec, std::string_view key) {
    auto const* const input = input_of(spec, key);
    return input == nullptr ? std::numeric_limits<double>::quiet_NaN()
                            : input->number.value_or(std::numeric_limits<double>::quiet_NaN());
}

std::vector<std::string> implausible_keys(CampaignSpec const& spec) {
    auto lines = unusual(spec, std::span<UsualRange<CampaignSpec> const>(target_ranges));
    add_keys(spec, lines);
    return lines;
}

}  // namespace overturn
