#include "generators/spectral_density.hpp"

#include <algorithm>
#include <cmath>

#include "core/units.hpp"

namespace overturn {
namespace {

double median_peak_factor(double w, double damping, double strong_s) {
    double const cycles = std::max(1.0, w * strong_s / (2 * pi) / std::log(2.0));
    double const bandwidth = std::sqrt(4 * damping / pi);
    double const effective = 2 * cycles * (1 - std::exp(-bandwidth * std::sqrt(pi * std::log(2 * cycles))));
    return std::sqrt(2 * std::log(std::max(2.0, effective)));
}

}  // namespace

std::vector<double> density_of(TargetSpectrum const& target, std::span<double const> frequencies_radps,
                               double strong_s) {
    std::vector<double> density;
    density.reserve(frequencies_radps.size());
    if (target.is_energy()) {
        for (double const w : frequencies_radps) {
            double const v = target.psv_mps(2 * pi / w);
            density.push_back(v * v / (pi * strong_s));
        }
        return density;
    }
    double below = 0;
    double before = 0;
    for (double const w : frequencies_radps) {
        double const damping = target.damping() / -std::expm1(-2 * target.damping() * w * strong_s);
        double const peak = target.psa_mps2(2 * pi / w) / median_peak_factor(w, damping, strong_s);
        double const variance = peak * peak;
        double const bandwidth = w * std::max(0.25, pi / (4 * damping) - 1);
        density.push_back(std::max(0.01 * variance, variance - below) / bandwidth);
        below += density.back() * (w - before);
        before = w;
    }
    return density;
}

}  // namespace overturn
