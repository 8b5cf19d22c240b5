#include "campaign/warnings.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "campaign/detail/kept_of_seeds.hpp"
#include "campaign/detail/limit_spec.hpp"
#include "campaign/detail/measured_drifts.hpp"
#include "campaign/detail/plausible.hpp"
#include "campaign/detail/scaled_records.hpp"
#include "campaign/moves_in_space.hpp"
#include "campaign/plan.hpp"
#include "campaign/rocking_band.hpp"
#include "campaign/trial.hpp"
#include "campaign/typed_units.hpp"
#include "core/units.hpp"
#include "motion/usual_time_step.hpp"
#include "response/registry.hpp"

namespace overturn {
namespace {

using Lines = std::vector<std::string>;

void add_drifts(CampaignSpec const& spec, Lines& lines) {
    std::int64_t count = 0;
    bool warned = false;
    std::string first;
    auto const units = motion_units(typed_units(spec));
    each_drift(spec, [&](std::int64_t wave, Drift const& drift) {
        if (drift.any_excessive() && count++ == 0) {
            first = fmt::format("{} {}", spec.source->called(wave), drift.text(units));
        }
    });
    constexpr double mostly = 0.5;
    each_drift(spec, [&](std::int64_t wave, Drift const& drift) {
        bool const away = std::abs(drift.end_displacement_m) > mostly * drift.pgd_m;
        if (spec.levels.measure == measure_named("pgd") && away && !warned) {
            warned = true;
            lines.push_back(fmt::format(
                "{} {}: levels by pgd scale by what it is left at, fling or drift. State waves.baseline if it "
                "is drift",
                spec.source->called(wave), drift.text(units)));
        }
    });
    if (count > 0) {
        lines.push_back(
            fmt::format("{}{}: the baseline drifts, and PGV, PGD and long-period energy with it. State "
                        "waves.baseline, for example {{high_pass = \"0.05 Hz\"}}",
                        first, count > 1 ? fmt::format(", and {} more", count - 1) : ""));
    }
}

void add_targets(CampaignSpec const& spec, Lines& lines) {
    auto const judged = spec.source->about().compared_periods;
    for (auto const& body : spec.bodies) {
        auto const band = rocking_band(body.body, spec.measures.radius_unit);
        if (judged && ends_inside(*judged, band)) {
            lines.push_back(
                fmt::format("waves are compared with their target from {:.3g} s to {:.3g} s only, but {} rocks at "
                            "{:.2f} s to {:.2f} s: waves are not controlled outside the compared periods. State the "
                            "target over all of these periods, and waves.target.longest no shorter",
                            judged->from_s, judged->to_s, body.name, band.t0_s, band.t1_s));
        }
    }
}

void add_first_wave(CampaignSpec const& spec, Lines& lines) {
    constexpr double implausible_mps2 = 10 * g0;
    PhaseSeconds seconds;
    auto const wave = prepare_wave(spec, Plan(spec), 0, seconds);
    if (wave.row.failed == 0) {
        double const peak = wave.row.pga_mps2;
        if (peak > implausible_mps2) {
            lines.push_back(
                fmt::format("wave 0 peaks at {:.4g} g before any scaling (no ground has shaken so). Check the "
                            "unit of its target or amplitude",
                            peak / g0));
        } else if (spec.levels.measure == measure_named("factor")) {
            double const highest = spec.levels.levels.back().value;
            constexpr double weakest_mps2 = 0.1;
            if (peak * highest > implausible_mps2) {
                lines.push_back(
                    fmt::format("wave 0 peaks at {:.4g} g at the highest level, factor {:g} (no ground has "
                                "shaken so). Check levels.values",
                                peak * highest / g0, highest));
            } else if (peak > 0 && peak * highest < weakest_mps2) {
                lines.push_back(
                    fmt::format("wave 0 peaks at {:.4g} gal even at the highest level, factor {:g} (nothing "
                                "rocks). Check the unit of its target or amplitude",
                                100 * peak * highest, highest));
            }
        }
        for (auto& line : implausible_wave(spec, wave.row, wave.motion)) {
            lines.push_back(std::move(line));
        }
        auto const more = warnings_of_effects(spec, wave, ModelSelector(spec.effects, spec.accuracy));
        lines.insert(lines.end(), more.begin(), more.end());
    }  // else its trials will say why
}

// The model on which trials of this body go on, beyond two rigid corners; null: they stay there.
ModelTraits const* model_beyond_corners(CampaignSpec const& spec, BodySpec const& body) {
    auto const bed = mask_of(Effect::contact);
    bool const stated = body.footing.stated || has(spec.effects.include, Effect::contact);
    auto const brings = may_move_in_space(spec, body)                  ? mask_of(Effect::spatial)
                        : stated && (spec.effects.wanted() & bed) != 0 ? bed
                                                                       : 0;
    auto const entry = std::ranges::find_if(
        models(), [&](ModelEntry const& model) { return (model.traits().brings() & brings) != 0; });
    return entry == models().end() ? nullptr : &entry->traits();
}

void add_limits(CampaignSpec const& spec, Lines& lines) {
    for (auto const& limit : spec.limits) {
        if (limit.rule != LimitState::Rule::above && limit.rule != LimitState::Rule::below) {
            continue;
        }
        auto const& quantity = limit.quantity;
        for (auto const& body : spec.bodies) {
            bool const calls_space = (quantity.needs & mask_of(Effect::spatial)) != 0;  // the limit itself does
            auto const* const model =
                calls_space && !quantity.of_every_model ? nullptr : model_beyond_corners(spec, body);
            if (model != nullptr && !model->computes(quantity.name, quantity.of_every_model)) {
                lines.push_back(
                    fmt::format("limit {}: trials of {} on points or in space have no {}, so they have no verdict "
                                "unless they overturn. Use another quantity, for example peak_rotation",
                                limit.name, body.name, quantity.name));
            }
        }
    }
}

void add_rare(CampaignSpec const& spec, Lines& lines) {
    if (spec.rare && !spec.source->from_normals()->linear()) {
        lines.push_back(fmt::format(
            "rare events of waves that differ by {}: P holds for such waves only, not for motions that differ more",
            spec.source->about().variability));
    }
}

void add_motions(CampaignSpec const& spec, Lines& lines) {
    constexpr std::uint64_t most = 1000;
    if (!spec.source->about().available || !spec.source->drift(0)) {
        return;
    }
    auto const count = std::min(most, static_cast<std::uint64_t>(spec.wave_count));
    for (std::uint64_t wave = 0; wave < count; ++wave) {
        for (auto const& line : warnings_of(spec.source->make(spec.seed, wave).motion)) {
            lines.push_back(fmt::format("{}: {}", spec.source->called(wave), line));
            return;  // the first is enough
        }
    }
}

// Components of one station and event are felt by one cask at one time.
std::string warning_of_shared_recordings(WaveSource const& source) {
    auto const& shared = source.about().shared;
    auto const waves = std::ssize(shared.of);
    std::int64_t second = 1;
    while (std::ranges::find(shared.of.begin(), shared.of.begin() + second, shared(second))
           == shared.of.begin() + second) {
        ++second;
    }
    auto const first = std::ranges::find(shared.of, shared(second)) - shared.of.begin();
    auto const name = [&](std::int64_t wave) {
        auto const at = static_cast<std::size_t>(wave);
        auto const& about = source.about();
        return about.measured.empty() ? about.began_with_names[at] : about.measured[at].name;
    };
    return fmt::format(
        "{} are components of one recording: {} rows, {} recordings. They are resampled together, and {:.3g} "
        "rows count as one in intervals. Keep one row of each. Are they of different recordings, "
        "rename one",
        name(first) == name(second) ? fmt::format("Two rows of '{}'", name(first))
                                    : fmt::format("'{}' and '{}'", name(first), name(second)),
        waves, shared.among(waves), shared.effect());
}

}  // namespace

std::string warning_of_shared_draws(CampaignSpec const& spec) {
    auto const& shared = spec.source->about().shared;
    if (shared.most == 1) {
        return {};
    }
    if (!shared.of.empty()) {
        return warning_of_shared_recordings(*spec.source);
    }
    return fmt::format(
        "Groups of {0} waves share a drawn target. They are resampled together and count as one wave "
        "in intervals of proportions; this is conservative. Use independent waves (per_target = 1, "
        "targets_per_event = 1) for narrower intervals",
        shared.most);
}

std::vector<std::string> warnings_of_stated_effects(BodySpec const& body, GroundMotion const& motion,
                                                    EffectRequest const& effects) {
    struct Stated {
        EffectMask held_by;  // any of these effects
        char const* missing;
        bool holds;
        char const* what;
        char const* then;
    };
    auto const on_bed = mask_of(Effect::contact) | mask_of(Effect::spatial);
    bool const points_grip = (effects.wanted() & on_bed) != 0;
    std::array const all{
        Stated{mask_of(Effect::sliding), "sliding", body.friction.has_value(), "its friction is stated",
               points_grip ? "it does not slip, its points grip without limit: what its slip says is their spring"
                           : "it does not slip"},
        Stated{on_bed, "contact", body.footing.stated, "its base or pad is stated", "it turns about two rigid corners"},
        Stated{mask_of(Effect::spatial), "spatial", body.axes > 1 && !motion.transverse_mps2.empty(),
               "the wave has a second component", "it moves in one plane"},
        Stated{mask_of(Effect::vertical), "vertical", body.axes > 2 && !motion.vertical_mps2.empty(),
               "the wave has a vertical component", "the ground does not move vertically"}};
    Lines lines;
    for (auto const& stated : all) {
        if (stated.holds && (effects.wanted() & stated.held_by) == 0) {
            lines.push_back(fmt::format("{}: {} ({}, but effects ({}) leave {} out). Add {} if it should count",
                                        body.name, stated.then, stated.what, text_of(effects), stated.missing,
                                        stated.missing));
        }
    }
    if (!body.friction && points_grip && (effects.wanted() & mask_of(Effect::sliding)) == 0) {
        lines.push_back(fmt::format(
            "{}: its points grip without limit, because no friction is stated: what its slip says is their spring. "
            "State friction, and add sliding to the effects, if it may slip",
            body.name));
    }
    bool const in_space = body.axes > 1 && !motion.transverse_mps2.empty();
    if (body.friction && (body.footing.stated || in_space) && (effects.wanted() & on_bed) != 0) {
        double const slope = body.body.half_width_m() / body.body.centre_height_m();
        double const held = body.friction->static_coefficient;
        double const slips = body.friction->kinetic_coefficient;
        if (slips < slope && slope <= held) {
            lines.push_back(
                fmt::format("{0}: it slides where it would rock first, because on points and in space it grips by its "
                            "kinetic friction {1:.4g} alone, which is below tan(alpha) {2:.4g}; its static one {3:.4g} "
                            "is above. Compute it with friction = {3:.4g} too, and take the worse",
                            body.name, slips, slope, held));
        }
    }
    if (has(effects.include, Effect::vertical) && (body.axes < 3 || motion.vertical_mps2.empty())) {
        lines.push_back(fmt::format(
            "{}: the ground does not move vertically ({}). State a vertical component, or leave vertical out of "
            "effects",
            body.name, body.axes < 3 ? fmt::format("axes = {}", body.axes) : "the wave has no vertical component"));
    }
    return lines;
}

std::vector<std::string> warnings_of_effects(CampaignSpec const& spec, PreparedWave const& wave,
                                             ModelSelector const& selector) {
    Lines lines;
    auto const scale = spec.levels.scale(spec.levels.levels.back(), wave.row);
    for (std::size_t b = 0; b < spec.bodies.size(); ++b) {
        auto const& body = spec.bodies[b];
        Scene const scene{wave.bodies[b].body, wave.bodies[b].friction, body.footing, body.axes};
        auto const lost = scale ? selector.left_out({scene, wave.motion, *scale}) : 0;
        if (lost != 0) {
            lines.push_back(
                fmt::format("{} requires {}, but no model supports it together with the other required effects: it is "
                            "not simulated (reason left-out). State effects.include or change the body",
                            body.name, names_of_effects(lost)));
        }
        if (body.axes > 1 && !wave.motion.transverse_mps2.empty() && !body.footing.stated) {
            lines.push_back(
                fmt::format("{}: base not stated: square, on its four corners. A round base rolls under two components "
                            "and overturns at lower levels. State base = {{shape = \"round\"}} or \"square\"",
                            body.name));
        }
        for (auto& line : warnings_of_stated_effects(body, wave.motion, spec.effects)) {
            lines.push_back(std::move(line));
        }
    }
    return lines;
}

std::vector<std::string> warnings_of(GroundMotion const& motion) {
    Lines lines;
    constexpr std::size_t fewest = 50;
    if (auto const step = unusual_time_step(motion.time_step_s); !step.empty()) {
        lines.push_back(step + ". Check the step and its unit");
    }
    if (motion.samples() < fewest) {
        lines.push_back(fmt::format("{} samples only, {:g} s (hardly an earthquake). Check what was read",
                                    motion.samples(), motion.duration_s()));
    }
    return lines;
}

bool ends_inside(ComparedPeriods const& judged, PeriodBand const& band) {
    constexpr double rounding = 1e-9;
    return judged.to_s < band.t1_s * (1 - rounding) || judged.from_s > band.t0_s * (1 + rounding);
}

std::vector<std::string> warnings_of(CampaignSpec const& spec) {
    Lines lines;
    add_drifts(spec, lines);
    if (auto scaled = warning_of_scaled_records(spec); !scaled.empty()) {
        lines.push_back(std::move(scaled));
    }
    if (auto lost = warning_of_lost_periods(spec); !lost.empty()) {
        lines.push_back(std::move(lost));
    }
    add_targets(spec, lines);
    add_first_wave(spec, lines);
    for (auto& line : implausible_statements(spec)) {
        lines.push_back(std::move(line));
    }
    if (auto shared = warning_of_shared_draws(spec); !shared.empty()) {
        lines.push_back(std::move(shared));
    }
    add_limits(spec, lines);
    add_rare(spec, lines);
    add_motions(spec, lines);
    for (auto const& body : spec.bodies) {
        auto const more = warnings_of(body);
        lines.insert(lines.end(), more.begin(), more.end());
    }
    return lines;
}

std::vector<std::string> ends_of_records(CampaignSpec const& spec) {
    constexpr std::int64_t most = 20;
    Lines lines;
    auto const units = typed_units(spec);
    each_drift(spec, [&](std::int64_t wave, Drift const& drift) {
        if (wave < most) {
            lines.push_back(fmt::format("{}: PGV {}, PGD {}, {}", wave, units.velocity.text(drift.pgv_mps),
                                        units.length.text(drift.pgd_m), drift.text(motion_units(units))));
        }
    });
    return lines;
}

}  // namespace overturn
