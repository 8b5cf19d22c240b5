#include "cli/plan_ranks.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/texts_of.hpp"
#include "results/curves.hpp"
#include "results/statistics.hpp"
#include "runner/progress.hpp"

namespace overturn::cli {
namespace {

// tests/scale/README.md: rows read, counted, written and hashed; of trials held for curves what rank 0 does, and the
// fits. Each curve takes some time of its own, which grows with the waves up to so many, and is fitted three times
// where trials are undecided: tests/benchmarks/README.md.
constexpr double merged_trial_s = 2.4e-6;
constexpr double held_trial_s = 0.5e-6;
constexpr double fitted_trial_s = 2.0e-6;
constexpr double file_s = 0.08;  // groups and attributes, tables as text
constexpr double least_curve_s = 0.025;
constexpr double wave_of_curve_s = 2.5e-4;
constexpr double waves_of_curve = 200;
// A step of the chains of subset simulation is 1600 trials in blocks of 64: no more ranks find work.
constexpr std::int64_t most_ranks_of_rare = 25;

// Ranks take whole curves.
double curves_s(CampaignSpec const& spec, double waves, double held, double undecided_bodies, std::int64_t ranks) {
    auto const curves = count_curves(spec);
    auto const rounds = (curves + ranks - 1) / ranks;
    double const each = fitted_trial_s * held / static_cast<double>(curves) + least_curve_s
                        + wave_of_curve_s * std::min(waves_of_curve, waves);
    return static_cast<double>(rounds) * each * (1 + 2 * undecided_bodies);
}

std::string short_time(double seconds) {
    return seconds < 0.1 ? fmt::format("{:.2g} ms", 1e3 * seconds) : duration_text(seconds);
}

}  // namespace

double RankEstimate::busy() const {
    double const all = static_cast<double>(ranks) * wall_s();
    return all > 0 ? std::min(1.0, static_cast<double>(blocks) * block_s / all) : 0;
}

RankEstimate estimate_ranks(CampaignSpec const& spec, Plan const& plan, ForecastSeconds const& seconds,
                            std::int64_t ranks) {
    RankEstimate estimate{.ranks = ranks, .blocks = plan.blocks(), .start_s = seconds.start.on(ranks)};
    estimate.block_s = seconds.wave * static_cast<double>(plan.waves()) / static_cast<double>(plan.blocks());
    auto const rounds = (plan.blocks() + ranks - 1) / ranks;
    estimate.work_s = static_cast<double>(rounds) * estimate.block_s;
    estimate.rare_s = seconds.rare / static_cast<double>(std::min(ranks, most_ranks_of_rare));
    auto const trials = static_cast<double>(plan.trials());
    bool const shared = Statistics::add_up(spec) && !spec.rare;
    double const held = std::min(trials, static_cast<double>(most_trials_held));
    estimate.merge_s = file_s + merged_trial_s * trials / (shared ? static_cast<double>(ranks) : 1)
                       + held_trial_s * held
                       + curves_s(spec, static_cast<double>(plan.waves()), held, seconds.undecided_bodies, ranks);
    return estimate;
}

std::string ranks_text(RankEstimate const& estimate) {
    return fmt::format("about {} on {}, which compute {:.0f} % of it{}; {} blocks of {}, merged in {}",
                       short_time(estimate.wall_s()), count_text(estimate.ranks, "rank"), 100 * estimate.busy(),
                       estimate.blocks < estimate.ranks
                           ? fmt::format(" ({} have no block)", estimate.ranks - estimate.blocks)
                           : std::string(),
                       estimate.blocks, short_time(estimate.block_s), short_time(estimate.merge_s));
}

std::string parts_text(RankEstimate const& estimate) {
    return fmt::format("starting {}, waves {}{}, merging {}", short_time(estimate.start_s), short_time(estimate.work_s),
                       estimate.rare_s > 0 ? ", rare events " + short_time(estimate.rare_s) : std::string(),
                       short_time(estimate.merge_s));
}

std::string too_short_text(RankEstimate const& estimate, std::int64_t block_waves, double limit_s) {
    if (estimate.start_s + estimate.block_s <= limit_s) {
        return {};
    }
    return fmt::format(
        "within the limit of {} no block is done: one ({}) takes about {}, after {} of starting, and what "
        "is broken off is lost, run after run. Raise the limit to several times that{}",
        short_time(limit_s), block_waves == 1 ? "a wave" : fmt::format("{} waves", block_waves),
        short_time(estimate.block_s), short_time(estimate.start_s),
        block_waves == 1 ? ", or give bodies or levels to campaigns of their own" : "");
}

Json ranks_json(RankEstimate const& estimate) {
    return {{"ranks", estimate.ranks},   {"wall_s", estimate.wall_s()}, {"start_s", estimate.start_s},
            {"work_s", estimate.work_s}, {"rare_s", estimate.rare_s},   {"merge_s", estimate.merge_s},
            {"busy", estimate.busy()}};
}

}  // namespace overturn::cli
