#include "spectra/fourier.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.hpp"
#include "spectra/wide.hpp"

namespace overturn {
namespace {

constexpr std::size_t block = 128;  // its phases of 16 frequencies fill 32 kB

struct PhaseTable {
    std::array<double, wide::lanes * block> cosine;
    std::array<double, wide::lanes * block> sine;
    std::array<double, wide::lanes> turn_cosine;  // over a whole block
    std::array<double, wide::lanes> turn_sine;
};

// sum_n a_n exp(-ixn) for 16 x at once: block sums from the last to the first, joined by Horner's rule.
struct PhaseSum {
    std::span<double const> samples;
    PhaseTable const* table;
    std::array<double, wide::lanes>* real;
    std::array<double, wide::lanes>* imaginary;

    template <int bytes> OVERTURN_INLINE void run() const {
        using R = wide::Registers<bytes>;
        R turn_c, turn_s, re, im;
        R::load(turn_c, table->turn_cosine.data());
        R::load(turn_s, table->turn_sine.data());
        R::clear(re);
        R::clear(im);
        for (std::size_t b = (samples.size() + block - 1) / block; b-- > 0;) {
            auto const part = samples.subspan(b * block, std::min(block, samples.size() - b * block));
            R c, s;
            R::clear(c);
            R::clear(s);
            for (std::size_t j = 0; j < part.size(); ++j) {
                R cj, sj;
                R::load(cj, table->cosine.data() + j * wide::lanes);
                R::load(sj, table->sine.data() + j * wide::lanes);
                double const a = part[j];
#pragma GCC unroll 8
                for (int r = 0; r < R::count; ++r) {
                    c.at[r] = wide::fma(cj.at[r], a, c.at[r]);
                    s.at[r] = wide::fma(sj.at[r], a, s.at[r]);
                }
            }
#pragma GCC unroll 8
            for (int r = 0; r < R::count; ++r) {
                auto const turned = turn_c.at[r] * re.at[r] + turn_s.at[r] * im.at[r];
                im.at[r] = turn_c.at[r] * im.at[r] - turn_s.at[r] * re.at[r] - s.at[r];
                re.at[r] = turned + c.at[r];
            }
        }
        R::store(real->data(), re);
        R::store(imaginary->data(), im);
    }
};

std::vector<std::complex<double>> phase_sums(std::span<double const> samples, std::span<double const> x) {
    std::vector<std::complex<double>> sums(x.size());
    PhaseTable table;
    std::array<double, wide::lanes> real{};
    std::array<double, wide::lanes> imaginary{};
    for (std::size_t begin = 0; begin < x.size(); begin += wide::lanes) {
        for (std::size_t lane = 0; lane < wide::lanes; ++lane) {
            double const phase = x[std::min(begin + lane, x.size() - 1)];
            for (std::size_t j = 0; j < block; ++j) {
                table.cosine.at(j * wide::lanes + lane) = std::cos(phase * static_cast<double>(j));
                table.sine.at(j * wide::lanes + lane) = std::sin(phase * static_cast<double>(j));
            }
            table.turn_cosine.at(lane) = std::cos(phase * static_cast<double>(block));
            table.turn_sine.at(lane) = std::sin(phase * static_cast<double>(block));
        }
        wide::dispatch(PhaseSum{samples, &table, &real, &imaginary});
        for (std::size_t lane = 0; lane < wide::lanes && begin + lane < x.size(); ++lane) {
            sums[begin + lane] = {real.at(lane), imaginary.at(lane)};
        }
    }
    return sums;
}

}  // namespace

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
    auto amplitudes = fast_ ? fast_->of(acceleration_mps2) : phase_sums(acceleration_mps2, phases_);
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

std::complex<double> fourier_amplitude(std::span<double const> acceleration_mps2, double time_step_s,
                                       double frequency_radps) {
    return fourier_amplitudes(acceleration_mps2, time_step_s, std::span(&frequency_radps, 1)).front();
}

}  // namespace overturn
