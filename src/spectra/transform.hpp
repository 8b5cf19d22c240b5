/// Discrete Fourier transforms by FFTW 3 (Frigo and Johnson 2005), planned by length alone and never by timing: the
/// same bits in every run. Plans and their buffers are kept per thread and length; waves of a campaign share theirs.
#pragma once

#include <complex>
#include <cstddef>
#include <span>

namespace overturn {

/// Fill `in`, run, read `out`; both hold until this thread next asks for a transform of the kind. `in` may be spoilt.
template <class In, class Out> struct Transform {
    std::span<In> in;
    std::span<Out> out;
    void* plan;
    void run() const;
};
using ComplexTransform = Transform<std::complex<double>, std::complex<double>>;
using RealAnalysis = Transform<double, std::complex<double>>;
using RealSynthesis = Transform<std::complex<double>, double>;

/// out_k = sum_n in_n exp(-2 pi i k n / length). \pre length >= 1
[[nodiscard]] ComplexTransform forward_transform(std::size_t length);

/// The same with exp(+...), without the division by the length.
[[nodiscard]] ComplexTransform backward_transform(std::size_t length);

/// The forward transform of a real series: lines 0 to length / 2.
[[nodiscard]] RealAnalysis real_analysis(std::size_t length);

/// The backward transform of lines 0 to length / 2; those beyond are their conjugates.
[[nodiscard]] RealSynthesis real_synthesis(std::size_t length);

}  // namespace overturn
