#include "stats/detail/seen_bound.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <tuple>
#include <vector>

#include "stats/detail/quotes.hpp"
#include "stats/detail/wave_numbers.hpp"

namespace overturn {
namespace {

bool none_fell(FragilityPoint const& point) { return point.overturned + point.undecided == 0; }
bool all_fell(FragilityPoint const& point) { return point.overturned == point.trials && point.undecided == 0; }

std::optional<SeenBound> stripes_from(double log_intensity, std::span<FragilityPoint const> points, bool pools,
                                      double confidence) {
    auto const first = std::ranges::find_if(
        points, [&](auto const& point) { return point.log_intensity >= log_intensity - same_intensity; });
    if (first == points.end()) {
        return std::nullopt;
    }
    auto const run = pools && none_fell(*first) ? std::find_if_not(first, points.end(), none_fell) : std::next(first);
    return seen_together({first, run}, confidence);
}

std::optional<SeenBound> stripes_up_to(double log_intensity, std::span<FragilityPoint const> points, bool pools,
                                       double confidence) {
    auto const end = std::ranges::find_if(
        points, [&](auto const& point) { return point.log_intensity > log_intensity + same_intensity; });
    if (end == points.begin()) {
        return std::nullopt;
    }
    auto first = std::prev(end);
    while (pools && all_fell(*first) && first != points.begin() && all_fell(*std::prev(first))) {
        --first;
    }
    return seen_together({first, end}, confidence);
}

// Of the trials of one wave, the weakest one: they count as one. \param fallen any of them counts, else all must
SeenBound seen_by_waves(std::span<SingleTrial const> trials, bool fallen, double confidence) {
    auto const waves = numbers_of_waves(trials);
    std::vector<char> has_passed(waves.waves, fallen ? 0 : 1);
    for (std::size_t i = 0; i < trials.size(); ++i) {
        if (trials[i].overturned == fallen) {
            has_passed[waves.of_trial[i]] = fallen ? 1 : 0;
        }
    }
    auto const passed = std::ranges::count(has_passed, 1);
    std::int64_t const units = waves.waves;
    auto const [lowest, highest] = std::ranges::minmax(trials, {}, &SingleTrial::intensity);
    return {lowest.intensity,
            highest.intensity,
            static_cast<double>(units),
            static_cast<double>(passed),
            clopper_pearson(passed, units, confidence),
            1,
            true};
}

// The nearest tenth of the trials on one side.
std::optional<SeenBound> nearest_tenth(double intensity, FragilityData const& data, bool above, double confidence) {
    constexpr std::size_t shares = 10;
    struct Distance {  // beyond the intensity; of equally far ones the first
        double intensity;
        std::size_t trial;
        bool operator<(Distance const& other) const {
            return std::tie(intensity, trial) < std::tie(other.intensity, other.trial);
        }
    };
    std::vector<Distance> there;
    for (std::size_t i = 0; i < data.trials.size(); ++i) {
        double const x = data.trials[i].intensity;
        if (above ? x >= intensity * (1 - same_intensity) : x <= intensity * (1 + same_intensity)) {
            there.push_back({above ? x : -x, i});
        }
    }
    if (there.empty()) {
        return std::nullopt;
    }
    auto const share = std::min(there.size(), std::max<std::size_t>(1, data.trials.size() / shares));
    std::nth_element(there.begin(), there.begin() + static_cast<std::ptrdiff_t>(share - 1), there.end());
    there.resize(share);
    std::ranges::sort(there, {}, &Distance::trial);
    std::vector<SingleTrial> nearest;
    nearest.reserve(share);
    std::ranges::transform(there, std::back_inserter(nearest),
                           [&](Distance const& one) { return data.trials[one.trial]; });
    return seen_by_waves(nearest, above, confidence);
}

}  // namespace

SeenBound seen_in(FragilityPoint const& point, double confidence) { return seen_together({&point, 1}, confidence); }

SeenBound seen_together(std::span<FragilityPoint const> points, double confidence) {
    auto const sum = sum_of(points);
    return {std::exp(points.front().log_intensity),
            std::exp(points.back().log_intensity),
            sum.trials,
            sum.overturned,
            interval_of(sum, confidence),
            sum.group_size};
}

std::optional<SeenBound> seen_from(double intensity, FragilityData const& data, bool pools, double confidence) {
    return data.kind == FragilityData::Kind::stripes ? stripes_from(std::log(intensity), data.points, pools, confidence)
                                                     : nearest_tenth(intensity, data, true, confidence);
}

std::optional<SeenBound> seen_up_to(double intensity, FragilityData const& data, bool pools, double confidence) {
    return data.kind == FragilityData::Kind::stripes
               ? stripes_up_to(std::log(intensity), data.points, pools, confidence)
               : nearest_tenth(intensity, data, false, confidence);
}

}  // namespace overturn
