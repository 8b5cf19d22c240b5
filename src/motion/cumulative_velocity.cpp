#include "motion/cumulative_velocity.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace overturn {
namespace {

// Integral of |a| over a stretch in which a goes from one value to another on a straight line.
double area_of(double from, double to, double duration_s) {
    double const sum = std::abs(from) + std::abs(to);
    return (from < 0) == (to < 0) ? 0.5 * duration_s * sum : 0.5 * duration_s * (from * from + to * to) / sum;
}

}  // namespace

double cav_mps(std::span<double const> acceleration_mps2, double time_step_s) {
    OVERTURN_EXPECT(time_step_s > 0);
    double sum = 0;
    for (std::size_t i = 1; i < acceleration_mps2.size(); ++i) {
        sum += area_of(acceleration_mps2[i - 1], acceleration_mps2[i], time_step_s);
    }
    return sum;
}

double standardised_cav_mps(std::span<double const> acceleration_mps2, double time_step_s, double scale) {
    OVERTURN_EXPECT(time_step_s > 0);
    constexpr double window_s = 1;
    double const size = std::abs(scale);
    double sum = 0, in_window = 0, peak = 0;
    double end_s = window_s;
    auto const close = [&] {
        sum += size * peak >= standardised_cav_threshold_mps2 ? in_window : 0;
        in_window = peak = 0;
    };
    for (std::size_t i = 1; i < acceleration_mps2.size(); ++i) {
        double const begin_s = static_cast<double>(i - 1) * time_step_s;
        double const first = acceleration_mps2[i - 1];
        double const last = acceleration_mps2[i];
        double at_s = begin_s;
        double at = first;
        auto const go_to = [&](double to_s, double to) {
            in_window += area_of(at, to, to_s - at_s);
            peak = std::max(peak, std::abs(at));
            peak = std::max(peak, std::abs(to));
            at_s = to_s;
            at = to;
        };
        while (end_s <= begin_s + time_step_s) {
            double const slope = (last - first) / time_step_s;
            go_to(end_s, end_s == begin_s + time_step_s ? last : first + slope * (end_s - begin_s));
            close();
            end_s += window_s;
        }
        go_to(begin_s + time_step_s, last);
    }
    close();
    return size * sum;
}

}  // namespace overturn
