// Requirement R-102: the bounds by which peaks are sought hold in every tile, and all instruction sets find the same.
#include "spectra/detail/tile_bounds.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "simd/instruction_sets.hpp"
#include "spectra/peak_response.hpp"
#include "spectra/response_spectrum.hpp"
#include "support/waves.hpp"

namespace overturn {
namespace {

constexpr std::size_t lanes = simd::sweep_lanes;

// Values that fall from tile to tile, each lane from its own height.
SweepTiles falling_tiles(std::size_t count) {
    SweepTiles tiles;
    tiles.value.resize(count * SweepTiles::values);
    for (std::size_t b = 0; b < count; ++b) {
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            tiles.at(b)[lane] = static_cast<double>(100 + lane) / static_cast<double>(b + 1);
        }
    }
    return tiles;
}

TEST(TileBounds, KnowTheGroundOfEachTile) {
    for (auto const set : simd::instruction_sets()) {
        simd::OnlyInstructionSet const only(set);
        for (std::size_t const samples : {2U, 32U, 33U, 34U, 1000U, 1025U}) {
            auto wave = testing::broad_wave(samples, 0.01);
            wave[0] = -4;  // the first tile starts from it
            auto const ground = ground_of_tiles(wave);
            double peak = 0;
            std::size_t tile = 0;
            for (std::size_t first = 1; first < samples; first += SweepTiles::samples, ++tile) {
                double most = std::abs(wave[first - 1]);
                double steepest = 0;
                for (std::size_t n = first; n < std::min(samples, first + SweepTiles::samples); ++n) {
                    most = std::max(most, std::abs(wave[n]));
                    steepest = std::max(steepest, std::abs(wave[n] - wave[n - 1]));
                }
                EXPECT_EQ(ground.most.at(tile), most);
                EXPECT_EQ(ground.steepest.at(tile), steepest);
                peak = std::max(peak, most);
            }
            EXPECT_EQ(ground.most.size(), tile);
            EXPECT_EQ(ground.peak, peak);
        }
    }
}

TEST(TileBounds, AddTheGroundAndWhatSwingsAboutIt) {
    TileGround const ground{{3, 5, 2}, {0.5, 0.25, 4}, 5};
    TileBound bound;
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        bound.most[lane] = 1 + static_cast<double>(lane) / 8;
        bound.steepest[lane] = 2 - static_cast<double>(lane) / 16;
        bound.swung[lane] = 0.7 + static_cast<double>(lane);
    }
    for (auto const set : simd::instruction_sets()) {
        simd::OnlyInstructionSet const only(set);
        auto tiles = falling_tiles(3);
        bound_tiles(bound, ground, tiles);
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            double highest = 0;
            for (std::size_t b = 0; b < 3; ++b) {
                double const swung = std::sqrt(static_cast<double>(100 + lane) / static_cast<double>(b + 1));
                double const line = bound.most[lane] * ground.most[b] + bound.steepest[lane] * ground.steepest[b];
                EXPECT_EQ(tiles.at(b)[lane], line + bound.swung[lane] * swung) << b << ' ' << lane;
                highest = std::max(highest, tiles.at(b)[lane]);
            }
            EXPECT_EQ(tiles.highest[lane], highest);
        }
    }
}

TEST(TileBounds, StopAtTheNextTileThatAnyLaneReaches) {
    for (auto const set : simd::instruction_sets()) {
        simd::OnlyInstructionSet const only(set);
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            auto tiles = falling_tiles(6);
            OscillatorGroup::LaneValues limit{};
            limit.fill(1000);
            EXPECT_EQ(next_reaching(tiles, 0, limit, true), 6U);
            tiles.at(2)[lane] = 1000;  // reaching is enough
            tiles.at(5)[lane] = 2000;
            EXPECT_EQ(next_reaching(tiles, 0, limit, false), 2U) << lane;
            EXPECT_EQ(next_reaching(tiles, 3, limit, false), 5U) << lane;
            EXPECT_EQ(next_reaching(tiles, 3, limit, true), 3U) << lane;
            EXPECT_EQ(next_reaching(tiles, 4, limit, true), 5U) << lane;
            EXPECT_EQ(next_reaching(tiles, 6, limit, true), 6U) << lane;
        }
    }
}

// 166 periods are groups side by side and groups alone, of every form and stride.
TEST(TileBounds, GiveTheSamePeaksOnEveryMachine) {
    auto const wave = testing::broad_wave(6001, 0.01);
    for (double const damping : {0.0, 0.05, 0.5, 1.0}) {
        PeakResponse const response(log_periods_per_decade(0.02, 20, 55), damping, 0.01);
        auto const expected = response.peaks(wave);
        for (auto const set : simd::instruction_sets()) {
            simd::OnlyInstructionSet const only(set);
            auto const found = response.peaks(wave);
            for (std::size_t i = 0; i < expected.size(); ++i) {
                EXPECT_EQ(found[i].displacement_m, expected[i].displacement_m) << simd::name_of(set) << ' ' << i;
                EXPECT_EQ(found[i].time_s, expected[i].time_s) << simd::name_of(set) << ' ' << i;
            }
        }
    }
}

}  // namespace
}  // namespace overturn
