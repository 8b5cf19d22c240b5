#include "stats/detail/tail_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <vector>

#include "stats/detail/quotes.hpp"
#include "stats/detail/seen_bound.hpp"

namespace overturn {

std::vector<FragilityPoint> proportions_of(FragilityData const& data) {
    constexpr std::size_t groups_of_singles = 10;
    return data.kind == FragilityData::Kind::stripes ? data.points : grouped(data.points, groups_of_singles);
}

std::int64_t waves_of(std::span<SingleTrial const> trials, double from, double to) {
    std::vector<std::int64_t> waves;
    for (auto const& trial : trials) {
        bool const there = trial.intensity >= from && trial.intensity <= to;
        if (there && (waves.empty() || waves.back() != trial.wave)) {
            waves.push_back(trial.wave);
        }
    }
    std::ranges::sort(waves);
    return std::unique(waves.begin(), waves.end()) - waves.begin();
}

SeenBound tail_bound(FragilityData const& data, FragilityState state, double confidence) {
    auto const groups = proportions_of(data);
    bool const none = state == FragilityState::none_overturned;
    auto const& group = none ? groups.back() : groups.front();
    auto bound = seen_in(group, confidence);
    if (data.kind == FragilityData::Kind::singles) {
        double const edge = (none ? data.points.back() : data.points.front()).log_intensity;
        // The group's mean halves it, near enough to say where it lies.
        bound.from = std::exp(std::min(edge, group.log_intensity));
        bound.to = std::exp(std::max(edge, group.log_intensity));
        bound.group_size = 1;
        bound.units = static_cast<double>(waves_of(data.trials, bound.from, bound.to * (1 + 1e-12)));
        bound.overturned = none ? 0 : bound.units;
        bound.probability = interval_of({0, bound.units, bound.overturned}, confidence);
    }
    return bound;
}

SeenBound end_bound(FragilityData const& data, FragilityFit const& fit, double confidence) {
    auto const groups = proportions_of(data);
    bool const high = std::isinf(fit.isotonic_median.upper);
    return seen_in(high ? groups.back() : groups.front(), confidence);
}

std::optional<SeenBound> pooled_bound(FragilityData const& data, FragilityFit const& fit, double confidence) {
    bool const none = fit.state == FragilityState::none_overturned;
    bool const may_rise =
        none || (fit.state == FragilityState::not_rising && !has(fit.flags, FragilityFlag::non_monotone));
    if (data.kind != FragilityData::Kind::stripes || data.waves_shared || !may_rise) {
        return std::nullopt;
    }
    // Where nothing overturned: from the stripe of most trials on, which alone would say most.
    auto first = data.points.begin();
    for (auto at = first; none && at != data.points.end(); ++at) {
        first = at->trials >= first->trials ? at : first;
    }
    if (std::next(first) == data.points.end()) {
        return std::nullopt;
    }
    return seen_together({first, data.points.end()}, confidence);
}

}  // namespace overturn
