#include "stats/detail/ranked_trials.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

#include "stats/detail/rising_order.hpp"
#include "stats/detail/wave_numbers.hpp"

namespace overturn {

// What stood below all that overturned, and what overturned above all that stood, counts whatever its order.
RankedTrials::RankedTrials(std::span<SingleTrial const> trials) {
    double lowest_overturned = std::numeric_limits<double>::infinity();
    double highest_stood = -lowest_overturned;
    for (auto const& trial : trials) {
        if (trial.overturned) {
            lowest_overturned = std::min(lowest_overturned, trial.intensity);
        } else {
            highest_stood = std::max(highest_stood, trial.intensity);
        }
    }
    auto const waves = numbers_of_waves(trials);
    waves_ = waves.waves;
    below_.resize(waves_);
    above_.resize(waves_);
    for (std::size_t i = 0; i < trials.size(); ++i) {
        auto const wave = waves.of_trial[i];
        if (!trials[i].overturned && trials[i].intensity < lowest_overturned) {
            ++below_[wave];
        } else if (trials[i].overturned && trials[i].intensity > highest_stood) {
            ++above_[wave];
        } else {
            between_.push_back({trials[i].intensity, wave, trials[i].overturned ? 1U : 0U});
        }
    }
    sort_rising(between_, &RankedTrial::intensity);
}

void RankedTrials::add_areas(std::span<double const> times, std::size_t most, std::vector<double>& areas) const {
    constexpr std::size_t lanes = DrawnWaves::at_once;
    std::array<double, lanes> stood{};
    std::array<double, lanes> overturned{};
    std::array<double, lanes> above{};
    std::array<double, lanes> highest{};
    for (std::size_t w = 0; w < waves_; ++w) {
        for (std::size_t k = 0; k < lanes; ++k) {
            stood[k] += times[w * lanes + k] * below_[w];
            highest[k] += times[w * lanes + k] * above_[w];
        }
    }
    add_ranked(between_, times, {stood, overturned, above});
    for (std::size_t k = 0; k < std::min(lanes, most); ++k) {
        above[k] += highest[k] * stood[k];
        areas.push_back(above[k] / ((overturned[k] + highest[k]) * stood[k]));
    }
}

double RankedTrials::area() const {
    std::vector<double> area;
    add_areas(std::vector<double>(waves_ * DrawnWaves::at_once, 1.0), 1, area);
    return area.front();
}

std::vector<double> RankedTrials::replicates(BootstrapKey const& key) const {
    std::vector<std::uint32_t> alone(waves_);
    std::iota(alone.begin(), alone.end(), 0U);
    DrawnWaves draws(std::move(alone), waves_);
    std::vector<double> areas;
    std::size_t const wanted = key.replicates;
    while (areas.size() < wanted) {
        draws.draw(key, Purpose::bootstrap, std::ssize(areas));
        add_areas(draws.times(), wanted - areas.size(), areas);
    }
    return areas;
}

}  // namespace overturn
