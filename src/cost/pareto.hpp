/// The settings worth having: those that no other one beats in time and error.
#pragma once

#include <span>
#include <vector>

namespace overturn::cost {

/// Cost and error of one setting.
struct Point {
    double seconds = 0;
    double error = 0;  ///< NaN where nothing could be compared: such a point is on no front
};

/// Whether a is no worse than b in both, and better by more than the share `slack` in at least one.
[[nodiscard]] bool dominates(Point const& a, Point const& b, double slack);

/// on_front[i]: no other point dominates it (Pareto). Differences within `slack` decide nothing: times are measured.
[[nodiscard]] std::vector<bool> pareto_front(std::span<Point const> points, double slack = 0);

}  // namespace overturn::cost
