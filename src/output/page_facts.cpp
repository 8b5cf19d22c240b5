#include "output/page_facts.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "body/parts.hpp"
#include "campaign/validated_range.hpp"
#include "generators/acceptance.hpp"
#include "output/page_text.hpp"
#include "output/waves_text.hpp"

namespace overturn::output {
namespace {

constexpr double degree = pi / 180;

std::string placement_of(BodySpec const& spec) {
    auto const& body = spec.body;
    std::vector<std::string> remarks;
    if (body.slope_rad() != 0) {
        remarks.push_back(fmt::format("on ground that falls by {:.3g}° towards +x", body.slope_rad() / degree));
    }
    if (body.offset_m() != 0) {
        remarks.push_back(fmt::format("its centre {:.3g} {} off the base's middle, towards +x",
                                      body.offset_m() / spec.units.length.si, spec.units.length.symbol));
    }
    if (body.initial_tilt_rad() != 0) {
        remarks.push_back(fmt::format("let go at {:.3g}°", body.initial_tilt_rad() / degree));
    }
    auto text = fmt::format("{}: {}.", spec.name, fmt::join(remarks, "; "));
    if (body.lopsided()) {
        text += fmt::format(
            " It tips at {:.4g}° towards +x and at {:.4g}° towards -x; what the table says is of the weaker side.",
            body.corner(1).alpha_rad / degree, body.corner(-1).alpha_rad / degree);
    }
    return text;
}

std::string effects_text(CampaignSpec const& spec) {
    switch (spec.effects.mode) {
        case EffectMode::automatic:
            return "auto: what each trial requires"
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
    add("waves", fmt::format("{} ({})", ran_text(waves, plan.asked()), spec.source->text()));
    for (auto const& remark : spec.source->about().remarks) {
        add("remark on the waves", remark);
    }
    add("variability of waves", spec.source->about().variability);
    if (auto const sigma = statistics.achieved_sigma()) {
        add("scatter about the median", sigma_text(*sigma));
    }
    auto const rule = std::ranges::find(acceptance_rules(), spec.source->about().acceptance.rule,
                                        &config::Entry<AcceptanceRule>::name);
    add("acceptance of waves", rule == acceptance_rules().end() ? spec.source->about().acceptance.rule
                                                                : fmt::format("{}: {}", rule->name, rule->summary));
    add("levels", fmt::format("{} of {}, {:.6g} to {}{}", levels.size(), spec.levels.measure_name(),
                              spec.levels.shown(levels.front().value), spec.levels.text(levels.back().value),
                              spec.levels.independent_waves ? ", each with waves of its own"
                                                            : ", the same waves scaled to each"));
    add("trials", ran_text(waves * plan.trials_per_wave(), plan.asked() * plan.trials_per_wave()));
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

Json outlines_of(CampaignSpec const& spec) {
    auto all = Json::object();
    for (auto const& body : spec.bodies) {
        auto& parts = all[body.name] = Json::array();
        for (auto const& part : body.parts) {
            if (auto const* const cylinder = std::get_if<Cylinder>(&part)) {
                parts.push_back({2 * cylinder->radius_m, cylinder->height_m, cylinder->bottom_height_m});
            } else if (auto const* const box = std::get_if<Box>(&part)) {
                parts.push_back({box->width_m, box->height_m, box->bottom_height_m});
            } else {
                parts.push_back({0, 0, std::get<PointMass>(part).height_m});
            }
        }
    }
    return all;
}

Json placements_of(CampaignSpec const& spec) {
    auto lines = Json::array();
    for (auto const& body : spec.bodies) {
        if (body.body.needs_planar_rocking()) {
            lines.push_back(placement_of(body));
        }
    }
    return lines;
}

}  // namespace overturn::output
