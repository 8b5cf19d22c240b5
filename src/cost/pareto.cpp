#include "cost/pareto.hpp"

#include <algorithm>
#include <cmath>

namespace overturn::cost {

bool dominates(Point const& a, Point const& b, double slack) {
    return a.seconds <= b.seconds && a.error <= b.error
           && (a.seconds * (1 + slack) < b.seconds || a.error * (1 + slack) < b.error);
}

std::vector<bool> pareto_front(std::span<Point const> points, double slack) {
    std::vector<bool> on_front;
    on_front.reserve(points.size());
    for (auto const& point : points) {
        bool const beaten = std::any_of(points.begin(), points.end(),
                                        [&](Point const& other) { return dominates(other, point, slack); });
        on_front.push_back(!beaten && !std::isnan(point.error));
    }
    return on_front;
}

}  // namespace overturn::cost
