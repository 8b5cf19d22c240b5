/// GSL's mixed-radix Fourier transforms: plain C, the same bits on every machine.
#pragma once

#include <complex>
#include <span>
#include <vector>

namespace overturn {

/// In place, exp(-i...). Twiddle factors are kept per length: waves of a campaign share theirs.
void transform_forward(std::vector<std::complex<double>>& values);

/// In place, exp(+i...), without the division by the length.
void transform_backward(std::vector<std::complex<double>>& values);

/// exp(-i...) of a real signal in place, in GSL's half-complex order: re 0, re 1, im 1, re 2, ...
void transform_real(std::vector<double>& values);

}  // namespace overturn
