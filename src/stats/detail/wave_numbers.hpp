/// The waves of trials, numbered without gaps.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <ranges>
#include <vector>

namespace overturn {

/// Numbers from 0 in the order of the waves' own, trial by trial.
struct WaveNumbers {
    std::vector<std::uint32_t> of_trial;
    std::size_t waves = 0;
};

/// \param trials structs with a member `wave`
template <std::ranges::random_access_range Trials> [[nodiscard]] WaveNumbers numbers_of_waves(Trials const& trials) {
    using Trial = std::ranges::range_value_t<Trials>;
    WaveNumbers numbers;
    numbers.of_trial.reserve(std::ranges::size(trials));
    if (std::ranges::is_sorted(trials, {}, &Trial::wave)) {
        for (std::size_t i = 0; i < std::ranges::size(trials); ++i) {
            numbers.waves += i == 0 || trials[i].wave != trials[i - 1].wave ? 1 : 0;
            numbers.of_trial.push_back(static_cast<std::uint32_t>(numbers.waves - 1));
        }
        return numbers;
    }
    std::vector<std::int64_t> waves;
    waves.reserve(std::ranges::size(trials));
    std::ranges::transform(trials, std::back_inserter(waves), &Trial::wave);
    std::ranges::sort(waves);
    waves.erase(std::unique(waves.begin(), waves.end()), waves.end());
    numbers.waves = waves.size();
    for (auto const& trial : trials) {
        auto const place = std::ranges::lower_bound(waves, trial.wave) - waves.begin();
        numbers.of_trial.push_back(static_cast<std::uint32_t>(place));
    }
    return numbers;
}

}  // namespace overturn
