#include "spectra/detail/free_vibration.hpp"

#include <algorithm>
#include <cmath>

#include "core/units.hpp"

namespace overturn {
namespace {

/// f after `time`, by the roots of its equation: a pair of complex ones, one double one, two real ones.
double value_after(double w, double damping, double now, double rate, double time_s) {
    double const pushed = rate + damping * w * now;
    double const squared = (1 - damping) * (1 + damping);
    double const wd = w * std::sqrt(std::abs(squared));
    double const decay = std::exp(-damping * w * time_s);
    if (squared > 0) {
        return decay * (now * std::cos(wd * time_s) + pushed / wd * std::sin(wd * time_s));
    }
    return wd > 0 ? decay * (now * std::cosh(wd * time_s) + pushed / wd * std::sinh(wd * time_s))
                  : decay * (now + pushed * time_s);
}

/// When f' is zero for the first time; negative: never.
double turning_point(double w, double damping, double now, double rate) {
    double const pushed = -damping * w * rate - w * w * now;  // of f', as `pushed` of f
    double const squared = (1 - damping) * (1 + damping);
    double const wd = w * std::sqrt(std::abs(squared));
    if (squared > 0) {
        double const angle = std::atan2(rate, -pushed / wd);
        return (angle > 0 ? angle : angle + pi) / wd;
    }
    if (wd == 0) {
        return -rate / pushed;
    }
    double const ratio = -rate * wd / pushed;
    return ratio > 0 && ratio < 1 ? std::atanh(ratio) / wd : -1;
}

}  // namespace

std::vector<double> come_to_rest(std::span<double const> acceleration) {
    auto const last = std::find_if(acceleration.rbegin(), acceleration.rend(), [](double a) { return a != 0; });
    std::vector<double> series(acceleration.begin(), last.base());
    series.push_back(0);
    return series;
}

FreePeak free_peak_and_time(double angular_frequency_radps, double damping, double now, double rate) {
    FreePeak const here{now, 0};
    if (!(angular_frequency_radps > 0) || rate == 0) {
        return here;
    }
    double const at = turning_point(angular_frequency_radps, damping, now, rate);
    double const there = at > 0 ? value_after(angular_frequency_radps, damping, now, rate, at) : 0.0;
    return std::isfinite(there) && std::abs(there) > std::abs(now) ? FreePeak{there, at} : here;
}

double free_peak(double angular_frequency_radps, double damping, double now, double rate) {
    return std::abs(free_peak_and_time(angular_frequency_radps, damping, now, rate).value);
}

FreePeaks free_peaks(double angular_frequency_radps, double damping, double displacement_m, double velocity_mps) {
    double const w = angular_frequency_radps;
    double const acceleration = -2 * damping * w * velocity_mps - w * w * displacement_m;
    double const jerk = -2 * damping * w * acceleration - w * w * velocity_mps;
    return {free_peak(w, damping, displacement_m, velocity_mps), free_peak(w, damping, velocity_mps, acceleration),
            free_peak(w, damping, acceleration, jerk)};
}

}  // namespace overturn
