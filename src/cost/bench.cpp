#include "cost/bench.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <optional>

#include "campaign/rocking_band.hpp"
#include "core/error.hpp"
#include "spectra/response_spectrum.hpp"
#include "spectra/target_input.hpp"

namespace overturn::cost {
namespace {

constexpr double damping = 0.05;
constexpr double shortest_s = 0.02;
constexpr double longest_s = 10;

// Where the target is judged: as the matcher does, from two time steps to the longest matched period.
struct Judge {
    std::vector<double> periods_s;
    std::vector<double> target_psa_mps2;
    double damping = 0;

    Judge(CampaignInput const& input, GroundMotion const& motion) {
        auto const waves = config::Table::parse(input.text, input.name, input.settings).child("waves");
        InputFiles files(input.files);
        auto const table = waves.child("target");
        auto const target = read_target(table, files);
        damping = target.damping();
        double const longest = table.number("longest", Dimension::time, config::Range::any(),
                                            std::min({longest_s, target.last_period_s(), motion.duration_s()}));
        constexpr double per_decade = 300;
        for (double const period :
             log_periods_per_decade(std::max(shortest_s, 2 * motion.time_step_s), longest, per_decade)) {
            if (target.defined_at(period)) {
                periods_s.push_back(period);
                target_psa_mps2.push_back(target.psa_mps2(period));
            }
        }
    }

    [[nodiscard]] double mean_misfit(GroundMotion const& motion) const {
        auto const psa = response_spectrum(motion.horizontal_mps2, motion.time_step_s, periods_s, damping).psa_mps2;
        double sum = 0;
        for (std::size_t i = 0; i < psa.size(); ++i) {
            sum += std::abs(psa[i] / target_psa_mps2[i] - 1);
        }
        return sum / static_cast<double>(psa.size());
    }
};

// Ordinates of (x, y) at `at`, along straight lines of the logarithms. \pre at lies within x
std::vector<double> read_between(std::vector<double> const& x, std::vector<double> const& y,
                                 std::vector<double> const& at) {
    std::vector<double> values;
    values.reserve(at.size());
    for (double const place : at) {
        auto const above = std::upper_bound(x.begin() + 1, x.end() - 1, place);
        auto const i = static_cast<std::size_t>(above - x.begin());
        double const share = std::log(place / x[i - 1]) / std::log(x[i] / x[i - 1]);
        values.push_back(y[i - 1] * std::pow(y[i] / y[i - 1], share));
    }
    return values;
}

bool usable(PreparedWave const& wave) { return wave.row.failed == 0; }

}  // namespace

double thread_cpu_seconds() {
    std::timespec now{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    constexpr double nano = 1e-9;
    return static_cast<double>(now.tv_sec) + nano * static_cast<double>(now.tv_nsec);
}

std::vector<std::int64_t> spread_over(std::int64_t count, std::int64_t of) {
    std::vector<std::int64_t> numbers;
    count = std::min(count, of);
    numbers.reserve(count);
    for (std::int64_t i = 0; i < count; ++i) {
        numbers.push_back(i * of / count);
    }
    return numbers;
}

TrialRows all_trials(CampaignSpec const& spec, Plan const& plan, std::span<PreparedWave const> waves) {
    TrialRows trials;
    PhaseSeconds ignored;
    std::size_t const together = waves_together(plan);
    for (std::size_t next = 0; next < waves.size(); next += together) {
        append_trials(spec, plan, waves.subspan(next, std::min(together, waves.size() - next)), trials, ignored);
    }
    return trials;
}

Run run_trials(CampaignSpec const& spec, Plan const& plan, std::span<PreparedWave const> waves) {
    auto const begin = thread_cpu_seconds();
    auto trials = all_trials(spec, plan, waves);
    Run run;
    run.seconds = thread_cpu_seconds() - begin;
    run.units = trials.rows.size();
    run.rows = std::move(trials.rows);
    return run;
}

Run run_energy(Sample const& sample, double panel_phase_rad, Acts acts) {
    Run run;
    auto const& measures = sample.spec.measures;
    auto const begin = thread_cpu_seconds();
    for (auto const& wave : sample.waves) {
        if (!usable(wave)) {
            continue;
        }
        auto const& motion = wave.motion;
        for (auto const& drawn : wave.bodies) {
            auto const band = rocking_band(drawn.body, measures.radius_unit);
            run.values.push_back(acts == Acts::ou_v_e ? overturning_energy_velocity(
                                     motion.horizontal_mps2, motion.time_step_s, band, panel_phase_rad)
                                                      : window_energy(motion.horizontal_mps2, motion.time_step_s, band,
                                                                      {.reading = measures.window,
                                                                       .smoothed = true,
                                                                       .keep_history = false,
                                                                       .panel_phase_rad = panel_phase_rad})
                                                            .v_wes_max_mps);
        }
        ++run.units;
    }
    run.seconds = thread_cpu_seconds() - begin;
    return run;
}

Run run_matching(Sample const& sample, CampaignInput const& input, CampaignSpec const& variant, Depth depth) {
    Run run;
    std::vector<PreparedWave> waves;
    std::optional<Judge> judge;
    PhaseSeconds ignored;
    for (auto const& wave : sample.waves) {
        if (!usable(wave)) {
            continue;
        }
        auto const begin = thread_cpu_seconds();
        auto const made = variant.source->make(variant.seed, sample.plan.wave_id(wave.number));
        run.seconds += thread_cpu_seconds() - begin;
        ++run.units;
        if (depth == Depth::whole) {
            if (!judge) {
                judge.emplace(input, made.motion);
            }
            run.values.push_back(judge->mean_misfit(made.motion));
            waves.push_back(prepare_wave(variant, sample.plan, wave.number, ignored));
        }
    }
    run.rows = run_trials(variant, sample.plan, waves).rows;
    return run;
}

Run run_spectra(Sample const& sample, double per_decade, Depth depth) {
    Run run;
    for (auto const& wave : sample.waves) {
        if (!usable(wave)) {
            continue;
        }
        auto const& motion = wave.motion;
        double const shortest = std::max(shortest_s, 2 * motion.time_step_s);
        auto const periods = log_periods_per_decade(shortest, longest_s, per_decade);
        auto const begin = thread_cpu_seconds();
        auto const spectrum = response_spectrum(motion.horizontal_mps2, motion.time_step_s, periods, damping);
        run.seconds += thread_cpu_seconds() - begin;
        ++run.units;
        if (depth == Depth::times) {
            continue;
        }
        auto const dense = log_periods_per_decade(shortest, longest_s, reference_periods_per_decade);
        auto const read = read_between(spectrum.period_s, spectrum.psa_mps2, dense);
        run.values.insert(run.values.end(), read.begin(), read.end());
    }
    return run;
}

}  // namespace overturn::cost
