/// Closed forms, conservation laws, published values and known answers that this very program, with the libraries it
/// found here, must meet. They take seconds together.
#pragma once

#include "qualify/check.hpp"

namespace overturn::qualify {

/// The body, rocking and sliding (M-..).
[[nodiscard]] Checks mechanics();
/// A body on a compliant pad, in the plane and in space (P-..).
[[nodiscard]] Checks contact();
/// Oscillators, input energy, ouV_E and V_WES, target spectra (S-..).
[[nodiscard]] Checks spectra();
/// Intervals, frequencies, random streams, hashes and the last bits of elementary functions (N-..).
[[nodiscard]] Checks numbers();

}  // namespace overturn::qualify
