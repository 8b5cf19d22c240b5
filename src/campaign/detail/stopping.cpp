#include "campaign/detail/stopping.hpp"

#include <algorithm>

#include "campaign/analysis.hpp"

namespace overturn {
namespace {

// One body by one limit state.
bool is_precise(CampaignSpec const& spec, Statistics const& statistics, std::size_t body, std::size_t limit) {
    auto const& target = spec.limits[limit].target;
    if (target.half_width
        && !is_precise(statistics.bodies()[body].stripes_of(limit), *target.half_width, spec.confidence)) {
        return false;
    }
    return !target.median_half_width
           || is_precise(fit_over_levels(spec, statistics, body, {.confidence = spec.confidence}, limit),
                         *target.median_half_width);
}

}  // namespace

std::vector<std::int64_t> stopping_points(CampaignSpec const& spec, Plan const& plan) {
    std::vector<std::int64_t> points;
    if (!spec.has_target()) {
        return points;
    }
    constexpr std::int64_t least_waves = 32;  // fewer say little, and resampling them says it too surely
    for (auto const waves : looks(plan.block_size(), least_waves, plan.waves())) {
        points.push_back(waves / plan.block_size());
    }
    return points;
}

bool meets_target(CampaignSpec const& spec, Plan const& plan, store::ShardFolder const& shards, std::int64_t blocks) {
    Statistics statistics(spec);
    for (std::int64_t b = 0; b < blocks; ++b) {
        statistics.add(BlockRows::unpack(shards.read(b), plan, plan.waves_of_block(b).count));
    }
    for (std::size_t b = 0; b < spec.bodies.size(); ++b) {
        for (std::size_t l = 0; l < spec.limits.size(); ++l) {
            if (!is_precise(spec, statistics, b, l)) {
                return false;
            }
        }
    }
    return true;
}

Plan cut_at_target(CampaignSpec const& spec, Plan const& plan, store::ShardFolder const& shards,
                   std::vector<std::int64_t> const& committed) {
    for (auto const blocks : stopping_points(spec, plan)) {
        auto const there = std::lower_bound(committed.begin(), committed.end(), blocks) - committed.begin();
        if (there < blocks) {
            break;
        }
        if (meets_target(spec, plan, shards, blocks)) {
            return plan.first(blocks);
        }
    }
    return plan;
}

}  // namespace overturn
