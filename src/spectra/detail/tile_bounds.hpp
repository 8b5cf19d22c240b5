/// What may lie in each tile of a sweep, sixteen oscillators at a time: how far the ground drives them, how high they
/// swing, and which tiles are worth a closer look.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "spectra/detail/oscillator_sweep.hpp"

namespace overturn {

inline constexpr double bound_error = 1e-9;  ///< by which a bound may err

/// The largest |a| and |change of a| of each tile.
struct TileGround {
    std::vector<double> most, steepest;
    double peak = 0;  ///< the largest |a| of all
};
[[nodiscard]] TileGround ground_of_tiles(std::span<double const> series);

/// A bound on |y| of a tile: most |a| + steepest |change of a| + swung sqrt(|C|^2).
struct TileBound {
    OscillatorGroup::LaneValues most{}, steepest{}, swung{};
};
/// Puts the bounds in place of |C|^2, and the largest of each lane into `highest`.
void bound_tiles(TileBound const& bound, TileGround const& ground, SweepTiles& tiles);

/// The first tile from `from` on in which, or before which if `or_before`, some lane's value reaches its limit; their
/// number if none does.
[[nodiscard]] std::size_t next_reaching(SweepTiles const& tiles, std::size_t from,
                                        OscillatorGroup::LaneValues const& limit, bool or_before);

}  // namespace overturn
