#include "spectra/fourier.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.hpp"
#include "spectra/phase_sums.hpp"
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

std::vector<std::complex<double>> fourier_amplitudes(std::span<double const> acceleration_mps2, double time_step_s,
                                                     std::span<double const> frequencies_radps) {
    validate(time_step_s > 0 && std::isfinite(time_step_s), "time step {} s (must be positive and finite). Mend it",
             time_step_s);
    auto const count = frequencies_radps.size();
    std::vector<std::complex<double>> amplitudes(count);
    if (acceleration_mps2.size() < 2) {
        return amplitudes;
    }
    std::vector<double> phases(count);
    for (std::size_t i = 0; i < count; ++i) {
        phases[i] = frequencies_radps[i] * time_step_s;
    }
    // One transform costs what about thirty direct sums do.
    constexpr std::size_t few = 64;
    auto const sums = count > few ? fast_phase_sums(acceleration_mps2, phases) : phase_sums(acceleration_mps2, phases);
    auto const last = static_cast<double>(acceleration_mps2.size() - 1);
    for (std::size_t i = 0; i < count; ++i) {
        HatWeights const hat(phases[i]);
        auto const end = acceleration_mps2.back() * std::polar(1.0, -phases[i] * last);
        amplitudes[i] =
            time_step_s * (hat.whole * sums[i] - std::conj(hat.right) * acceleration_mps2.front() - hat.right * end);
    }
    return amplitudes;
}

std::complex<double> fourier_amplitude(std::span<double const> acceleration_mps2, double time_step_s,
                                       double frequency_radps) {
    return fourier_amplitudes(acceleration_mps2, time_step_s, std::span(&frequency_radps, 1)).front();
}

}  // namespace overturn
