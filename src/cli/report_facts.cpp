#include "cli/report_facts.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "campaign/validated_range.hpp"
#include "cli/json_values.hpp"
#include "generators/acceptance.hpp"
#include "output/page_text.hpp"
#include "output/waves_text.hpp"

namespace overturn::cli {
namespace {

std::string effects_text(CampaignSpec const& spec) {
    switch (spec.effects.mode) {
        case EffectMode::automatic:
            return "auto: what each scene requires"
                   + (spec.effects.include == 0
                          ? std::string()
                          : fmt::format("; {} in every trial, for the limit states that only they can answer",
                                        names_of_effects(spec.effects.include)));
        case EffectMode::none:
            return "none: plain rocking";
        case EffectMode::forced:
            break;
    }
    return "forced: " + text_of(spec.effects);
}

}  // namespace

Json facts_of(CampaignSpec const& spec, Plan const& plan, Statistics const& statistics) {
    auto facts = Json::array();
    auto const add = [&](char const* name, std::string value) { facts.push_back({name, std::move(value)}); };
    auto const& levels = spec.levels.levels;
    auto const waves = statistics.waves().waves;
    add("waves", fmt::format("{} ({})", output::ran_text(waves, plan.asked()), spec.source->text()));
    for (auto const& remark : spec.source->about().remarks) {
        add("remark on the waves", remark);
    }
    add("variability of waves", spec.source->about().variability);
    if (auto const sigma = statistics.achieved_sigma()) {
        add("scatter about the median", output::sigma_text(*sigma));
    }
    auto const rule = std::ranges::find(acceptance_rules(), spec.source->about().acceptance.rule,
                                        &config::Entry<AcceptanceRule>::name);
    add("acceptance of waves", rule == acceptance_rules().end() ? spec.source->about().acceptance.rule
                                                                : fmt::format("{}: {}", rule->name, rule->summary));
    add("levels", fmt::format("{} of {}, {:.6g} to {}{}", levels.size(), spec.levels.measure_name(),
                              spec.levels.shown(levels.front().value), spec.levels.text(levels.back().value),
                              spec.levels.independent_waves ? ", each with waves of its own"
                                                            : ", the same waves scaled to each"));
    add("trials", output::ran_text(waves * plan.trials_per_wave(), plan.asked() * plan.trials_per_wave()));
    for (std::size_t l = 1; l < spec.limits.size(); ++l) {
        add("limit state", fmt::format("{}: {}", spec.limits[l].name, definition_of(spec.limits[l], spec.limits)));
    }
    return facts;
}

Json method_of(CampaignSpec const& spec) {
    auto facts = Json::array();
    auto const add = [&](char const* name, std::string value) { facts.push_back({name, std::move(value)}); };
    add("effects", effects_text(spec));
    add("validated range", validated_range_text(spec));
    add("integration",
        fmt::format("Taylor series of order {}, {} a sample, tolerance {:.1g}", spec.accuracy.rocking.taylor_order,
                    spec.accuracy.rocking.substeps, spec.accuracy.rocking.step_tolerance));
    add("T0, T1", fmt::format("computed with R in {}",
                              spec.measures.radius_unit == RadiusUnit::centimetre ? "centimetres" : "metres"));
    return facts;
}

}  // namespace overturn::cli
