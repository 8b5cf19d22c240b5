// Requirement R-102: tiles that are read at once give what each gives alone, to the last bit, on every instruction set.
#include "spectra/detail/close_reading.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "simd/instruction_sets.hpp"
#include "spectra/detail/tile_bounds.hpp"

namespace overturn {
namespace {

// Numbers without a pattern, of either sign and about `size`; another for every `number`.
double some(int number, double size) { return size * std::sin(1.7 * number * number + 0.3 * number + 0.1); }

void fill(CloseReading::LaneValues& values, int number, double size) {
    for (double& value : values) {
        value = some(number, size);
        number += 31;
    }
}

CloseReading filled(std::size_t count) {
    CloseReading reading;
    reading.count = count;
    int number = 1;
    for (auto& sample : reading.ground) {
        fill(sample, ++number, 1);
    }
    auto& step = reading.step;
    for (auto* values : {&step.yy, &step.yv, &step.vy, &step.vv}) {
        fill(*values, ++number, 0.6);
    }
    for (auto* values : {&step.ya0, &step.ya1, &step.va0, &step.va1}) {
        fill(*values, ++number, 2);
    }
    auto& chord = reading.chord;
    for (auto* values : {&chord.real_a0, &chord.real_a1, &chord.imaginary_y, &chord.imaginary_v, &chord.imaginary_a0,
                         &chord.imaginary_a1, &chord.scale}) {
        fill(*values, ++number, 1);
    }
    auto& recursion = reading.recursion;
    for (auto* values : {&recursion.ahead, &recursion.behind, &recursion.now, &recursion.last, &recursion.unit,
                         &recursion.w, &recursion.d}) {
        fill(*values, ++number, 0.5);
    }
    fill(reading.y[0], ++number, 3);
    fill(reading.v[0], ++number, 3);
    return reading;
}

template <class Check> void on_every_set(Check const& check) {
    for (auto const set : simd::instruction_sets()) {
        simd::OnlyInstructionSet const only(set);
        for (std::size_t const count : {1U, 2U, 7U, 8U, 9U, 16U}) {
            SCOPED_TRACE(testing::Message() << simd::name_of(set) << ", " << count << " lanes");
            check(count);
        }
    }
}

TEST(CloseReading, StepsAsOneOscillator) {
    on_every_set([](std::size_t count) {
        auto const given = filled(count);
        auto reading = given;
        read_states(reading);
        for (std::size_t lane = 0; lane < count; ++lane) {
            auto const& s = given.step;
            auto const& c = given.chord;
            double y = given.y[0][lane];
            double v = given.v[0][lane];
            double most = 0;
            double furthest = 0;
            for (std::size_t n = 0; n < CloseReading::samples; ++n) {
                double const a0 = given.ground[n][lane];
                double const a1 = given.ground[n + 1][lane];
                double const real = y + (c.real_a0[lane] * a0 + c.real_a1[lane] * a1);
                double const imaginary = c.imaginary_y[lane] * y + c.imaginary_v[lane] * v
                                         + (c.imaginary_a0[lane] * a0 + c.imaginary_a1[lane] * a1);
                double const next = s.yy[lane] * y + s.yv[lane] * v + (s.ya0[lane] * a0 + s.ya1[lane] * a1);
                v = s.vy[lane] * y + s.vv[lane] * v + (s.va0[lane] * a0 + s.va1[lane] * a1);
                double const reach = std::max(std::abs(y), std::abs(next)) * (1 + bound_error)
                                     + c.scale[lane] * (std::abs(real) + std::abs(imaginary));
                y = next;
                most = std::max(most, std::abs(y));
                furthest = std::max(furthest, reach);
                ASSERT_EQ(reading.y[n + 1][lane], y) << n << ' ' << lane;
                ASSERT_EQ(reading.v[n + 1][lane], v) << n << ' ' << lane;
                ASSERT_EQ(reading.reach[n][lane], reach) << n << ' ' << lane;
            }
            EXPECT_EQ(reading.most[lane], most) << lane;
            EXPECT_EQ(reading.furthest[lane], furthest) << lane;
        }
    });
}

TEST(CloseReading, RecursAsOneOscillatorAndGoesOn) {
    on_every_set([](std::size_t count) {
        auto const given = filled(count);
        auto reading = given;
        auto w = given.recursion.w;
        auto d = given.recursion.d;
        for (int const tile : {0, 1}) {
            read_recursion(reading);
            for (std::size_t lane = 0; lane < count; ++lane) {
                auto const& r = given.recursion;
                double most = 0;
                for (std::size_t n = 1; n <= CloseReading::samples; ++n) {
                    double const next = r.ahead[lane] * d[lane] + (r.behind[lane] * w[lane] + given.ground[n][lane]);
                    double const before = w[lane];
                    w[lane] += d[lane];
                    d[lane] = next;
                    double const y = r.unit[lane] * (r.now[lane] * w[lane] + (r.last[lane] * before + d[lane]));
                    most = std::max(most, std::abs(y));
                    ASSERT_EQ(reading.y[n][lane], y) << tile << ' ' << n << ' ' << lane;
                }
                EXPECT_EQ(reading.most[lane], most) << tile << ' ' << lane;
            }
        }
    });
}

}  // namespace
}  // namespace overturn
