#include "runner/detail/stopping.hpp"

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "campaign/block_rows.hpp"
#include "campaign/waves_per_look.hpp"
#include "output/target_text.hpp"
#include "results/analysis.hpp"
#include "results/statistics.hpp"
#include "stats/precision.hpp"

namespace overturn {
namespace {

std::string of_limit(CampaignSpec const& spec, std::size_t limit) {
    return limit == 0 ? std::string() : fmt::format(" by limit {}", spec.limits[limit].name);
}

// One body by one limit state; of obstacles the first is reported.
void look(CampaignSpec const& spec, Statistics const& statistics, std::size_t body, std::size_t limit,
          TargetLook& looked) {
    auto const& target = spec.limits[limit].target;
    auto const& stripes = statistics.bodies()[body].stripes_of(limit);
    std::string obstacle;
    if (target.half_width && !is_precise(stripes, *target.half_width, spec.confidence)) {
        looked.met = false;
        obstacle = output::half_width_obstacle(stripes, *target.half_width, spec.confidence);
    }
    if (target.median_half_width) {
        auto const fit = fit_over_levels(spec, statistics, body, {.confidence = spec.confidence}, limit);
        if (!is_precise(fit, *target.median_half_width)) {
            looked.met = false;
            obstacle = obstacle.empty() ? output::median_obstacle(fit, *target.median_half_width) : obstacle;
        }
    }
    if (looked.obstacle.empty() && !obstacle.empty()) {
        looked.obstacle = fmt::format("{}{} {}", spec.bodies[body].name, of_limit(spec, limit), obstacle);
    }
}

}  // namespace

std::vector<std::int64_t> stopping_points(CampaignSpec const& spec, Plan const& plan) {
    constexpr std::int64_t first_look = 32;  // fewer say little, and resampling them says it too surely
    return spec.has_target() ? looks(waves_per_look(plan.asked()), first_look, plan.count())
                             : std::vector<std::int64_t>{};
}

TargetLook look_at_target(CampaignSpec const& spec, Plan const& drawn, Plan const& chosen,
                          store::ShardFolder const& shards) {
    Statistics statistics(spec);
    for (auto const block : blocks_of_chosen(drawn, chosen)) {
        auto rows = BlockRows::unpack(shards.read(block), drawn, drawn.waves_of_block(block).count);
        statistics.add(rows_of_chosen(std::move(rows), drawn, block, chosen));
    }
    TargetLook looked{true, {}};
    for (std::size_t b = 0; b < spec.bodies.size(); ++b) {
        for (std::size_t l = 0; l < spec.limits.size(); ++l) {
            // Once it is missed and reported, the others cost time and change nothing.
            if (looked.met || looked.obstacle.empty()) {
                look(spec, statistics, b, l, looked);
            }
        }
    }
    return looked;
}

std::optional<Plan> chosen_of(CampaignSpec const& spec, Plan const& drawn, AcceptedWaves const& waves,
                              store::ShardFolder const& shards) {
    for (auto const count : stopping_points(spec, drawn)) {
        if (!waves.wanted(count).empty()) {
            return std::nullopt;
        }
        auto chosen = waves.chosen(count);
        if (look_at_target(spec, drawn, chosen, shards).met) {
            return chosen;
        }
    }
    return waves.wanted(drawn.count()).empty() ? std::optional(waves.chosen(drawn.count())) : std::nullopt;
}

}  // namespace overturn
