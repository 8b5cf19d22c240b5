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
            WaveResamples resamples(cells, {seed, 3, 40}, Purpose::bootstrap);
            for (int r = 0; r < 40; ++r) {
                RandomStream stream(seed, static_cast<std::uint64_t>(r), Purpose::bootstrap, 3);
                auto const& summed = resamples.points(r);
                auto const plain = plainly(trials, 16, stream);
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

/// Waves that ended the same way at every level are held once, and each is drawn as often as it is there.
TEST(WaveCells, WavesWithTheSameOutcomesCountTogether) {
    std::vector<SingleTrial> trials;
    for (int w = 0; w < 1000; ++w) {
        for (int level = 0; level < 5; ++level) {
            trials.push_back({1.0 + level, w, level > w % 4, w});
        }
    }
    WaveCells const cells(trials, 64);
    EXPECT_EQ(cells.patterns(), 4U);
    EXPECT_EQ(cells.waves(), 1000U);
    WaveResamples resamples(cells, {11, 0, 1}, Purpose::bootstrap);
    RandomStream stream(11, 0, Purpose::bootstrap, 0);
    auto const plain = plainly(trials, 64, stream);
    auto const& summed = resamples.points(0);
    for (std::size_t i = 0; i < plain.size(); ++i) {
        EXPECT_EQ(summed[i].overturned, plain[i].overturned);
        EXPECT_EQ(summed[i].trials, 1000) << "each wave has one trial at each level";
    }
}

// As cells_of, by sorting all trials and going through them one by one.
std::vector<FragilityPoint> sorted_cells(std::vector<SingleTrial> trials, std::size_t most) {
    auto const log_of = [](SingleTrial const& trial) { return std::log(trial.intensity); };
    std::ranges::stable_sort(trials, {}, log_of);
    std::size_t distinct = 1;
    for (std::size_t i = 1; i < trials.size(); ++i) {
        distinct += log_of(trials[i]) > log_of(trials[i - 1]) ? 1 : 0;
    }
    double const low = log_of(trials.front());
    double const width = (log_of(trials.back()) - low) / static_cast<double>(most);
    auto const cell = [&](SingleTrial const& trial) {
        double const x = log_of(trial);
        return distinct <= most ? x : std::min(std::floor((x - low) / width), static_cast<double>(most - 1));
    };
    std::vector<FragilityPoint> points;
    for (std::size_t i = 0; i < trials.size(); ++i) {
        if (i == 0 || cell(trials[i]) > cell(trials[i - 1])) {
            points.emplace_back();
        }
        auto& point = points.back();
        point.trials += 1;
        point.log_intensity += (log_of(trials[i]) - point.log_intensity) * 1 / point.trials;
        point.overturned += trials[i].overturned ? 1 : 0;
    }
    return points;
}

/// Means of cells are those of a plain pass over sorted trials, to the last bit.
TEST(WaveCells, CellsAreThoseOfSortedTrials) {
    for (bool const levels : {true, false}) {
        for (std::size_t const most : {std::size_t{3}, std::size_t{16}, std::size_t{2048}}) {
            auto const trials = drawn_trials(2000, levels, most);
            auto const cells = cells_of(trials, most);
            auto const plain = sorted_cells(trials, most);
            ASSERT_EQ(cells.points.size(), plain.size());
            for (std::size_t i = 0; i < plain.size(); ++i) {
                EXPECT_EQ(cells.points[i].log_intensity, plain[i].log_intensity);
                EXPECT_EQ(cells.points[i].trials, plain[i].trials);
                EXPECT_EQ(cells.points[i].overturned, plain[i].overturned);
            }
            std::vector<double> counted(plain.size());
            for (auto const cell : cells.cell_of_trial) {
                counted.at(cell) += 1;
            }
            for (std::size_t i = 0; i < plain.size(); ++i) {
                EXPECT_EQ(counted[i], plain[i].trials);
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
