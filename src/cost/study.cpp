#include "cost/study.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numeric>

namespace overturn::cost {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

constexpr int timings = 2;                   // a time is the best of them
constexpr std::int64_t fewest_waves = 4;     // unless stated
constexpr std::int64_t most_waves = 2000;    // of a sample: they are held in memory
constexpr std::int64_t most_wave_units = 8;  // waves for the knobs that act on waves: one wave is much like another

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

/// What a step's time grows with.
enum class Extent { all, few };

struct Step {
    Extent extent;
    std::function<void()> action;
};

/// What one step took when it was tried on a few waves.
struct Taken {
    Extent extent;
    double seconds;
};

/// The whole study as steps, each of them short, so that what is left can be told.
class Runner {
  public:
    Runner(CampaignInput const& input, std::int64_t waves, int rounds, double timing_s)
        : input_(input),
          timing_s_(timing_s),
          spec_(parse_campaign(input)),
          plan_(spec_),
          numbers_(spread_over(waves, plan_.waves())) {
        study_.title = spec_.title.empty() ? input.name : spec_.title;
        study_.waves = static_cast<std::int64_t>(numbers_.size());
        study_.campaign_waves = plan_.waves();
        study_.campaign_trials = plan_.trials();
        study_.confidence = spec_.confidence;
        for (auto& knob : knobs_of(input, spec_)) {
            study_.knobs.emplace_back().knob = std::move(knob);
        }
        list_steps(rounds);
    }

    /// \param done called after each step with its extent and seconds
    template <class Done> Study run(Done&& done) {
        for (std::size_t i = 0; i < steps_.size(); ++i) {
            auto const begin = Clock::now();
            steps_[i].action();
            done(steps_[i].extent, seconds_since(begin));
        }
        return std::move(study_);
    }

