#include "runner/rare_forecast.hpp"

#include <vector>

#include "campaign/rare_problem.hpp"
#include "core/elapsed.hpp"

namespace overturn {
namespace {

constexpr double problem_s = 0.5;  // for all levels of a limit state
constexpr double all_s = 1;

struct Sounded {
    rare::Effort trials;
    double trial_s = 0;
};

Sounded sounded(CampaignSpec const& spec, std::size_t body, std::size_t limit) {
    RareProblem const problem(spec, body, limit);
    auto const& levels = spec.levels.levels;
    std::vector<rare::Sounding> soundings;
    double seconds = 0;
    double trials = 0;
    for (auto const& level : levels) {
        soundings.push_back(
            rare::sound(problem, level.value, spec.seed, problem_s / static_cast<double>(levels.size())));
        seconds += soundings.back().seconds;
        trials += static_cast<double>(soundings.back().trials);
    }
    rare::Request const request{.seed = spec.seed,
                                .target_cov = spec.rare->target_cov,
                                .max_runs = spec.rare->max_runs,
                                .replicates = spec.rare->replicates};
    return {rare::effort_of(soundings, problem.frame().has_value(), spec.rare->method, request), seconds / trials};
}

void add(rare::Effort& sum, rare::Effort const& more, double times) {
    sum.least += times * more.least;
    sum.likely += times * more.likely;
    sum.most += times * more.most;
}

}  // namespace

RareForecast forecast_rare(CampaignSpec const& spec) {
    RareForecast sum;
    if (!spec.rare) {
        return sum;
    }
    auto const begin = Clock::now();
    auto const problems = spec.bodies.size() * spec.limits.size();
    std::size_t done = 0;
    while (done < problems && (done == 0 || seconds_since(begin) < all_s)) {
        auto const one = sounded(spec, done % spec.bodies.size(), done / spec.bodies.size());
        add(sum.trials, one.trials, 1);
        add(sum.seconds, one.trials, one.trial_s);
        ++done;
    }
    double const like_these = static_cast<double>(problems - done) / static_cast<double>(done);
    add(sum.trials, rare::Effort(sum.trials), like_these);
    add(sum.seconds, rare::Effort(sum.seconds), like_these);
    return sum;
}

}  // namespace overturn
