#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "campaign/detail/plausible.hpp"
#include "core/units.hpp"
#include "core/usual_range.hpp"

namespace overturn {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

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
    UsualKey{"waves.target.time_scale", 0.2, 1.2, "1, or the root of a model's length: 0.632 of 2/5"},
    UsualKey{"waves.time_scale", 0.2, 2, "1, or the root of a model's length: 0.632 of 2/5"},
    UsualKey{"waves.match_tolerance", 0, 0.2, "0.05"},
    UsualKey{"waves.vertical.ratio", 0.1, 1, "half to two thirds, near a fault up to 1"},
    UsualKey{"waves.transverse.ratio", 0.3, 1.5, "horizontal components differ little"},
    UsualKey{"waves.transverse.correlation", -0.3, 0.3, "independent components stay within 0.16"},
    UsualKey{"waves.cycles", 1, 500, "an earthquake has some tens"},
    UsualKey{"waves.aftershock.scale", 0.1, 1.5, "half to 1"},
    UsualKey{"waves.rms", 0.15, 10, "0.02 to 0.4 g"},
    UsualKey{"waves.ground_frequency", 0.3, 15, "0.5 Hz of soft soil to 10 Hz of rock"},
    UsualKey{"waves.ground_damping", 0.1, 1.5, "0.2 to 0.9"},
    UsualKey{"waves.variability.sigma", 0.05, 1.2, "0.5 to 0.8 of recorded spectra"},
    UsualKey{"waves.variability.between", 0.05, 1, "0.2 to 0.5 of recorded spectra"},
    UsualKey{"waves.variability.within", 0.05, 1.2, "0.4 to 0.7 of recorded spectra"},
    UsualKey{"baseline.high_pass", 0.005, 0.5, "0.02 to 0.2 Hz: slower motion, which rocks casks, is taken off"},
    UsualKey{"measures.slid_from", 1e-5, 0.05, "1 mm"},
    UsualKey{"measures.rocked_from", 1e-5, 0.05, "1 mm"},
    UsualKey{"statistics.target_half_width", 1e-4, 0.25, "0.02 to 0.1"},
    UsualKey{"statistics.target_median_half_width", 1e-4, 0.25, "0.05 to 0.2"},
    UsualKey{"statistics.confidence", 0.5, 0.999, "0.9 or 0.95"}};

// "waves.records[0].baseline.high_pass" is of the entry "baseline.high_pass".
bool is_of(std::string const& key, std::string_view entry) {
    return key == entry || (!entry.starts_with("waves.") && key.ends_with("." + std::string(entry)));
}

bool is_stated(config::InputValue const& input) { return input.basis != config::Basis::by_default; }

void add_keys(CampaignSpec const& spec, std::vector<std::string>& lines) {
    for (auto const& input : spec.inputs) {
        auto const* const usual =
            std::ranges::find_if(usual_keys, [&](UsualKey const& entry) { return is_of(input.key, entry.key); });
        double const value = input.number.value_or(nothing);
        if (usual != usual_keys.end() && is_stated(input) && (value < usual->low || value > usual->high)) {
            lines.push_back(fmt::format("{} {} ({}). Check it{}", input.key, input.text, usual->known,
                                        input.dimension == Dimension::none ? "" : " and its unit"));
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

double ratio_of(CampaignSpec const& spec, std::string_view key, double where_neither) {
    double const up = stated_number(spec, fmt::format("waves.vertical.target.{}", key));
    double const across = stated_number(spec, fmt::format("waves.target.{}", key));
    return std::isnan(up) ? where_neither : up / across;
}

// The vertical target over the horizontal one, where both are of one spectrum; a pga that is not stated is inherited.
double same_spectrum(CampaignSpec const& spec) {
    auto const across = word_of(spec, "waves.target.spectrum");
    bool const both = !across.empty() && across == word_of(spec, "waves.vertical.target.spectrum");
    return both ? ratio_of(spec, "pga", 1) * ratio_of(spec, "scale", 1) : nothing;
}
double own_spectrum(CampaignSpec const& spec) {
    bool const both = word_of(spec, "waves.target.spectrum") == "rg-1.60"
                      && word_of(spec, "waves.vertical.target.spectrum") == "rg-1.60-vertical";
    return both ? ratio_of(spec, "pga", nothing) : nothing;
}
double vertical_as_horizontal(CampaignSpec const& spec) {
    return word_of(spec, "waves.target.spectrum").ends_with("vertical") ? 1 : nothing;
}
double longest_of_compared(CampaignSpec const& spec) {
    auto const compared = spec.source->about().compared_periods;
    return compared ? stated_number(spec, "waves.target.longest") / compared->to_s : nothing;
}
double highest_of_basis(CampaignSpec const& spec) {
    auto const* const basis = spec.levels.design_basis();
    return basis == nullptr ? nothing : spec.levels.levels.back().value / basis->value;
}

double level_part_s(CampaignSpec const& spec) {
    double const rise = stated_number(spec, "waves.envelope.rise");
    return stated_number(spec, "waves.envelope.level_end") - (std::isnan(rise) ? 0 : rise);
}

std::string level_part_text(CampaignSpec const& /*spec*/, double seconds) {
    return fmt::format("waves.envelope is level for {:.3g} s", seconds);
}
std::string target_text(CampaignSpec const& spec, double share) {
    return fmt::format("waves.vertical.target is {}, {:.3g} times the horizontal one",
                       word_of(spec, "waves.vertical.target.spectrum"), share);
}
std::string horizontal_text(CampaignSpec const& spec, double /*one*/) {
    return fmt::format("waves.target is {}", word_of(spec, "waves.target.spectrum"));
}
std::string longest_text(CampaignSpec const& spec, double /*ratio*/) {
    return fmt::format("waves.target.longest {}", word_of(spec, "waves.target.longest"));
}
std::string highest_text(CampaignSpec const& spec, double ratio) {
    return fmt::format("the highest level, {}, is {:.3g} times the design basis",
                       spec.levels.text(spec.levels.levels.back().value), ratio);
}

constexpr double close = 0.02;
using OfCampaign = UsualRange<CampaignSpec>;
constexpr std::array campaign_ranges{
    OfCampaign{&same_spectrum, 0.2, 0.9, &target_text, "vertical motion is half to two thirds of the horizontal one",
               "Name a vertical spectrum, or state waves.vertical.ratio"},
    OfCampaign{&own_spectrum, 1 - close, 1 + close, &target_text,
               "RG 1.60 prints its vertical spectra for the horizontal pga, already reduced",
               "Leave pga out: it is the horizontal one's"},
    OfCampaign{&vertical_as_horizontal, 0, 0, &horizontal_text, "a vertical spectrum, lower than the horizontal one",
               "Name the horizontal spectrum"},
    OfCampaign{&longest_of_compared, 0, 1 + close, &longest_text, "the target ends before it: nothing there is matched",
               "Leave it out"},
    OfCampaign{&level_part_s, 0.5, 600, &level_part_text, "strong shaking lasts 5 s to minutes",
               "Check rise, level_end and their units"},
    OfCampaign{&highest_of_basis, 0, 15, &highest_text, "usual: up to 3, in studies 10", "Check the units of both"}};

}  // namespace

double stated_number(CampaignSpec const& spec, std::string_view key) {
    auto const* const input = input_of(spec, key);
    return input == nullptr ? nothing : input->number.value_or(nothing);
}

std::vector<std::string> implausible_keys(CampaignSpec const& spec) {
    auto lines = unusual(spec, std::span<OfCampaign const>(campaign_ranges));
    add_keys(spec, lines);
    return lines;
}

}  // namespace overturn
