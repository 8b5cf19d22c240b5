#include "generators/wave_quality.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/error.hpp"

namespace overturn {
namespace {

// Three times the integral of a^2 over time step, up to each sample.
std::vector<double> running_squares(std::span<double const> a) {
    std::vector<double> sums(a.size(), 0.0);
    for (std::size_t i = 1; i < a.size(); ++i) {
        sums[i] = sums[i - 1] + a[i - 1] * a[i - 1] + a[i - 1] * a[i] + a[i] * a[i];
    }
    return sums;
}

double time_of_share(std::span<double const> sums, double share, double time_step_s) {
    double const wanted = share * sums.back();
    auto const above = std::lower_bound(sums.begin(), sums.end(), wanted);
    if (above == sums.begin()) {
        return 0;
    }
    auto const i = static_cast<double>(above - sums.begin());
    double const before = *(above - 1);
    return time_step_s * (i - 1 + (wanted - before) / (*above - before));
}

}  // namespace

double correlation_of(std::span<double const> a, std::span<double const> b) {
    OVERTURN_EXPECT(a.size() == b.size());
    auto const n = static_cast<double>(a.size());
    double const mean_a = std::accumulate(a.begin(), a.end(), 0.0) / n;
    double const mean_b = std::accumulate(b.begin(), b.end(), 0.0) / n;
    double ab = 0, aa = 0, bb = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        ab += (a[i] - mean_a) * (b[i] - mean_b);
        aa += (a[i] - mean_a) * (a[i] - mean_a);
        bb += (b[i] - mean_b) * (b[i] - mean_b);
    }
    return aa > 0 && bb > 0 ? ab / std::sqrt(aa * bb) : 0.0;
}

WaveQuality wave_quality(GroundMotion const& motion) {
    WaveQuality quality;
    std::vector<std::span<double const>> components;
    for (auto const* component : {&motion.horizontal_mps2, &motion.transverse_mps2, &motion.vertical_mps2}) {
        if (!component->empty()) {
            components.emplace_back(*component);
        }
    }
    for (std::size_t i = 0; i < components.size(); ++i) {
        auto const velocity = velocity_of(components[i], motion.time_step_s);
        double const peak = peak_of(velocity);
        double const end = velocity.back();
        if (i == 0) {
            quality.residual_velocity_mps = end;
            quality.residual_displacement_m = displacement_of(components[i], motion.time_step_s).back();
        }
        quality.end_velocity_ratio = std::max(quality.end_velocity_ratio, peak > 0 ? std::abs(end) / peak : 0.0);
        for (std::size_t j = i + 1; j < components.size(); ++j) {
            double const now = correlation_of(components[i], components[j]);
            quality.correlation = std::abs(now) > std::abs(quality.correlation) ? now : quality.correlation;
        }
    }
    auto const sums = running_squares(motion.horizontal_mps2);
    if (sums.back() > 0) {
        double const begin = time_of_share(sums, 0.05, motion.time_step_s);
        quality.duration_5_75_s = time_of_share(sums, 0.75, motion.time_step_s) - begin;
        quality.duration_5_95_s = time_of_share(sums, 0.95, motion.time_step_s) - begin;
    }
    return quality;
}

}  // namespace overturn
