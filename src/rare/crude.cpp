#include "rare/crude.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"
#include "rare/detail/answer_items.hpp"
#include "rare/detail/normals.hpp"

namespace overturn::rare {
namespace {

// One bit for each factor.
struct CrudeRow {
    std::uint64_t failed = 0, undecided = 0;
};

constexpr double most_undecided_per_failed = 0.05;  // they could move the estimate by so much

Estimate estimate_of(double factor, Count const& count) {
    Estimate estimate;
    estimate.factor = factor;
    estimate.method = Method::crude;
    estimate.runs = count.trials;
    estimate.interval_95 = clopper_pearson(count);
    if (count.failed < fewest_failures) {
        distrust(estimate, State::not_resolved,
                 fmt::format("{} of {} waves failed (fewer than {})", count.failed, count.trials, fewest_failures),
                 count);
        return estimate;
    }
    double const undecided = static_cast<double>(count.undecided) / static_cast<double>(count.failed);
    estimate.health.push_back({"undecided trials per failed one", undecided, most_undecided_per_failed,
                               undecided <= most_undecided_per_failed});
    if (undecided > most_undecided_per_failed) {
        distrust(estimate, State::not_trusted, words_of(estimate.health), count);
        estimate.interval_95 = clopper_pearson(count);  // its lower end rests on no assumption either
        return estimate;
    }
    double const p = static_cast<double>(count.failed) / static_cast<double>(count.trials);
    estimate.state = State::trusted;
    estimate.probability = p;
    estimate.cov = std::sqrt((1 - p) / static_cast<double>(count.failed));
    estimate.crude_runs = static_cast<double>(count.trials);
    return estimate;
}

// What the rarest factor needs, as far as max_runs goes.
std::int64_t runs_wanted(std::span<Count const> counts, Request const& request) {
    std::int64_t wanted = 0;
    for (auto const& count : counts) {
        double const p = static_cast<double>(count.failed) / static_cast<double>(count.trials);
        double const needed = p > 0 ? std::ceil(crude_runs_for(p, request.target_cov)) : HUGE_VAL;
        bool const too_many = needed >= static_cast<double>(request.max_runs);
        wanted = std::max(wanted, too_many ? request.max_runs : static_cast<std::int64_t>(needed));
    }
    return wanted;
}

}  // namespace

std::vector<Count> count_failures(Problem const& problem, std::span<double const> factors, DrawKey key,
                                  std::int64_t first, std::int64_t trials, std::string const& name,
                                  Workforce& workers) {
    OVERTURN_EXPECT(factors.size() <= most_factors);
    auto const rows = workers.map<CrudeRow>(
        {.name = name, .items = trials, .block = 256}, [&](std::int64_t from, std::span<CrudeRow> out) {
            auto const draw = [&](std::size_t i, std::span<double> normals) {
                key.index = static_cast<std::uint64_t>(first + from) + i;
                draw_normals(key, normals);
            };
            answer_items(problem, out.size(), factors, draw,
                         [&](std::size_t i, std::span<Answer const> answers) { set_bits(out[i], answers); });
        });
    std::vector<Count> counts(factors.size());
    for (auto const& row : rows) {
        for (std::size_t f = 0; f < factors.size(); ++f) {
            counts[f].failed += static_cast<std::int64_t>(row.failed >> f & 1U);
            counts[f].undecided += static_cast<std::int64_t>(row.undecided >> f & 1U);
        }
    }
    for (auto& count : counts) {
        count.trials = trials;
    }
    return counts;
}

std::vector<Estimate> estimate_crude(Problem const& problem, std::span<double const> factors, Request const& request,
                                     Workforce& workers) {
    DrawKey const key{.seed = request.seed, .problem = request.problem, .phase = Phase::crude};
    std::int64_t done = std::min(plain_look, request.max_runs);
    auto counts = count_failures(problem, factors, key, 0, done, "crude-0", workers);
    constexpr int rounds = 6;  // an early guess of a small probability is coarse
    for (int round = 1; round < rounds; ++round) {
        auto const wanted = std::min({runs_wanted(counts, request), request.max_runs, 8 * done});
        if (wanted <= done) {
            break;
        }
        auto const more =
            count_failures(problem, factors, key, done, wanted - done, fmt::format("crude-{}", round), workers);
        for (std::size_t f = 0; f < counts.size(); ++f) {
            counts[f].add(more[f]);
        }
        done = wanted;
    }
    std::vector<Estimate> estimates;
    for (std::size_t f = 0; f < factors.size(); ++f) {
        estimates.push_back(estimate_of(factors[f], counts[f]));
    }
    return estimates;
}

}  // namespace overturn::rare
