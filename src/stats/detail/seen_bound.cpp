#include "stats/detail/seen_bound.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <vector>

#include "stats/detail/quotes.hpp"

namespace overturn {
namespace {

std::optional<SeenBound> next_stripe(double intensity, FragilityData const& data, double confidence) {
    for (auto const& point : data.points) {
        if (point.log_intensity < std::log(intensity) - same_intensity) {
            continue;
        }
        return seen_in(point, confidence);
    }
    return std::nullopt;
}

// A wave that has several trials among them tells no more than one.
std::optional<SeenBound> next_trials(double intensity, FragilityData const& data, double confidence) {
    constexpr std::size_t shares = 10;
    std::vector<SingleTrial> above;
    std::ranges::copy_if(data.trials, std::back_inserter(above),
                         [&](SingleTrial const& trial) { return trial.intensity >= intensity * (1 - same_intensity); });
    if (above.empty()) {
        return std::nullopt;
    }
    std::ranges::stable_sort(above, {}, &SingleTrial::intensity);
    above.resize(std::min(above.size(), std::max<std::size_t>(1, data.trials.size() / shares)));
    std::map<std::int64_t, bool> waves;
    for (auto const& trial : above) {
        waves[trial.wave] = waves[trial.wave] || trial.overturned;
    }
    auto const passed = std::ranges::count_if(waves, [](auto const& wave) { return wave.second; });
    auto const units = static_cast<std::int64_t>(waves.size());
    return SeenBound{above.front().intensity, above.back().intensity, static_cast<double>(units),
                     static_cast<double>(passed), clopper_pearson(passed, units, confidence)};
}

}  // namespace

SeenBound seen_in(FragilityPoint const& point, double confidence) {
    double const at = std::exp(point.log_intensity);
    return {at, at, point.trials, point.overturned, interval_of(point, confidence)};
}

std::optional<SeenBound> seen_from(double intensity, FragilityData const& data, double confidence) {
    return data.kind == FragilityData::Kind::stripes ? next_stripe(intensity, data, confidence)
                                                     : next_trials(intensity, data, confidence);
}

}  // namespace overturn
