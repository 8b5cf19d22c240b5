#include "stats/isotonic.hpp"

#include <cmath>
#include <limits>

namespace overturn {
namespace {

// k ln p + (n - k) ln(1 - p) at p = k / n.
double free_likelihood(double overturned, double trials) {
    auto const term = [&](double count) { return count > 0 ? count * std::log(count / trials) : 0; };
    return term(overturned) + term(trials - overturned);
}

}  // namespace

std::vector<PooledPoints> isotonic_estimate(std::span<FragilityPoint const> points) {
    std::vector<PooledPoints> pools;
    pools.reserve(points.size());
    for (auto const& point : points) {
        double const at = std::exp(point.log_intensity);
        pools.push_back({at, at, point.trials, point.overturned, 1});
        while (pools.size() > 1 && pools[pools.size() - 2].probability() >= pools.back().probability()) {
            auto const last = pools.back();
            pools.pop_back();
            pools.back().to = last.to;
            pools.back().trials += last.trials;
            pools.back().overturned += last.overturned;
            pools.back().points += last.points;
        }
    }
    return pools;
}

Interval isotonic_median(std::span<PooledPoints const> pools) {
    constexpr double half = 0.5;
    Interval bracket{0, std::numeric_limits<double>::infinity()};
    for (auto const& pool : pools) {
        if (pool.probability() >= half) {
            bracket.upper = pool.from;
            break;
        }
        bracket.lower = pool.to;
    }
    return bracket;
}

MonotoneTest test_monotone(std::span<FragilityPoint const> points) {
    MonotoneTest test;
    for (auto const& point : points) {
        test.deviance += 2 * free_likelihood(point.overturned, point.trials);
    }
    auto const pools = isotonic_estimate(points);
    for (auto const& pool : pools) {
        test.deviance -= 2 * free_likelihood(pool.overturned, pool.trials);
    }
    test.deviance /= points.empty() ? 1 : points.front().group_size;
    // Equal neighbours are pooled without any cost and violate nothing.
    std::size_t distinct = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        distinct += i == 0 || points[i].probability() != points[i - 1].probability() ? 1 : 0;
    }
    test.degrees_of_freedom = static_cast<int>(distinct) - static_cast<int>(pools.size());
    return test;
}

}  // namespace overturn