  private:
    void list_steps(int rounds) {
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

    void make_sample() {
        PhaseSeconds ignored;
        for (auto const number : numbers_) {
            waves_.waves.push_back(prepare_wave(spec_, plan_, number, ignored));
        }
        for (auto const place : spread_over(most_wave_units, static_cast<std::int64_t>(numbers_.size()))) {
            few_.waves.push_back(waves_.waves[static_cast<std::size_t>(place)]);
        }
    }

    void run_references() {
        auto const exact = [&](std::vector<std::string> const& settings) {
            return run_trials(parse_campaign(with(input_, settings)), plan_, waves_.waves);
        };
        auto trials = exact(reference_settings());
        study_.reference_seconds = trials.seconds / static_cast<double>(std::max<std::int64_t>(1, trials.units));
        reference_ = std::move(trials.rows);
        effects_reference_ =
            spec_.effects.mode == EffectMode::automatic ? reference_ : exact(effects_reference_settings()).rows;
        exact_ou_v_e_ = run_energy(few_, reference_panel_phase_rad, Acts::ou_v_e).values;
        exact_v_wes_ = run_energy(few_, reference_panel_phase_rad, Acts::v_wes).values;
        exact_spectra_ = run_spectra(few_, reference_periods_per_decade, Depth::whole).values;
        study_.rounding = compare(exact(second_reference_settings()).rows, reference_);
        auto const own = run_trials(spec_, plan_, waves_.waves).rows;
        study_.trials = static_cast<std::int64_t>(own.size());
        study_.defaults = compare(own, reference_);
    }

    [[nodiscard]] Run run_setting(Knob const& knob, Setting const& setting, CampaignSpec const& variant,
                                  Depth depth) const {
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

    void measure(KnobResult& result, std::size_t s, bool first) {
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
        if (!first) {
            return;
        }
        row.setting = result.knob.settings[s];
        result.units = run.units;
        switch (result.knob.acts) {
            case Acts::trials:
                take_verdicts(row, run.rows, result.knob.name == "effects" ? effects_reference_ : reference_);
                break;
            case Acts::waves:
                if (s + 1 == result.rows.size()) {
                    best_matched_ = run.rows;
                }
                take_verdicts(row, run.rows, best_matched_);
                row.error = spread_of(run.values);
                break;
            case Acts::spectra:
                row.error = relative_errors(
                    run.values, exact_spectra_,
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

    static void take_verdicts(Measured& row, std::vector<TrialRow> const& rows, std::vector<TrialRow> const& exact) {
        auto const comparison = compare(rows, exact);
        row.error = comparison.peak;
        row.trials = comparison.trials;
        row.flips = comparison.flips;
        row.overturning_flips = comparison.overturning_flips;
        row.probability_error = comparison.probability_error;
        row.ks = comparison.ks;
    }

    // Trials in which the criterion "measure < V_Ereq" says something else.
    void count_criterion_flips(Measured& row, std::vector<double> const& values, std::vector<double> const& exact) {
        std::size_t at = 0;
        for (auto const& wave : few_.waves) {
            if (wave.row.failed != 0) {
                continue;
            }
            auto const first = plan_.first_level(wave.number);
            for (auto const& body : wave.bodies) {
                for (auto level = first; level < first + plan_.level_count(); ++level) {
                    auto const scale =
                        spec_.levels.scale(spec_.levels.levels[static_cast<std::size_t>(level)], wave.intensity);
                    if (scale) {
                        double const limit = body.limit_velocity_mps();
                        ++row.trials;
                        row.flips += (*scale * values[at] < limit) != (*scale * exact[at] < limit) ? 1 : 0;
                    }
                }
                ++at;
            }
        }
    }

    // The campaign as it stands is the same run in every knob that acts on the same: it has one time.
    void share_own_times() {
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

    void conclude() {
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
            }
            result.advice = advice_of(result);
        }
        study_.balance = balance_of(study_.defaults, study_.sampling.half_width, spec_.confidence);
        study_.sentence = sentence_of(study_.balance, study_.defaults, spec_, study_.sampling.stripes);
    }

    CampaignInput const& input_;
    double timing_s_;
    CampaignSpec spec_;
    Plan plan_;
    std::vector<std::int64_t> numbers_;
    Sample waves_{spec_, plan_, {}};
    Sample few_{spec_, plan_, {}};  // for the knobs that act on waves
    std::vector<TrialRow> reference_, effects_reference_, best_matched_;
    std::vector<double> exact_ou_v_e_, exact_v_wes_, exact_spectra_;
    std::vector<Step> steps_;
    Study study_;
};

}  // namespace

Point point_of(Measured const& row, double floor) {
    return {row.seconds, std::isnan(row.error.p95) ? row.error.p95 : std::max(row.error.p95, floor)};
}

namespace {

// Seconds of each step of a study of `waves` waves, from what a round of `probed` of them took.
std::vector<double> expected_seconds(std::vector<Taken> const& taken, std::int64_t probed, std::int64_t waves,
                                     double timing_s) {
    constexpr std::size_t before = 2;  // the sample and its references
    constexpr std::size_t after = 2;   // the number of waves and the conclusions
    std::vector<Taken> steps(taken.begin(), taken.end() - after);
    for (int round = 1; round < timings; ++round) {
        steps.insert(steps.end(), taken.begin() + before, taken.end() - after);
    }
    steps.insert(steps.end(), taken.end() - after, taken.end());
    std::vector<double> seconds;
    seconds.reserve(steps.size());
    for (auto const& step : steps) {
        auto const units = step.extent == Extent::few ? std::min(waves, most_wave_units) : waves;
        seconds.push_back(std::max(timing_s, step.seconds * static_cast<double>(units) / static_cast<double>(probed)));
    }
    return seconds;
}

double sum_of(std::vector<double> const& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

}  // namespace

Study run_study(CampaignInput const& input, StudyOptions const& options, Tell const& tell) {
    auto const most = std::min(Plan(parse_campaign(input)).waves(), most_waves);
    // One round on a few waves first: it tells what each step costs.
    auto const probed = std::min<std::int64_t>(2, most);
    std::vector<Taken> taken;
    auto const begin = Clock::now();
    (void)Runner(input, probed, 1, 0).run([&](Extent extent, double seconds) { taken.push_back({extent, seconds}); });
    double const budget_s = options.seconds - seconds_since(begin);
    auto waves = options.waves;
    if (waves == 0) {
        for (waves = std::min(fewest_waves, most);
             waves < most && sum_of(expected_seconds(taken, probed, waves + 1, options.timing_s)) < budget_s; ++waves) {
        }
    }
    auto const expected = expected_seconds(taken, probed, std::min(waves, most), options.timing_s);
    double const all = sum_of(expected);
    double behind = 0;
    std::size_t step = 0;
    auto const start = Clock::now();
    return Runner(input, std::min(waves, most), timings, options.timing_s).run([&](Extent, double) {
        behind += expected[step++];
        double const done = step == expected.size() ? 1 : behind / all;
        tell(done, seconds_since(start) * (1 - done) / done);
    });
}

}  // namespace overturn::cost
