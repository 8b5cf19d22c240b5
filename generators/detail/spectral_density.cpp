#include "generators/detail/spectral_density.hpp"

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

double damping_reached(double damping, double w, double strong_s) {
    return damping / -std::expm1(-2 * damping * w * strong_s);
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
        double const damping = damping_reached(target.damping(), w, strong_s);
        double const peak = target.psa_mps2(2 * pi / w) / median_peak_factor(w, damping, strong_s);
        double const variance = peak * peak;
        double const bandwidth = w * std::max(0.25, pi / (4 * damping) - 1);
        density.push_back(std::max(0.01 * variance, variance - below) / bandwidth);
        below += density.back() * (w - before);
        before = w;
    }
    return density;
}

void refine_density(std::vector<double>& density, TargetSpectrum const& target,
                    std::span<double const> frequencies_radps, double strong_s, double longest_s) {
    constexpr int passes = 8;
    constexpr double per_decade = 50;
    double const first = std::max(frequencies_radps.front(), 2 * pi / longest_s);
    auto const count = static_cast<std::size_t>(std::ceil(per_decade * std::log10(frequencies_radps.back() / first)));
    double const gap = std::log(frequencies_radps.back() / first) / static_cast<double>(count);
    double const spacing = frequencies_radps[1] - frequencies_radps[0];
    std::vector<double> excess(count + 1);
    for (int pass = 0; pass < passes; ++pass) {
        for (std::size_t i = 0; i <= count; ++i) {
            double const w = first * std::exp(gap * static_cast<double>(i));
            double const damping = damping_reached(target.damping(), w, strong_s);
            double variance = 0;
            for (std::size_t k = 0; k < density.size(); ++k) {
                double const x2 = frequencies_radps[k] * frequencies_radps[k];
                double const off = w * w - x2;
                variance += density[k] / (off * off + 4 * damping * damping * w * w * x2);
            }
            double const peak = w * w * std::sqrt(variance * spacing) * median_peak_factor(w, damping, strong_s);
            excess[i] = peak / target.psa_mps2(2 * pi / w);
        }
        for (std::size_t k = 0; k < density.size(); ++k) {
            double const place = std::max(0.0, std::log(frequencies_radps[k] / first) / gap);
            auto const left = std::min(static_cast<std::size_t>(place), count - 1);
            double const share = place - static_cast<double>(left);
            double const ratio = (1 - share) * excess[left] + share * excess[left + 1];
            density[k] /= ratio * ratio;
        }
    }
}

}  // namespace overturn
