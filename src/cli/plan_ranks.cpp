#include "cli/plan_ranks.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "runner/progress.hpp"

namespace overturn::cli {
namespace {

constexpr double merged_trial_s = 2.3e-6;  // runner/detail/worker.hpp: 10^6 trials in 2 s to 2.5 s

std::string short_time(double seconds) {
    return seconds < 0.1 ? fmt::format("{:.2g} ms", 1e3 * seconds) : duration_text(seconds);
}

}  // namespace

double RankEstimate::busy() const {
    double const all = static_cast<double>(ranks) * wall_s();
    return all > 0 ? std::min(1.0, static_cast<double>(blocks) * block_s / all) : 0;
}

RankEstimate estimate_ranks(Plan const& plan, double wave_s, double start_s, std::int64_t ranks) {
    RankEstimate estimate{.ranks = ranks, .blocks = plan.blocks(), .start_s = start_s};
    estimate.block_s = wave_s * static_cast<double>(plan.waves()) / static_cast<double>(plan.blocks());
    auto const rounds = (plan.blocks() + ranks - 1) / ranks;
    estimate.work_s = static_cast<double>(rounds) * estimate.block_s;
    estimate.merge_s = merged_trial_s * static_cast<double>(plan.trials());
    return estimate;
}

std::string ranks_text(RankEstimate const& estimate) {
    return fmt::format(
        "about {} on {} {}, which compute {:.0f} % of it{}; {} blocks of {}, merged by one rank in {}",
        short_time(estimate.wall_s()), estimate.ranks, estimate.ranks == 1 ? "rank" : "ranks", 100 * estimate.busy(),
        estimate.blocks < estimate.ranks ? fmt::format(" ({} have no block)", estimate.ranks - estimate.blocks)
                                         : std::string(),
        estimate.blocks, short_time(estimate.block_s), short_time(estimate.merge_s));
}

Json ranks_json(RankEstimate const& estimate) {
    return {{"ranks", estimate.ranks},   {"wall_s", estimate.wall_s()}, {"start_s", estimate.start_s},
            {"work_s", estimate.work_s}, {"merge_s", estimate.merge_s}, {"busy", estimate.busy()}};
}

}  // namespace overturn::cli
