#include "spectra/detail/tile_bounds.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "simd/targets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "spectra/detail/tile_bounds.cpp"
#include <hwy/foreach_target.h>
// foreach_target comes first: it includes this file once per instruction set
#include "simd/lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace overturn::HWY_NAMESPACE {

using TileLanes = simd::HWY_NAMESPACE::SweepDoubles<4>;

using GroundLanes = simd::HWY_NAMESPACE::SweepDoubles<1>;  // few values are left of a tile

OVERTURN_LANES_INLINE double largest(GroundLanes x) {
    std::array<double, GroundLanes::count> values;
    x.store(values.data());
    for (std::size_t half = GroundLanes::count / 2; half > 0; half /= 2) {
        for (std::size_t i = 0; i < half; ++i) {
            values[i] = std::max(values[i], values[i + half]);
        }
    }
    return values[0];
}

void ground_all(std::span<double const> series, TileGround& ground) {
    static_assert(SweepTiles::samples % GroundLanes::count == 0);
    std::size_t first = 1;
    for (; first + SweepTiles::samples <= series.size(); first += SweepTiles::samples) {
        GroundLanes most = abs(GroundLanes(series[first - 1]));
        GroundLanes steepest = 0;
        for (std::size_t n = first; n < first + SweepTiles::samples; n += GroundLanes::count) {
            auto const here = GroundLanes::load(&series[n]);
            most = max(most, abs(here));
            steepest = max(steepest, abs(here - GroundLanes::load(&series[n - 1])));
        }
        ground.most.push_back(largest(most));
        ground.steepest.push_back(largest(steepest));
    }
    if (first < series.size()) {
        double most = std::abs(series[first - 1]);
        double steepest = 0;
        for (std::size_t n = first; n < series.size(); ++n) {
            most = std::max(most, std::abs(series[n]));
            steepest = std::max(steepest, std::abs(series[n] - series[n - 1]));
        }
        ground.most.push_back(most);
        ground.steepest.push_back(steepest);
    }
}

void bound_all(TileBound const& bound, TileGround const& ground, SweepTiles& tiles) {
    for (std::size_t lane = 0; lane < simd::sweep_lanes; lane += TileLanes::count) {
        auto const per_most = TileLanes::load(bound.most.data() + lane);
        auto const per_steepest = TileLanes::load(bound.steepest.data() + lane);
        auto const swung = TileLanes::load(bound.swung.data() + lane);
        TileLanes highest = 0;
        for (std::size_t b = 0; b < tiles.count(); ++b) {
            double* const tile = tiles.at(b) + lane;
            TileLanes const line = per_most * ground.most[b] + per_steepest * ground.steepest[b];
            TileLanes const reach = line + swung * sqrt(TileLanes::load(tile));
            reach.store(tile);
            highest = max(highest, reach);
        }
        highest.store(tiles.highest.data() + lane);
    }
}

std::size_t reaching_all(SweepTiles const& tiles, std::size_t from, OscillatorGroup::LaneValues const& limit,
                         bool or_before) {
    for (std::size_t b = from; b < tiles.count(); ++b) {
        double const* const tile = tiles.at(b);
        double const* const before = or_before && b > 0 ? tiles.at(b - 1) : tile;
        bool reached = false;
        for (std::size_t lane = 0; lane < simd::sweep_lanes; lane += TileLanes::count) {
            auto const value = max(TileLanes::load(tile + lane), TileLanes::load(before + lane));
            reached = reached || any(value >= TileLanes::load(limit.data() + lane));
        }
        if (reached) {
            return b;
        }
    }
    return tiles.count();
}

}  // namespace overturn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace overturn {

HWY_EXPORT(ground_all);
HWY_EXPORT(bound_all);
HWY_EXPORT(reaching_all);

TileGround ground_of_tiles(std::span<double const> series) {
    TileGround ground;
    std::size_t const tiles = (series.size() + SweepTiles::samples - 1) / SweepTiles::samples;
    ground.most.reserve(tiles);
    ground.steepest.reserve(tiles);
    HWY_DYNAMIC_DISPATCH(ground_all)(series, ground);
    ground.peak = ground.most.empty() ? 0.0 : *std::ranges::max_element(ground.most);
    return ground;
}

void bound_tiles(TileBound const& bound, TileGround const& ground, SweepTiles& tiles) {
    HWY_DYNAMIC_DISPATCH(bound_all)(bound, ground, tiles);
}

std::size_t next_reaching(SweepTiles const& tiles, std::size_t from, OscillatorGroup::LaneValues const& limit,
                          bool or_before) {
    return HWY_DYNAMIC_DISPATCH(reaching_all)(tiles, from, limit, or_before);
}

}  // namespace overturn
#endif
