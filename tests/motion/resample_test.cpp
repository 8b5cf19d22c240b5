// Requirement R-108: resampling reads the wave's own straight lines: the same function on a finer grid that holds the
// old one, a stated loss of peak otherwise, and nothing coarser without the user's word, and then behind a low-pass.
#include "motion/resample.hpp"

#include <cmath>

#include "core/units.hpp"
#include "support/expect_input_error.hpp"
#include "support/tolerance.hpp"
#include "support/waves.hpp"

namespace overturn {
namespace {

using testing::exact_formula;
using testing::expect_input_error;
using testing::near;

GroundMotion wave(double time_step_s = 0.02) {
    GroundMotion motion;
    motion.time_step_s = time_step_s;
    motion.horizontal_mps2 = testing::broad_wave(501, time_step_s);
    motion.vertical_mps2 = motion.horizontal_mps2;
    return motion;
}

TEST(Resample, DividedStepsKeepTheSameFunction) {
    auto const old = wave();

    auto const made = resample(old, 0.005, Coarsening::refused);

    ASSERT_EQ(made.motion.samples(), 2001U);
    EXPECT_EQ(made.motion.duration_s(), old.duration_s());
    for (std::size_t i = 0; i < old.samples(); ++i) {
        ASSERT_EQ(made.motion.horizontal_mps2[4 * i], old.horizontal_mps2[i]);  // bit for bit
    }
    EXPECT_EQ(made.motion.vertical_mps2, made.motion.horizontal_mps2);
    EXPECT_EQ(made.says, "0.02 s read at 0.005 s along straight lines, PGA kept");
    EXPECT_FALSE(made.changed);
    auto const displacement = displacement_of(old.horizontal_mps2, old.time_step_s);
    auto const finer = displacement_of(made.motion.horizontal_mps2, 0.005);
    EXPECT_TRUE(near(finer.back(), displacement.back(), exact_formula));
}

TEST(Resample, OtherStepsCutCornersAndAreReported) {
    GroundMotion triangle;
    triangle.time_step_s = 0.02;
    triangle.horizontal_mps2 = {0, 1, 0, 0};

    auto const made = resample(triangle, 0.015, Coarsening::refused);

    auto const& a = made.motion.horizontal_mps2;
    ASSERT_EQ(a.size(), 5U);  // 0 to 0.06 s
    EXPECT_NEAR(a[1], 0.75, 1e-15);
    EXPECT_NEAR(a[2], 0.5, 1e-15);
    EXPECT_NEAR(a[3], 0, 1e-15);
    // Of a hat of 0.04 s: its area, and the moment of its area about the end.
    EXPECT_EQ(made.says, "0.02 s read at 0.015 s along straight lines, PGA -25 %, PGV -6.25 %, PGD -8.59 %");
    EXPECT_TRUE(made.changed);
    // of each component.
    triangle.transverse_mps2 = {0, 0, 1, 0};
    triangle.vertical_mps2 = {0, 2, 2, 0};
    EXPECT_EQ(
        resample(triangle, 0.015, Coarsening::refused).says,
        made.says + "; transverse PGA -25 %, PGV -6.25 %, PGD -1.56 %; vertical PGA +0 %, PGV -6.25 %, PGD -6.25 %");
}

TEST(Resample, CoarserNeedsTheUsersWord) {
    expect_input_error([] { (void)resample(wave(), 0.05, Coarsening::refused); }, "longer than the record's 0.02 s",
                       "resample = \"coarser\"");
    EXPECT_EQ(resample(wave(), 0.04, Coarsening::accepted).motion.samples(), 251U);
    expect_input_error([] { (void)resample(wave(), 100, Coarsening::accepted); }, "longer than the wave");
    expect_input_error([] { (void)resample(wave(), 0, Coarsening::accepted); }, "positive");
}

GroundMotion sines(std::initializer_list<std::pair<double, double>> hertz_and_heights) {
    GroundMotion motion;
    motion.time_step_s = 0.005;
    for (int i = 0; i <= 4000; ++i) {
        double const t = 0.005 * i;
        double const hill = std::pow(std::sin(pi * t / 20), 2);
        double a = 0;
        for (auto const& [hertz, height] : hertz_and_heights) {
            a += height * std::sin(2 * pi * hertz * t);
        }
        motion.horizontal_mps2.push_back(hill * a);
    }
    return motion;
}

// What a grid of 0.05 s (0.06 s) can hold stays as it is; what it would fold to 1 Hz is gone, at any ratio of steps.
TEST(Resample, CoarserFoldsNothing) {
    auto const slow = sines({{0.5, 0.2}, {3, 0.3}});
    auto const both = sines({{0.5, 0.2}, {3, 0.3}, {19, 1}, {39.5, 1}});
    for (double const step : {0.05, 0.06, 0.0517}) {
        auto const made = resample(both, step, Coarsening::accepted);
        auto const& a = made.motion.horizontal_mps2;
        for (std::size_t i = 0; i < a.size(); ++i) {
            double const t = step * static_cast<double>(i);
            double const hill = std::pow(std::sin(pi * t / 20), 2);
            double const kept = hill * (0.2 * std::sin(2 * pi * 0.5 * t) + 0.3 * std::sin(2 * pi * 3 * t));
            ASSERT_NEAR(a[i], kept, 5e-4) << step << " s, " << t;
        }
    }
    auto const said = resample(both, 0.05, Coarsening::accepted).says;
    EXPECT_TRUE(
        said.starts_with("0.005 s read at 0.05 s behind a low-pass (zero phase, up to 8 Hz kept, 80 dB off from "
                         "10 Hz on), PGA -"))
        << said;
    auto const before = peak_of(velocity_of(slow.horizontal_mps2, 0.005));
    auto const after = peak_of(velocity_of(resample(both, 0.05, Coarsening::accepted).motion.horizontal_mps2, 0.05));
    EXPECT_NEAR(after, before, 0.03 * before);  // straight lines through the coarse samples of 3 Hz
}

}  // namespace
}  // namespace overturn
