// Requirement R-904: the front holds exactly the settings that no other one beats in time and error; what differs by no
// more than the noise of a measurement decides nothing.
#include "cost/pareto.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>

#include <gtest/gtest.h>

#include "core/random_stream.hpp"

namespace overturn::cost {
namespace {

TEST(ParetoFront, CountedByHand) {
    std::vector<Point> const points{{1, 9}, {2, 5}, {3, 6}, {4, 1}, {4, 1}, {4, 2}, {9, 1}};

    EXPECT_EQ(pareto_front(points), (std::vector<bool>{true, true, false, true, true, false, false}));
}

TEST(ParetoFront, WithoutAnErrorThereIsNoPlaceOnIt) {
    double const unknown = std::numeric_limits<double>::quiet_NaN();

    EXPECT_EQ(pareto_front(std::vector<Point>{{1, unknown}, {2, 5}}), (std::vector<bool>{false, true}));
}

TEST(ParetoFront, NoiseDecidesNothing) {
    std::vector<Point> const points{{1.00, 5}, {1.05, 5}, {1.20, 5}, {0.99, 5.2}};

    EXPECT_EQ(pareto_front(points, 0.1), (std::vector<bool>{true, true, false, true}));
    EXPECT_EQ(pareto_front(points), (std::vector<bool>{true, false, false, true}));
}

/// Another way to the same front: per time only the best error can be on it, and only if it improves on all before.
std::vector<bool> swept(std::vector<Point> const& points) {
    std::map<double, double> best_at;
    for (auto const& point : points) {
        auto const [place, fresh] = best_at.try_emplace(point.seconds, point.error);
        place->second = std::min(place->second, point.error);
    }
    std::map<double, double> front;
    double lowest = std::numeric_limits<double>::infinity();
    for (auto const& [seconds, error] : best_at) {
        if (error < lowest) {
            front[seconds] = lowest = error;
        }
    }
    std::vector<bool> on_front;
    for (auto const& point : points) {
        auto const place = front.find(point.seconds);
        on_front.push_back(place != front.end() && place->second == point.error);
    }
    return on_front;
}

// Small integers, so that there are ties of every kind.
TEST(ParetoFront, AgreesWithASweep) {
    for (std::uint64_t n = 0; n < 200; ++n) {
        RandomStream stream(1, n, Purpose::wave_phase);
        std::vector<Point> points;
        for (std::size_t i = 0; i < 1 + n % 12; ++i) {
            points.push_back({1.0 + static_cast<double>(stream.bits() % 6), static_cast<double>(stream.bits() % 6)});
        }

        EXPECT_EQ(pareto_front(points), swept(points)) << "set " << n;
    }
}

// Whatever the noise: a point off the front is beaten by one on it, none on it is beaten.
TEST(ParetoFront, WhatIsLeftOutIsBeatenByWhatIsNot) {
    constexpr double slack = 0.1;
    for (std::uint64_t n = 0; n < 200; ++n) {
        RandomStream stream(2, n, Purpose::wave_phase);
        std::vector<Point> points;
        for (std::size_t i = 0; i < 12; ++i) {
            points.push_back({1 + 0.05 * static_cast<double>(stream.bits() % 12),
                              1 + 0.05 * static_cast<double>(stream.bits() % 12)});
        }
        auto const front = pareto_front(points, slack);

        ASSERT_NE(std::count(front.begin(), front.end(), true), 0);
        for (std::size_t i = 0; i < points.size(); ++i) {
            bool beaten = false;
            for (std::size_t j = 0; j < points.size(); ++j) {
                beaten = beaten || (front[j] && dominates(points[j], points[i], slack));
            }
            EXPECT_NE(beaten, front[i]) << "set " << n << ", point " << i;
        }
    }
}

}  // namespace
}  // namespace overturn::cost
