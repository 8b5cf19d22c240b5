/// Bodies, bases, waves and instants that the tests of motion in space share.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "contact/cases.hpp"
#include "spatial/spatial_motion.hpp"
#include "support/long_period_wave.hpp"

namespace overturn::testing {

inline Footing square_base(double corner_share = 1, int points = 11) {
    return {.base = {.corner_share = corner_share, .points = points}};
}
inline Footing round_base(int points = 0) { return {.base = {.shape = BaseShape::round, .points = points}}; }
inline Footing polygon_base(std::vector<std::array<double, 2>> corners_m) {
    return {.base = {.shape = BaseShape::polygon, .corners_m = std::move(corners_m)}};
}

inline SpatialBlock standing(RigidBody const& body, Footing const& footing, double friction) {
    return spatial_block(body, footing, Friction{friction, friction});
}

/// Neither held at rest nor followed after the wave.
inline constexpr ContactAccuracy unheld{.longest_after_s = 0, .rest_gate = false};

/// Two components of noise, independent of each other, with a peak of 1 m/s2: 60 s by steps of 10 ms.
struct TwoWaves {
    std::vector<double> x = filtered_wave(set_b);
    std::vector<double> y = filtered_wave(set_a);
    TwoWaves() {
        x.resize(6001);
        y.resize(6001);
    }
};

/// Keeps every instant.
struct SpatialHistory : SpatialObserver {
    std::vector<SpatialInstant> instants;
    void at(SpatialInstant const& instant) override { instants.push_back(instant); }
};

/// What shakes: components of equal length, some of them empty; they outlive the run.
struct Shaking {
    std::vector<double> const& x;
    std::vector<double> const& y;
    double step_s = 0.01;
    double level = 1;
    std::vector<double> const& z = nothing();

    [[nodiscard]] Excitation excitation() const {
        return {.horizontal_mps2 = x, .transverse_mps2 = y, .vertical_mps2 = z, .time_step_s = step_s, .scale = level};
    }
    [[nodiscard]] static std::vector<double> const& nothing() {
        static std::vector<double> const empty;
        return empty;
    }
};

inline SpatialOutcome shaken(SpatialBlock const& block, Shaking const& by, ContactAccuracy const& accuracy = {},
                             SpatialObserver* observer = nullptr, std::optional<SpatialStart> const& start = {}) {
    return simulate_spatial(block, by.excitation(), accuracy, start, observer);
}

/// Free motion from a start for some time; every instant.
struct Release {
    std::vector<SpatialInstant> instants;
};
inline Release released(SpatialBlock const& block, SpatialStart const& start, double seconds,
                        ContactAccuracy const& accuracy = unheld, double sample_s = 0.01) {
    auto const calm = constant(0, static_cast<std::size_t>(std::lround(seconds / sample_s)) + 1);
    SpatialHistory history;
    static_cast<void>(shaken(block, {calm, Shaking::nothing(), sample_s}, accuracy, &history, start));
    return {std::move(history.instants)};
}

/// The body's axes in space: rows of the matrix.
inline std::array<std::array<double, 3>, 3> matrix_of(SpatialInstant const& instant) {
    auto const& [w, x, y, z] = instant.quaternion;
    return {{{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
             {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
             {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}}};
}

}  // namespace overturn::testing
