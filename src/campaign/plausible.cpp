#include "campaign/detail/plausible.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string_view>

#include <fmt/format.h>

#include "campaign/detail/gyration.hpp"
#include "campaign/detail/limit_range.hpp"
#include "campaign/limit_spec.hpp"
#include "campaign/warnings.hpp"
#include "core/units.hpp"

namespace overturn {
namespace {

using Lines = std::vector<std::string>;

/// A number that follows from what is stated of a body, and where it usually lies.
struct BodyRange {
    double (*of)(BodySpec const& body);  ///< NaN: does not apply
    double low, high;
    std::string (*said)(BodySpec const& body, double value);
    std::string_view known;   ///< what is usual
    std::string_view remedy;  ///< what to look at
};

double density(BodySpec const& body) {
    auto const& b = body.body;
    return b.mass_kg() / (8 * b.half_width_m() * b.half_width_m() * b.centre_height_m());
}
double gyration(BodySpec const& body) { return gyration_share(body.body); }
double slenderness(BodySpec const& body) { return body.body.centre_height_m() / body.body.half_width_m(); }
double of_housner(BodySpec const& body) {
    double const housner = body.body.housner_restitution();
    return housner > 0 ? body.body.restitution() / housner : never;
}
double friction(BodySpec const& body) { return body.friction ? body.friction->static_coefficient : never; }

std::string density_said(BodySpec const& body, double value) {
    return fmt::format("mass {:.4g} kg in the box of base and centre height is {:.3g} kg/m3", body.body.mass_kg(),
                       value);
}
std::string gyration_said(BodySpec const& body, double value) {
    return fmt::format("inertia {:.4g} kg m2 is a radius of gyration of {:.3g} m, {:.2g} of R",
                       body.body.inertia_kgm2(), value * body.body.radius_m(), value);
}
std::string slenderness_said(BodySpec const& body, double value) {
    return fmt::format("centre height {:.4g} m over half the width is {:.3g}", body.body.centre_height_m(), value);
}
std::string restitution_said(BodySpec const& body, double value) {
    return fmt::format("restitution {:.4g} is {:.2g} of Housner's for its shape, {:.4g}", body.body.restitution(),
                       value, body.body.housner_restitution());
}
std::string friction_said(BodySpec const& /*body*/, double value) {
    return fmt::format("static friction {:.4g}", value);
}

constexpr std::array body_ranges{
    BodyRange{
        &density, 1200, 8000, &density_said, "casks 1500 to 5000, concrete 2400, steel 7850",
        "Check its unit (kg or t?), base_width (the whole width) and centre_height (of the centre of gravity, not the "
        "top)"},
    BodyRange{&gyration, least_gyration_share, 1.2, &gyration_said, "0.58 of a uniform block",
              "Check its unit, or write \"uniform-block\""},
    BodyRange{&slenderness, 0.8, 15, &slenderness_said, "casks 1.5 to 3, slender test blocks 7 to 13",
              "Check that base_width and centre_height are not swapped, and their units"},
    BodyRange{&of_housner, 0.7, 1.6, &restitution_said, "measured: 0.9 to 1.3 of it",
              "State another, or \"housner\": one too low takes energy that a real body keeps"},
    BodyRange{&friction, 0.05, 1.2, &friction_said, "steel on concrete 0.2 to 0.8", "Check it"}};

// What the campaign states at a key [SI]; NaN: nothing.
double stated(CampaignSpec const& spec, std::string_view key) {
    auto const found = std::ranges::find(spec.inputs, key, &config::InputValue::key);
    bool const is_stated = found != spec.inputs.end() && found->basis != config::Basis::by_default;
    return is_stated ? found->number.value_or(never) : never;
}

void add_design_basis(CampaignSpec const& spec, Lines& lines) {
    auto const& levels = spec.levels;
    for (auto const& level : levels.levels) {
        if (level.purpose != LevelClass::design_basis) {
            continue;
        }
        double const target = levels.measure == measure_named("factor") ? 1.0
                              : levels.measure == measure_named("pga")  ? stated(spec, "waves.target.pga")
                                                                        : never;
        constexpr double close = 0.02;
        if (std::abs(level.value / target - 1) > close) {
            lines.push_back(fmt::format(
                "design basis {} where the target is of {} (the waves of the target are another level). State one of "
                "them as the other, if they are the same earthquake",
                levels.text(level.value), levels.text(target)));
        }
    }
}

void add_weak_levels(LevelSpec const& levels, Lines& lines) {
    constexpr double weakest_mps2 = 1;
    double const highest = levels.levels.back().value;
    if (levels.stated_unit.empty() && levels.measure == measure_named("pga") && highest < weakest_mps2) {
        lines.push_back(
            fmt::format("levels up to pga {:g} m/s2 = {:.2g} g (a bare number is SI). Write \"{:g} g\" if "
                        "that was meant",
                        highest, highest / g0, highest));
    }
}

// "peak_slip above 300 m"
std::string rule_text(LimitState const& limit) {
    return fmt::format("{} {} {}", limit.quantity.name, limit.rule == LimitState::Rule::above ? "above" : "below",
                       limit.threshold_text());
}

// Of what all bodies have in common: where one of them may pass the limit as usual, it is meant.
void add_unusual_threshold(LimitState const& limit, std::span<LimitRange const> ranges, Lines& lines) {
    auto const all = [&](auto holds) { return std::ranges::all_of(ranges, holds); };
    auto const& first = ranges.front();
    if (all([&](LimitRange const& range) { return passed_at_rest(limit, range); })) {
        bool const above = limit.rule == LimitState::Rule::above;
        lines.push_back(fmt::format("limit '{}': {} is passed by a body at rest. Write {} if {} is worse", limit.name,
                                    rule_text(limit), above ? "below" : "above", above ? "smaller" : "larger"));
    } else if (limit.rule == LimitState::Rule::below) {
        return;
    } else if (all([&](LimitRange const& range) { return limit.threshold >= range.usual_high; })) {
        lines.push_back(
            fmt::format("limit '{}': {} ({}). Check it and its unit", limit.name, rule_text(limit), first.high_known));
    } else if (all([&](LimitRange const& range) { return limit.threshold < range.usual_low; })) {
        lines.push_back(
            fmt::format("limit '{}': {} ({}). Check it and its unit", limit.name, rule_text(limit), first.low_known));
    }
}

void add_limits(CampaignSpec const& spec, Lines& lines) {
    for (auto const& limit : spec.limits) {
        if (limit.rule != LimitState::Rule::above && limit.rule != LimitState::Rule::below) {
            continue;
        }
        std::vector<LimitRange> ranges;
        for (auto const& body : spec.bodies) {
            ranges.push_back(range_of(limit.quantity, body));
            if (auto const why = unreachable(limit, body); !why.empty()) {
                lines.push_back(fmt::format("limit '{}': {}", limit.name, why));
            } else if (passable(limit, ranges.back()) == Passable::none) {
                lines.push_back(fmt::format("limit '{}': no trial of {} passes {} but by falling", limit.name,
                                            body.name, rule_text(limit)));
            }
        }
        add_unusual_threshold(limit, ranges, lines);
    }
}

}  // namespace

std::vector<std::string> warnings_of(BodySpec const& body) {
    Lines lines;
    for (auto const& range : body_ranges) {
        double const value = range.of(body);
        if (value < range.low || value > range.high) {
            lines.push_back(
                fmt::format("{}: {} ({}). {}", body.name, range.said(body, value), range.known, range.remedy));
        }
    }
    return lines;
}

std::vector<std::string> implausible_statements(CampaignSpec const& spec) {
    Lines lines;
    add_design_basis(spec, lines);
    add_weak_levels(spec.levels, lines);
    add_limits(spec, lines);
    return lines;
}

std::vector<std::string> implausible_wave(CampaignSpec const& spec, WaveRow const& row, GroundMotion const& motion) {
    Lines lines;
    if (spec.source->about().available) {
        return lines;  // what was measured is as it is
    }
    if (row.vertical_pga_mps2 > row.pga_mps2) {
        lines.push_back(
            fmt::format("wave 0 is stronger vertically: {:.3g} m/s2 beside {:.3g} m/s2 (usual: half to two "
                        "thirds, near a fault up to 1). Check waves.vertical",
                        row.vertical_pga_mps2, row.pga_mps2));
    }
    constexpr double longest_s = 0.02;
    constexpr double rounding = 1e-9;
    if (motion.time_step_s > longest_s * (1 + rounding)) {
        lines.push_back(
            fmt::format("time step of {:g} s: nothing above {:.3g} Hz is in the waves (spectra are stated to 33 "
                        "or 50 Hz, pads and bodies move at 10 Hz and more). State waves.time_step = \"0.01 "
                        "s\"",
                        motion.time_step_s, 0.5 / motion.time_step_s));
    }
    return lines;
}

}  // namespace overturn
