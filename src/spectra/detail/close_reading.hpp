/// Tiles read closely, at every sample: up to sixteen at once, each of an oscillator of its own.
#pragma once

#include <array>
#include <cstddef>

#include "spectra/detail/oscillator_sweep.hpp"

namespace overturn {

/// One tile a lane: what is known before it is read, and then what was read. A lane always reads `samples` samples;
/// where the end of the wave cuts a tile short, the reader leaves out those behind it.
struct alignas(64) CloseReading {
    using LaneValues = OscillatorGroup::LaneValues;
    static constexpr std::size_t samples = SweepTiles::samples;
    struct Tile {
        std::size_t lane, tile;  ///< of its group
    };
    /// A step from (y, v) to the next sample, as OscillatorStep.
    struct Step {
        LaneValues yy{}, yv{}, ya0{}, ya1{}, vy{}, vv{}, va0{}, va1{};
    };
    /// How far y strays from the straight line between two samples: scale (|real| + |imaginary|).
    struct Chord {
        LaneValues real_a0{}, real_a1{}, imaginary_y{}, imaginary_v{}, imaginary_a0{}, imaginary_a1{}, scale{};
    };
    /// The strided form of OscillatorGroup, with w of the sample before and d; read on, they are those of the end.
    struct Recursion {
        LaneValues ahead{}, behind{}, now{}, last{}, unit{}, w{}, d{};
    };

    std::size_t count = 0;  ///< of the lanes in use, the first
    std::array<Tile, simd::sweep_lanes> of{};
    std::array<LaneValues, samples + 1> ground{};  ///< a, from the sample before the first
    Step step;
    Chord chord;
    Recursion recursion;

    std::array<LaneValues, samples + 1> y{}, v{};  ///< from the sample before the first, which is given
    std::array<LaneValues, samples> reach{};       ///< a bound on |y| from the sample before to each
    LaneValues most{};                             ///< the largest |y| of the samples
    LaneValues furthest{};                         ///< the largest reach
};

/// By steps, with velocities and reach.
void read_states(CloseReading& reading);
/// By the recursion: y alone.
void read_recursion(CloseReading& reading);

}  // namespace overturn
