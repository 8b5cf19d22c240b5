#include "campaign/detail/plausible.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string_view>

#include <fmt/format.h>

#include "campaign/detail/limit_range.hpp"
#include "campaign/detail/limit_spec.hpp"
#include "campaign/moves_in_space.hpp"
#include "campaign/site.hpp"
#include "core/units.hpp"
#include "core/usual_range.hpp"

namespace overturn {
namespace {

using Lines = std::vector<std::string>;

constexpr double closeness = 0.02;  // as near are two statements of one level

// A spectrum of 1 g is a shape for any design basis: RG 1.60 is printed so, and many files are normalised.
bool is_shape(TargetPga const& target) {
    constexpr double digits = 1e-3;
    return std::abs(target.ordinate_mps2 / g0 - 1) < digits;
}

// Levels by another measure than pga cannot be compared with it.
void add_other_pga(LevelSpec const& levels, double basis, TargetPga const& target, Lines& lines) {
    bool const near = basis >= target.least_mps2 * (1 - closeness) && basis <= target.most_mps2 * (1 + closeness);
    if (levels.measure == measure_named("pga") && !near && !is_shape(target)) {
        lines.push_back(
            fmt::format("design basis {}, but the target spectrum has {} at {} (waves are scaled to the design basis, "
                        "and take only their shape from the spectrum). If both are one earthquake, correct "
                        "levels.design_basis, or pga, unit or scale of waves.target",
                        levels.text(basis), levels.text(target.ordinate_mps2),
                        target.period_s > 0 ? fmt::format("its shortest period, {:.3g} s", target.period_s)
                                            : std::string("period 0")));
    }
}

// Factor 1 is the target as it is stated.
void add_other_factor(LevelSpec const& levels, double basis, std::optional<TargetPga> const& target, Lines& lines) {
    bool const shape = target && is_shape(*target);
    if (levels.measure == measure_named("factor") && std::abs(basis - 1) > closeness && !shape) {
        lines.push_back(
            fmt::format("design basis factor {} (factor 1 is the motion as it is stated). State that of "
                        "the design basis, and factor 1, if they are the same earthquake",
                        levels.text(basis)));
    }
}

void add_design_basis(CampaignSpec const& spec, Lines& lines) {
    auto const& levels = spec.levels;
    auto const* const basis = levels.design_basis();
    if (basis == nullptr) {
        return;
    }
    auto const& target = spec.source->about().target_pga;
    add_other_factor(levels, basis->value, target, lines);
    if (target) {
        add_other_pga(levels, basis->value, *target, lines);
    }
}

// The acceleration that some body needs to slip or to rise, of those that say so [m/s2].
double least_that_moves(CampaignSpec const& spec) {
    double least = std::numeric_limits<double>::infinity();
    for (auto const& body : spec.bodies) {
        auto const& friction = body.friction;
        least = std::min(least, body.body.uplift_acceleration_mps2());
        least = std::min(least, friction ? body.body.gravity_mps2() * friction->static_coefficient : least);
    }
    return least;
}

// Numbers that nobody gave a unit, so small that no body moves: of g?
void add_motionless(CampaignSpec const& spec, Lines& lines) {
    auto const& levels = spec.levels;
    double const highest = levels.levels.back().value;
    double const least = least_that_moves(spec);
    if (levels.measure == measure_named("pga") && levels.stated_unit.empty() && highest < least) {
        lines.push_back(fmt::format(
            "levels up to pga {:g} m/s2 = {:.2g} g (a bare number is SI, and no body slips or rises below {:.3g} "
            "m/s2). Write \"{:g} g\" if that was meant",
            highest, highest / g0, least, highest));
    }
}

// Beyond anything felt, by a factor of some two, or too weak to move anything: a unit was left out, or another.
void add_levels(LevelSpec const& levels, Lines& lines) {
    auto const& usual = levels.measure->plausible;
    double const highest = levels.levels.back().value;
    bool const bare = levels.stated_unit.empty();
    if (usual.most > 0 && highest > usual.most) {
        lines.push_back(fmt::format("levels up to {} {:g} {} = {:g} {} ({}{}). {}", levels.measure_name(), highest,
                                    levels.units(), highest / usual.unit_si, usual.unit, usual.known,
                                    bare ? "; a bare number is SI" : "",
                                    bare ? fmt::format("Write \"{:g} {}\" if that was meant", highest, usual.unit)
                                         : fmt::format("Check the unit, {}", levels.stated_unit)));
    } else if (highest < usual.least) {
        lines.push_back(fmt::format("levels up to {} {} (casks do not move below {:g} {}). Check the unit",
                                    levels.measure_name(), levels.text(highest), usual.least / usual.unit_si,
                                    usual.unit));
    }
    if (levels.falling) {
        lines.push_back(fmt::format("level {} is listed behind {} (levels are sorted). Check that it is meant",
                                    levels.text(levels.falling->second), levels.text(levels.falling->first)));
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

// Of a body that has not moved yet: how near what stands round it is.
double room_at_rest(std::string_view quantity, Site const& site) {
    auto const nearest = [](Sides const& sides) { return std::ranges::min(sides.m); };
    return quantity == "least_clearance" ? std::min(nearest(site.cask), nearest(site.wall))
           : quantity == "edge_margin"   ? nearest(site.edge)
                                         : std::numeric_limits<double>::infinity();
}

void add_no_room(LimitState const& limit, Site const& site, Lines& lines) {
    double const room_m = room_at_rest(limit.quantity.name, site);
    auto const& unit = limit.shown;
    if (limit.rule == LimitState::Rule::below && limit.threshold > room_m) {
        lines.push_back(fmt::format("limit '{}': {} is passed by a body at rest, which has {:.4g} {}. Lower it",
                                    limit.name, rule_text(limit), unit.of(room_m),
                                    unit.symbol.empty() ? "m" : unit.symbol));
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
        add_no_room(limit, spec.site, lines);
    }
}

struct DrawnWave {
    CampaignSpec const& spec;
    WaveRow const& row;
    GroundMotion const& motion;
};

// Of a component that there is, over the horizontal one.
double share_of(DrawnWave const& wave, std::vector<double> const& component) {
    return wave.row.pga_mps2 > 0 && !component.empty() ? peak_of(component) / wave.row.pga_mps2 : never;
}
double vertical_share(DrawnWave const& wave) { return share_of(wave, wave.motion.vertical_mps2); }
double transverse_share(DrawnWave const& wave) { return share_of(wave, wave.motion.transverse_mps2); }
double step(DrawnWave const& wave) { return wave.motion.time_step_s; }

// At the highest level, over the most that is plausible of the measure; of levels by it they tell.
double of_most(DrawnWave const& wave, Measure measure, double value) {
    auto const& levels = wave.spec.levels;
    auto const scale = levels.scale(levels.levels.back(), wave.row);
    bool const asked = scale && levels.measure != measure;
    return asked ? value * *scale / measure->plausible.most : never;
}
double velocity_of_most(DrawnWave const& wave) { return of_most(wave, measure_named("pgv"), wave.row.pgv_mps); }
double travel_of_most(DrawnWave const& wave) { return of_most(wave, measure_named("pgd"), wave.row.pgd_m); }
std::string velocity_text(DrawnWave const& /*wave*/, double share) {
    return fmt::format("wave 0 reaches {:.3g} m/s at the highest level", share * measure_named("pgv")->plausible.most);
}
std::string travel_text(DrawnWave const& /*wave*/, double share) {
    return fmt::format("wave 0 moves the ground by {:.3g} m at the highest level",
                       share * measure_named("pgd")->plausible.most);
}

std::string vertical_text(DrawnWave const& wave, double share) {
    return fmt::format("wave 0 is {} vertically: {:.3g} m/s2 beside {:.3g} m/s2", share > 1 ? "stronger" : "very weak",
                       share * wave.row.pga_mps2, wave.row.pga_mps2);
}
std::string transverse_text(DrawnWave const& wave, double share) {
    return fmt::format("wave 0 is {:.3g} times as strong across: {:.3g} m/s2 beside {:.3g} m/s2", share,
                       share * wave.row.pga_mps2, wave.row.pga_mps2);
}
std::string step_text(DrawnWave const& /*wave*/, double step_s) {
    return fmt::format("time step of {:g} s: nothing above {:.3g} Hz is in the waves", step_s, 0.5 / step_s);
}

constexpr std::string_view of_slow = "Check the levels, and periods and their unit";
constexpr double drawn_apart = 1.25;  // of one spectrum, by chance
constexpr double rounding = 1e-9;
constexpr std::array wave_ranges{
    UsualRange<DrawnWave>{&vertical_share, 0.1, drawn_apart, &vertical_text,
                          "usual: half to two thirds, near a fault up to 1", "Check waves.vertical"},
    UsualRange<DrawnWave>{&transverse_share, 0.25, 2, &transverse_text, "horizontal components differ little",
                          "Check waves.transverse"},
    UsualRange<DrawnWave>{&step, 0, 0.02 + rounding, &step_text,
                          "spectra are stated to 33 or 50 Hz, pads and bodies move at 10 Hz and more",
                          "State waves.time_step = \"0.01 s\""},
    UsualRange<DrawnWave>{&velocity_of_most, 0, 1, &velocity_text, measure_named("pgv")->plausible.known, of_slow},
    UsualRange<DrawnWave>{&travel_of_most, 0, 1, &travel_text, measure_named("pgd")->plausible.known, of_slow}};

// In space the points of a square bed count in both directions.
void add_coarser_beds(CampaignSpec const& spec, Lines& lines) {
    constexpr int most = BasePlan::most_across_in_space;
    for (auto const& body : spec.bodies) {
        auto const& base = body.stated_footing.base;
        if (base.is_bed() && base.points > most && may_move_in_space(spec, body)) {
            lines.push_back(
                fmt::format("body {}: base.points {} (under two horizontal components a bed has {} by {} at "
                            "most, and counts as that). State {}, or a round base, which has no points",
                            body.name, base.points, most, most, most));
        }
    }
}

}  // namespace

std::vector<std::string> implausible_statements(CampaignSpec const& spec) {
    auto lines = implausible_keys(spec);
    add_coarser_beds(spec, lines);
    add_design_basis(spec, lines);
    add_levels(spec.levels, lines);
    add_motionless(spec, lines);
    add_limits(spec, lines);
    return lines;
}

std::vector<std::string> implausible_wave(CampaignSpec const& spec, WaveRow const& row, GroundMotion const& motion) {
    // What was measured is as it is.
    return spec.source->about().measured.empty()
               ? unusual(DrawnWave{spec, row, motion}, std::span<UsualRange<DrawnWave> const>(wave_ranges))
               : Lines{};
}

}  // namespace overturn
