#include "spectra/detail/fourier.hpp"

#include <cmath>

#include "core/error.hpp"
#include "spectra/detail/direct_sums.hpp"

namespace overturn {
HatWeights::HatWeights(double x) {
    double const half = 0.5 * x;
    double const sinc = std::abs(half) < 1e-8 ? 1.0 : std::sin(half) / half;
    whole = sinc * sinc;
    double odd = 0;  // (x - sin x) / x^2
    if (std::abs(x) < 1) {
        double term = x / 6;
        for (int k = 4; k <= 22; k += 2) {
            odd += term;
            term *= -x * x / (k * (k + 1));
        }
    } else {
        odd = (x - std::sin(x)) / (x * x);
    }
    right = {0.5 * whole, -odd};
}

FourierIntegrals::FourierIntegrals(std::size_t samples, double time_step_s, std::span<double const> frequencies_radps)
    : samples_(samples), time_step_s_(time_step_s) {
    validate(time_step_s > 0 && std::isfinite(time_step_s), "time step {} s (must be positive and finite). Mend it",
             time_step_s);
    phases_.reserve(frequencies_radps.size());
    ends_.reserve(frequencies_radps.size());
    auto const last = samples > 0 ? static_cast<double>(samples - 1) : 0.0;
    for (double const frequency : frequencies_radps) {
        double const phase = frequency * time_step_s;
        HatWeights const hat(phase);
        phases_.push_back(phase);
        ends_.push_back({hat.whole, std::conj(hat.right), hat.right * std::polar(1.0, -phase * last)});
    }
    // One transform costs what about thirty direct sums do.
    constexpr std::size_t few = 64;
    if (phases_.size() > few) {
        fast_.emplace(samples, phases_);
    }
}

std::vector<std::complex<double>> FourierIntegrals::of(std::span<double const> acceleration_mps2) const {
    OVERTURN_EXPECT(acceleration_mps2.size() == samples_);
    if (samples_ < 2) {
        return std::vector<std::complex<double>>(phases_.size());
    }
    auto amplitudes = fast_ ? fast_->of(acceleration_mps2) : direct_sums(acceleration_mps2, phases_);
    for (std::size_t i = 0; i < amplitudes.size(); ++i) {
        auto const& end = ends_[i];
        amplitudes[i] =
            time_step_s_
            * (end.whole * amplitudes[i] - end.first * acceleration_mps2.front() - end.last * acceleration_mps2.back());
    }
    return amplitudes;
}

std::vector<std::complex<double>> fourier_amplitudes(std::span<double const> acceleration_mps2, double time_step_s,
                                                     std::span<double const> frequencies_radps) {
    return FourierIntegrals(acceleration_mps2.size(), time_step_s, frequencies_radps).of(acceleration_mps2);
}

}  // namespace overturn
