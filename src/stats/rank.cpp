#include "stats/rank.hpp"

#include "stats/detail/ranked_trials.hpp"

namespace overturn {

double rank_area(std::span<SingleTrial const> trials) { return RankedTrials(trials).area(); }

double rank_area(std::span<FragilityPoint const> points) {
    double stood_below = 0;
    double above = 0;
    for (auto const& point : points) {
        double const stood = point.trials - point.overturned;
        above += point.overturned * (stood_below + stood / 2);
        stood_below += stood;
    }
    return above / (sum_of(points).overturned * stood_below);
}

ResampledRank rank_area(std::span<SingleTrial const> trials, BootstrapKey const& key) {
    RankedTrials const ranked(trials);
    return {ranked.area(), ranked.replicates(key)};
}

}  // namespace overturn
