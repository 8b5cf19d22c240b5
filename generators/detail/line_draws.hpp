/// Random Fourier lines of noise.
#pragma once

#include <complex>
#include <cstdint>
#include <span>
#include <vector>

#include "core/random_stream.hpp"

namespace overturn {

using Lines = std::vector<std::complex<double>>;

/// fixed: every line has its mean-square amplitude (Shinozuka and Deodatis 1991); gaussian: amplitudes scatter as those
/// of Gaussian noise do.
enum class LineAmplitudes { fixed, gaussian };

/// cos(2 pi u) + i sin(2 pi u) of each word, whose upper 53 bits are the number u in [0, 1): the bits of the C
/// functions. \pre a multiple of simd::words_together
void turns_of(std::span<std::uint64_t const> words, std::complex<double>* turns);

/// sqrt(-2 ln u) sqrt(1/2) of each number u above 0 and below 1, a multiple of 2^-53: the bits of the C functions.
/// \pre a multiple of simd::counters_together
void scatters_of(std::span<double const> numbers, double* scatters);

struct LineStreams {
    StreamKey phases, amplitudes;

    /// Those of a component of a wave.
    static LineStreams of_wave(std::uint64_t seed, std::uint64_t wave, std::uint64_t component) {
        return {{seed, wave, Purpose::wave_phase, component}, {seed, wave, Purpose::wave_amplitude, component}};
    }
    static LineStreams of_calibration(std::uint64_t seed, std::uint64_t wave) {
        return {{seed, wave, Purpose::calibration, 0}, {seed, wave, Purpose::calibration, 1}};
    }
};

/// Line k, from 1 on, is s amplitude[k] exp(i phi), phi between 0 and 2 pi; gaussian: s has Rayleigh's distribution and
/// a mean square of 1, fixed: s is 1. Numbers and bits are those of gsl_ran_flat, gsl_ran_rayleigh and std::polar, one
/// number a line from each stream.
[[nodiscard]] Lines draw_lines(LineStreams const& streams, std::span<double const> amplitude, LineAmplitudes kind);

/// The lines that pairs of standard normals give, the first pair line 1, distributed as those of draw_lines; 0 behind
/// the last pair. \pre fewer pairs than amplitudes
[[nodiscard]] Lines lines_of_normals(std::span<double const> normals, std::span<double const> amplitude,
                                     LineAmplitudes kind);

}  // namespace overturn
