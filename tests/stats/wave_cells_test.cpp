// Requirement R-712: what resampling by waves draws from sums per wave is, count by count, what a plain loop over all
// trials of the drawn waves gives.
#include "stats/detail/wave_cells.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gsl/gsl_rng.h>

namespace overturn {
namespace {

// Waves of 0 to 11 trials at values of their own or at shared levels, in no order.
std::vector<SingleTrial> drawn_trials(int waves, bool levels, std::uint64_t seed) {
    RandomStream stream(seed, 0, Purpose::body_scatter, 0);
    std::vector<SingleTrial> trials;
    for (int w = 0; w < waves; ++w) {
        auto const count = gsl_rng_uniform_int(stream.gsl(), 12);
        for (std::size_t i = 0; i < count; ++i) {
            double const x = levels ? 1.0 + static_cast<double>(i % 5) : std::exp(2 * gsl_rng_uniform(stream.gsl()));
            trials.push_back({x, (7 * w) % waves, gsl_rng_uniform(stream.gsl()) < x / 8, w});
        }
    }
    return trials;
}

// The waves' numbers, rising, and every trial of a drawn one counted by itself.
std::vector<FragilityPoint> plainly(std::vector<SingleTrial> const& trials, std::size_t most, RandomStream& stream) {
    auto const cells = cells_of(trials, most);
    std::vector<std::int64_t> waves;
    for (auto const& trial : trials) {
        waves.push_back(trial.wave);
    }
    std::ranges::sort(waves);
    waves.erase(std::unique(waves.begin(), waves.end()), waves.end());
    auto points = cells.points;
    for (auto& point : points) {
        point.trials = point.overturned = 0;
    }
    for (std::size_t draw = 0; draw < waves.size(); ++draw) {
        auto const wave = waves[gsl_rng_uniform_int(stream.gsl(), waves.size())];
        for (std::size_t t = 0; t < trials.size(); ++t) {
            if (trials[t].wave == wave) {
                points[cells.cell_of_trial[t]].trials += 1;
                points[cells.cell_of_trial[t]].overturned += trials[t].overturned ? 1 : 0;
            }
        }
    }
    return points;
}

TEST(WaveCells, DrawWhatAPlainLoopDraws) {
    for (bool const levels : {true, false}) {
        for (std::uint64_t seed = 1; seed <= 5; ++seed) {
            auto const trials = drawn_trials(60, levels, seed);
            WaveCells const cells(trials, 16);
            for (std::uint64_t r = 0; r < 20; ++r) {
                RandomStream one(seed, r, Purpose::bootstrap, 3);
                RandomStream other(seed, r, Purpose::bootstrap, 3);
                auto const summed = cells.draw(one);
                auto const plain = plainly(trials, 16, other);
                ASSERT_EQ(summed.size(), plain.size());
                for (std::size_t i = 0; i < plain.size(); ++i) {
                    EXPECT_EQ(summed[i].trials, plain[i].trials);
                    EXPECT_EQ(summed[i].overturned, plain[i].overturned);
                    EXPECT_EQ(summed[i].log_intensity, plain[i].log_intensity);
                }
            }
        }
    }
}

TEST(WaveCells, ThePointsAreThoseOfTheTrials) {
    auto const trials = drawn_trials(40, false, 9);
    WaveCells const cells(trials, 64);
    auto const sum = sum_of(cells.points());
    EXPECT_EQ(sum.trials, static_cast<double>(trials.size()));
    EXPECT_LE(cells.waves(), 40U);
    EXPECT_EQ(WaveCells({}, 64).waves(), 0U);
}

}  // namespace
}  // namespace overturn
