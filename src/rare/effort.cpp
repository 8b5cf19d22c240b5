#include "rare/effort.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/elapsed.hpp"
#include "rare/automatic.hpp"
#include "rare/detail/answer_items.hpp"
#include "rare/detail/answer_row.hpp"
#include "rare/detail/scout.hpp"
#include "rare/detail/subset_run.hpp"
#include "rare/pulse_mixture.hpp"
#include "rare/subset.hpp"

namespace overturn::rare {
namespace {

constexpr double an_attempt = scout_trials;
constexpr double levels_an_attempt =
    2;  // each is 15 % stronger, which makes type B's failures a hundred times as common
// Variance of a replicate's estimate over its square, of each level: campaigns/rare_events.toml met a c.o.v. of 0.25
// with 23 replicates of six levels.
constexpr double level_variance = 0.24;
constexpr double decade_off = 3;  // of a sounding's probability, either way

Effort& operator+=(Effort& sum, Effort const& more) {
    sum.least += more.least;
    sum.likely += more.likely;
    sum.most += more.most;
    return sum;
}

// In waves of `each` trials, none more than the request allows.
Effort within(Effort const& waves, Request const& request, double each) {
    auto const allowed = static_cast<double>(request.max_runs);
    return {each * std::min(waves.least, allowed), each * std::min(waves.likely, allowed),
            each * std::min(waves.most, allowed)};
}

double levels_of(Sounding const& sounding) { return static_cast<double>(sounding.levels); }

double attempts_for(double levels) { return 1 + std::ceil(levels / levels_an_attempt); }

Effort crude_effort(std::span<Sounding const> all, Request const& request) {
    if (all.empty()) {
        return {};
    }
    double rarest = 1;
    for (auto const& sounding : all) {
        rarest = std::min(rarest, sounding.probability);
    }
    auto const needed = [&](double times) {
        double const p = std::min(1.0, times * rarest);
        return std::max<double>(plain_look, p > 0 ? crude_runs_for(p, request.target_cov) : HUGE_VAL);
    };
    return within({needed(decade_off), needed(1), needed(1 / decade_off)}, request, static_cast<double>(all.size()));
}

Effort subset_effort(Sounding const& sounding, Request const& request) {
    SubsetOptions const options;
    auto const replicate = [&](double levels) {
        return static_cast<double>(options.samples) + levels * static_cast<double>(options.samples - options.chains);
    };
    double const levels = levels_of(sounding);
    auto const asked = static_cast<double>(request.replicates);
    auto const allowed = asked * static_cast<double>(options.most_growth);
    double const wanted = level_variance * levels / (request.target_cov * request.target_cov);
    double const fewest = sounding.reached ? std::max(0.0, levels - 1) : 0;
    double const deepest = std::min(levels + 1, static_cast<double>(options.most_levels));
    auto effort = within({asked * replicate(fewest), std::clamp(wanted, asked, allowed) * replicate(levels),
                          allowed * replicate(deepest)},
                         request, 1);
    effort += {an_attempt, an_attempt * attempts_for(levels), an_attempt * (1 + levels)};
    return effort;
}

Effort mixture_effort(std::span<Sounding const> all, Request const& request) {
    if (all.empty()) {
        return {};
    }
    PulseOptions const options;
    double levels = 0;  // at the fitted factor, which lies in the middle
    for (auto const& sounding : all) {
        levels += levels_of(sounding) / static_cast<double>(all.size());
    }
    auto const waves = [&](double attempts) {
        auto const stages = attempts - 1 + static_cast<double>(options.refits);
        return an_attempt * attempts
               + static_cast<double>(request.replicates) * static_cast<double>(options.pilot_runs) * stages;
    };
    double const attempts = attempts_for(levels);
    auto effort = within({waves(std::max(1.0, attempts - 1)), waves(attempts), waves(1 + levels)}, request, 1);
    // Each round of final runs draws at most as many as all before it. At all factors, and at the fitted one.
    auto const finals = static_cast<double>(request.replicates) * static_cast<double>(options.final_runs);
    auto const most = finals * std::exp2(static_cast<double>(options.most_rounds - 1));
    effort += within({finals, finals, most}, request, static_cast<double>(all.size() + 1));
    return effort;
}

Effort automatic_effort(std::span<Sounding const> all, bool pulses, Request const& request) {
    std::vector<Sounding> common;
    std::vector<Sounding> rare;
    for (auto const& sounding : all) {
        (sounding.probability >= common_probability ? common : rare).push_back(sounding);
    }
    double const look = plain_look * static_cast<double>(all.size());
    Effort effort{look, look, look};
    effort += crude_effort(common, request);
    Effort subsets;
    for (auto const& sounding : rare) {
        subsets += subset_effort(sounding, request);
    }
    if (!pulses) {
        return effort += subsets;
    }
    effort += mixture_effort(rare, request);
    effort.likely += subsets.likely;
    effort.most += subsets.most;
    for (auto const& sounding : rare) {
        effort.most += mixture_effort({&sounding, 1}, request).most;
    }
    return effort;
}

}  // namespace

Sounding sound(Problem const& problem, double factor, std::uint64_t seed, double most_s) {
    constexpr std::int64_t first_trials = 16;
    constexpr std::uint64_t own_replicate = 4095;  // no estimator has so many
    constexpr SubsetOptions small{.samples = 200, .chains = 20};
    SubsetRun run({.seed = seed, .replicate = own_replicate, .phase = Phase::subset}, problem.normals(), small);
    Sounding sounding{.factor = factor, .levels = small.most_levels};
    auto const begin = Clock::now();
    auto const answers = [&](std::int64_t count, auto const& draw) {
        std::vector<AnswerRow> rows(count);
        answer_items(problem, rows.size(), {&factor, 1}, draw,
                     [&](std::size_t i, std::span<Answer const> given) { rows[i] = row_of(given.front()); });
        sounding.trials += count;
        sounding.seconds = seconds_since(begin);
        return rows;
    };
    auto const plain = [&](std::size_t i, std::span<double> normals) {
        run.plain(static_cast<std::int64_t>(i), normals);
    };
    (void)answers(first_trials, plain);
    if (static_cast<double>(small.samples) * sounding.trial_s() > most_s) {
        return sounding;
    }
    run.begin(answers(small.samples, plain));
    for (run.close_level(); run.end() == SubsetRun::End::none; run.close_level()) {
        while (!run.level_is_full()) {
            if (sounding.seconds > most_s) {
                return sounding;
            }
            run.step(answers(small.chains, [&](std::size_t chain, std::span<double> normals) {
                run.propose(static_cast<std::int64_t>(chain), normals);
            }));
        }
    }
    sounding.reached = run.end() == SubsetRun::End::reached;
    sounding.levels = run.result().levels;
    sounding.probability = sounding.reached ? run.result().probability : 0;
    return sounding;
}

Effort effort_of(std::span<Sounding const> soundings, bool pulses, std::optional<Method> method,
                 Request const& request) {
    if (!method) {
        return automatic_effort(soundings, pulses, request);
    }
    Effort effort;
    if (method == Method::crude) {
        effort = crude_effort(soundings, request);
    } else if (method == Method::pulse_mixture) {
        double const look = certain_look * static_cast<double>(soundings.size());
        effort = {look, look, look};
        effort += mixture_effort(soundings, request);
    } else {
        for (auto const& sounding : soundings) {
            effort += subset_effort(sounding, request);
        }
    }
    return effort;
}

}  // namespace overturn::rare
