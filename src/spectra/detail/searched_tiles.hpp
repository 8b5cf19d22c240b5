/// A wave, a group of oscillators and the tiles that it was swept into.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "spectra/detail/oscillator_sweep.hpp"
#include "spectra/peak_response.hpp"

namespace overturn {

struct PeakResponse::Searched {
    std::span<double const> series;
    Group const* group;
    SweepTiles* tiles;
    CloseReading* reading;

    [[nodiscard]] double state(std::size_t lane, std::size_t tile) const {
        return tiles->at(tile)[simd::sweep_lanes + lane];
    }
    [[nodiscard]] double other(std::size_t lane, std::size_t tile) const {
        return tiles->at(tile)[2 * simd::sweep_lanes + lane];
    }
    // Its samples are [first, end).
    [[nodiscard]] static std::size_t first(std::size_t tile) { return 1 + tile * SweepTiles::samples; }
    [[nodiscard]] std::size_t end(std::size_t tile) const {
        return std::min(first(tile) + SweepTiles::samples, series.size());
    }
};

}  // namespace overturn
