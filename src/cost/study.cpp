#include "cost/study.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/elapsed.hpp"
#include "core/print_note.hpp"
#include "cost/detail/runner.hpp"

namespace overturn::cost {
namespace {

constexpr int timings = 2;                 // a time is the best of them
constexpr std::int64_t fewest_waves = 4;   // unless stated
constexpr std::int64_t most_waves = 2000;  // of a sample: they are held in memory

/// What one step took when it was tried on a few waves.
struct Taken {
    Extent extent;
    double seconds;
};

// Seconds of each step of a study of `waves` waves, from what a round of `probed` of them took.
std::vector<double> expected_seconds(std::vector<Taken> const& taken, std::int64_t probed, std::int64_t waves,
                                     double timing_s) {
    std::vector<Taken> steps(taken.begin(), taken.end() - steps_after);
    for (int round = 1; round < timings; ++round) {
        steps.insert(steps.end(), taken.begin() + steps_before, taken.end() - steps_after);
    }
    steps.insert(steps.end(), taken.end() - steps_after, taken.end());
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

Point point_of(Measured const& row, double floor) {
    return {row.seconds, std::isnan(row.error.p95) ? row.error.p95 : std::max(row.error.p95, floor)};
}

Study run_study(CampaignInput const& input, StudyOptions const& options, Tell const& tell) {
    auto const most = std::min(Plan(parse_campaign(input)).waves(), most_waves);
    auto const probed = std::min<std::int64_t>(2, most);
    auto waves = std::min(options.waves, most);
    std::vector<Taken> taken;
    if (waves == 0 || waves > 2 * probed) {
        // One round on a few waves first: it shows the cost of each step.
        auto const begin = Clock::now();
        (void)Runner(input, probed, 1, 0).run([&](Extent extent, double s) { taken.push_back({extent, s}); });
        double const budget_s = options.seconds - seconds_since(begin);
        for (auto n = std::min(fewest_waves, most); options.waves == 0 && n <= most; ++n) {
            bool const fits = sum_of(expected_seconds(taken, probed, n, options.timing_s)) < budget_s;
            if (!fits && waves > 0) {
                break;
            }
            waves = n;
        }
    }
    Runner runner(input, waves, timings, options.timing_s);
    auto const expected = taken.empty() ? std::vector<double>(runner.steps(), 1.0)
                                        : expected_seconds(taken, probed, waves, options.timing_s);
    double const all = sum_of(expected);
    double behind = 0;
    std::size_t step = 0;
    auto const start = Clock::now();
    auto study = runner.run([&](Extent, double) {
        behind += expected[step++];
        double const done = step == expected.size() ? 1 : behind / all;
        tell(done, seconds_since(start) * (1 - done) / done);
    });
    if (auto const spec = parse_campaign(input); spec.rare) {
        auto const rare_start = Clock::now();
        print_note("rare events of {}\n", spec.bodies.front().name);
        study.rare = study_rare(spec, [&](double done) { tell(done, seconds_since(rare_start) * (1 - done) / done); });
    }
    return study;
}

}  // namespace overturn::cost
