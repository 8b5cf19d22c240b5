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

struct LineStreams {
    StreamKey phases, amplitudes;
};

/// Line k, from 1 on, is s amplitude[k] exp(i phi), phi between 0 and 2 pi; gaussian: s has Rayleigh's distribution and
/// a mean square of 1, fixed: s is 1. Numbers and bits are those of gsl_ran_flat, gsl_ran_rayleigh and std::polar, one
/// number a line from each stream.
[[nodiscard]] Lines draw_lines(LineStreams const& streams, std::span<double const> amplitude, LineAmplitudes kind);

}  // namespace overturn
