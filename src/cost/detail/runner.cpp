#include "cost/detail/runner.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/elapsed.hpp"

namespace overturn::cost {
namespace {

// Relative errors of `values` against `exact`, `each` of them averaged into one.
Spread relative_errors(std::vector<double> const& values, std::vector<double> const& exact, std::size_t each) {
    std::vector<double> errors;
    if (each == 0) {
        return {};
    }
    for (std::size_t begin = 0; begin + each <= values.size(); begin += each) {
        double sum = 0;
        for (std::size_t i = begin; i < begin + each; ++i) {
            sum += exact[i] != 0 ? std::abs(values[i] / exact[i] - 1) : std::abs(values[i]);
        }
        errors.push_back(sum / static_cast<double>(each));
    }
    return spread_of(std::move(errors));
}

}  // namespace

Runner::Runner(CampaignInput const& input, std::int64_t waves, int rounds, double timing_s)
    : input_(input),
      timing_s_(timing_s),
      spec_(parse_campaign(input)),
      plan_(spec_),
      numbers_(spread_over(waves, plan_.waves())) {
    study_.title = spec_.title.empty() ? input.name : spec_.title;
    study_.waves = numbers_.size();
    study_.campaign_waves = plan_.waves();
    study_.campaign_trials = plan_.trials();
    study_.confidence = spec_.confidence;
    study_.continuous =
        std::ranges::any_of(spec_.bodies, [](BodySpec const& body) { return body.footing.base.continuous(); });
    for (auto& knob : knobs_of(input, spec_)) {
        study_.knobs.emplace_back().knob = std::move(knob);
    }
    list_steps(rounds);
}

Study Runner::run(std::function<void(Extent, double)> const& done) {
    for (auto const& step : steps_) {
        auto const begin = Clock::now();
        step.action();
        done(step.extent, seconds_since(begin));
    }
    return std::move(study_);
}

void Runner::list_steps(int rounds) {
    auto const add = [this](Extent extent, std::function<void()> action) {
        steps_.push_back({extent, std::move(action)});
    };
    add(Extent::all, [this] { make_sample(); });
    add(Extent::all, [this] { run_references(); });
    for (int round = 0; round < rounds; ++round) {
        for (auto& result : study_.knobs) {
            result.rows.resize(result.knob.settings.size());
            auto const extent = result.knob.acts == Acts::trials ? Extent::all : Extent::few;
            // The last setting of a matching knob is what the others are held against, so it comes first.
            for (std::size_t s = result.rows.size(); s-- > 0;) {
                add(extent, [this, &result, s, round] { measure(result, s, round == 0); });
            }
        }
    }
    add(Extent::all, [this] { study_.sampling = study_sampling(spec_, plan_, numbers_); });
    add(Extent::all, [this] { conclude(); });
}

void Runner::make_sample() {
    PhaseSeconds ignored;
    for (auto const number : numbers_) {
        waves_.waves.push_back(prepare_wave(spec_, plan_, number, ignored));
    }
    for (auto const place : spread_over(most_wave_units, numbers_.size())) {
        few_.waves.push_back(waves_.waves[place]);
    }
}

void Runner::run_references() {
    auto const exact = [&](std::vector<std::string> const& settings) {
        return run_trials(parse_campaign(with(input_, settings)), plan_, waves_.waves);
    };
    auto trials = exact(reference_settings());
    study_.reference_seconds = trials.seconds / static_cast<double>(std::max<std::int64_t>(1, trials.units));
    auto const& reference = references_[reference_settings()] = std::move(trials.rows);
    auto const* of_defaults = &reference;
    for (auto const& result : study_.knobs) {
        auto const& knob = result.knob;
        if (knob.acts == Acts::trials) {
            auto const [held_against, is_new] = references_.try_emplace(knob.reference);
            if (is_new) {
                held_against->second = exact(knob.reference).rows;
            }
            of_defaults = knob.name == contact_step ? &held_against->second : of_defaults;
        }
    }
    if (spec_.measures.energy) {
        exact_ou_v_e_ = run_energy(few_, reference_panel_phase_rad, Acts::ou_v_e).values;
        exact_v_wes_ = run_energy(few_, reference_panel_phase_rad, Acts::v_wes).values;
    }
    exact_spectra_ = run_spectra(few_, reference_periods_per_decade, Depth::whole).values;
    study_.rounding = compare(exact(second_reference_settings()).rows, reference);
    auto const own = run_trials(spec_, plan_, waves_.waves).rows;
    study_.trials = own.size();
    study_.defaults = compare(own, *of_defaults);
    study_.step_error = study_step_error(input_, spec_, plan_, waves_.waves);
}

Run Runner::run_setting(Knob const& knob, Setting const& setting, CampaignSpec const& variant, Depth depth) const {
    switch (knob.acts) {
        case Acts::spectra:
            return run_spectra(few_, setting.value, depth);
        case Acts::trials:
            return run_trials(variant, plan_, waves_.waves);
        case Acts::waves:
            return run_matching(few_, input_, variant, depth);
        default:
            return run_energy(few_, variant.measures.panel_phase_rad, knob.acts);
    }
}

void Runner::measure(KnobResult& result, std::size_t s, bool first) {
    auto& row = result.rows[s];
    auto const& setting = result.knob.settings[s];
    auto const variant = parse_campaign(with(input_, setting.settings));
    auto const run = run_setting(result.knob, setting, variant, first ? Depth::whole : Depth::times);
    double best = run.seconds;
    for (double spent = run.seconds; spent < timing_s_ && best > 0;) {
        double const again = run_setting(result.knob, setting, variant, Depth::times).seconds;
        best = std::min(best, again);
        spent += std::max(again, 0.5 * run.seconds);
    }
    double const each = best / static_cast<double>(std::max<std::int64_t>(1, run.units));
    row.seconds = first ? each : std::min(row.seconds, each);
    if (first) {
        row.setting = setting;
        result.units = run.units;
        judge(result, s, run);
    }
}

void Runner::judge(KnobResult& result, std::size_t s, Run const& run) {
    auto& row = result.rows[s];
    switch (result.knob.acts) {
        case Acts::trials:
            take_verdicts(row, result.knob, run.rows, references_.at(result.knob.reference));
            break;
        case Acts::waves:
            if (s + 1 == result.rows.size()) {
                best_matched_ = run.rows;
            }
            take_verdicts(row, result.knob, run.rows, best_matched_);
            row.error = spread_of(run.values);
            break;
        case Acts::spectra:
            row.error =
                relative_errors(run.values, exact_spectra_,
                                exact_spectra_.size() / static_cast<std::size_t>(std::max<std::int64_t>(1, run.units)));
            break;
        case Acts::ou_v_e:
        case Acts::v_wes:
            auto const& exact = result.knob.acts == Acts::ou_v_e ? exact_ou_v_e_ : exact_v_wes_;
            row.error = relative_errors(run.values, exact, 1);
            count_criterion_flips(row, run.values, exact);
            break;
    }
}

// Bodies that a knob leaves as they are would only thin out its errors.
void Runner::take_verdicts(Measured& row, Knob const& knob, std::vector<TrialRow> const& rows,
                           std::vector<TrialRow> const& exact) {
    auto const touched = [&](std::vector<TrialRow> all) {
        std::erase_if(all, [&](TrialRow const& one) { return !knob.bodies.contains(one.body); });
        return all;
    };
    auto const comparison = knob.bodies.empty() ? compare(rows, exact) : compare(touched(rows), touched(exact));
    row.error = comparison.peak;
    row.trials = comparison.trials;
    row.flips = comparison.flips;
    row.overturning_flips = comparison.overturning_flips;
    row.probability_error = comparison.probability_error;
    row.ks = comparison.ks;
}

// Trials in which the criterion "measure < V_Ereq" says something else.
void Runner::count_criterion_flips(Measured& row, std::vector<double> const& values, std::vector<double> const& exact) {
    std::size_t at = 0;
    for (auto const& wave : few_.waves) {
        if (wave.row.failed != 0) {
            continue;
        }
        auto const first = plan_.first_level(wave.number);
        for (auto const& drawn : wave.bodies) {
            for (auto level = first; level < first + plan_.level_count(); ++level) {
                auto const scale = spec_.levels.scale(spec_.levels.levels[level], wave.row);
                if (scale) {
                    double const limit = drawn.body.limit_velocity_mps();
                    ++row.trials;
                    row.flips += (*scale * values[at] < limit) != (*scale * exact[at] < limit) ? 1 : 0;
                }
            }
            ++at;
        }
    }
}

// The campaign as it stands is the same run in every knob that acts on the same: it has one time.
void Runner::share_own_times() {
    for (auto const acts : {Acts::trials, Acts::waves}) {
        double best = std::numeric_limits<double>::infinity();
        for (int pass = 0; pass < 2; ++pass) {
            for (auto& result : study_.knobs) {
                if (result.knob.acts == acts && result.knob.here) {
                    auto& own = result.rows[*result.knob.here].seconds;
                    best = std::min(best, own);
                    own = best;
                }
            }
        }
    }
}

void Runner::conclude() {
    share_own_times();
    for (auto& result : study_.knobs) {
        constexpr double digits = 1e-14;
        result.floor = result.knob.acts == Acts::trials && study_.rounding.peak.count > 0
                           ? std::max(digits, study_.rounding.peak.p95)
                           : digits;
        std::vector<Point> points;
        points.reserve(result.rows.size());
        for (auto const& row : result.rows) {
            points.push_back(point_of(row, result.floor));
        }
        auto const front = pareto_front(points, noise);
        for (std::size_t i = 0; i < front.size(); ++i) {
            result.rows[i].on_front = front[i];
            result.rows[i].here = result.knob.here == i;
        }
        result.advice = advice_of(result);
    }
    study_.balance = balance_of(study_.defaults, study_.sampling.half_width, spec_.confidence);
    study_.is_grid = spec_.is_grid();
    study_.effect = largest_effect(study_.knobs);
    study_.sentence = sentence_of(study_.balance, study_.defaults, spec_, study_.sampling.stripes);
}

}  // namespace overturn::cost
