#include "generators/baseline.hpp"

#include <array>
#include <cstddef>

namespace overturn {
namespace {

// Per sample, the share of a unit sample in the end velocity / dt and the end displacement / dt^2.
struct EndShare {
    double velocity, displacement;
};

EndShare end_share(std::size_t i, std::size_t last) {
    if (i == 0) {
        return {0.5, 0.5 * static_cast<double>(last) - 1.0 / 6};
    }
    if (i == last) {
        return {0.5, 1.0 / 6};
    }
    return {1, static_cast<double>(last - i)};
}

std::array<double, 2> shapes(std::size_t i, double share_per_sample) {
    double const s = static_cast<double>(i) * share_per_sample;
    double const bump = s * (1 - s);
    return {bump, bump * (2 * s - 1)};
}

}  // namespace

void correct_baseline(std::span<double> acceleration_mps2) {
    if (acceleration_mps2.size() < 5) {
        return;
    }
    std::size_t const last = acceleration_mps2.size() - 1;
    double const per_sample = 1 / static_cast<double>(last);
    double v0 = 0, v1 = 0, d0 = 0, d1 = 0;
    for (std::size_t i = 0; i <= last; ++i) {
        auto const share = end_share(i, last);
        auto const shape = shapes(i, per_sample);
        v0 += share.velocity * shape[0];
        v1 += share.velocity * shape[1];
        d0 += share.displacement * shape[0];
        d1 += share.displacement * shape[1];
    }
    double const determinant = v0 * d1 - v1 * d0;
    for (int pass = 0; pass < 2; ++pass) {  // the second removes what rounding left
        double v = 0, d = 0;
        for (std::size_t i = 0; i <= last; ++i) {
            auto const share = end_share(i, last);
            v += share.velocity * acceleration_mps2[i];
            d += share.displacement * acceleration_mps2[i];
        }
        double const c0 = (v * d1 - v1 * d) / determinant;
        double const c1 = (v0 * d - v * d0) / determinant;
        for (std::size_t i = 0; i <= last; ++i) {
            auto const shape = shapes(i, per_sample);
            acceleration_mps2[i] -= c0 * shape[0] + c1 * shape[1];
        }
    }
}

}  // namespace overturn
