// Requirement R-201: intensity measures are exact for acceleration that is linear between samples, peaks inside steps
// included.
#include "motion/intensity.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/polynomial.hpp"
#include "core/units.hpp"
#include "motion/ground_motion.hpp"
#include "support/tolerance.hpp"

namespace overturn {
namespace {

using testing::exact_formula;
using testing::near;

TEST(Intensity, OneRampHasClosedForms) {
    // a = 3 t over 2 s: v = 1.5 t^2, d = 0.5 t^3, integral of a^2 = 3 t^3
    auto const peak = intensity_of(std::vector{0.0, 6.0}, 2.0);

    EXPECT_EQ(peak.pga_mps2, 6.0);
    EXPECT_TRUE(near(peak.pgv_mps, 6.0, exact_formula));
    EXPECT_TRUE(near(peak.pgd_m, 4.0, exact_formula));
    EXPECT_TRUE(near(peak.arias_mps, pi / (2 * g0) * 24.0, exact_formula));
}

TEST(Intensity, PeakVelocityInsideAStepIsFound) {
    // a = 1 - 2 t over 1 s: v = t - t^2 is 0 at both samples and 1/4 between them; d ends at 1/6.
    auto const peak = intensity_of(std::vector{1.0, -1.0}, 1.0);

    EXPECT_TRUE(near(peak.pgv_mps, 0.25, exact_formula));
    EXPECT_TRUE(near(peak.pgd_m, 1.0 / 6, exact_formula));
}

TEST(Intensity, PeakDisplacementInsideAStepIsFound) {
    // a = 1 - 3 t over 1 s: v = t - 1.5 t^2 turns the body at t = 2/3, d = t^2 / 2 - t^3 / 2 is 0 at both samples.
    auto const peak = intensity_of(std::vector{1.0, -2.0}, 1.0);

    EXPECT_TRUE(near(peak.pgd_m, 2.0 / 27, exact_formula));
    EXPECT_TRUE(near(peak.pgv_mps, 0.5, exact_formula));

    // v = 0.995 - t in the second step turns just before its end; d is 0.83 at its start.
    EXPECT_TRUE(near(intensity_of(std::vector{2.99, -1.0, -1.0}, 1.0).pgd_m, 0.83 + 0.995 * 0.995 / 2, exact_formula));
}

TEST(Intensity, AgreesWithASeriesRefinedByInterpolation) {
    std::vector<double> coarse;
    for (int i = 0; i < 200; ++i) {
        coarse.push_back(std::sin(0.7 * i) + 0.3 * std::cos(2.1 * i));
    }
    constexpr int parts = 64;
    std::vector<double> fine;
    for (std::size_t i = 0; i + 1 < coarse.size(); ++i) {
        for (int k = 0; k < parts; ++k) {
            fine.push_back(coarse[i] + (coarse[i + 1] - coarse[i]) * k / parts);
        }
    }
    fine.push_back(coarse.back());

    auto const exact = intensity_of(coarse, 0.01);
    auto const refined = intensity_of(fine, 0.01 / parts);

    EXPECT_TRUE(near(exact.pgv_mps, refined.pgv_mps, exact_formula));
    EXPECT_TRUE(near(exact.pgd_m, refined.pgd_m, exact_formula));
    EXPECT_TRUE(near(exact.arias_mps, refined.arias_mps, exact_formula));
    EXPECT_GE(exact.pgv_mps, peak_of(velocity_of(coarse, 0.01)));
    EXPECT_GE(exact.pgd_m, peak_of(displacement_of(coarse, 0.01)));
}

// Velocity that scarcely turns or scarcely does not, in waves whose steps are large beside it.
TEST(Intensity, PeakDisplacementIsThatOfASearchInEveryStep) {
    constexpr double dt = 0.01;
    for (int wave = 0; wave < 200; ++wave) {
        std::vector<double> a;
        for (int i = 0; i < 300; ++i) {
            a.push_back(std::sin((1.3 + 0.007 * wave) * i) + std::cos(0.031 * wave * i) - 0.01 * (wave % 7));
        }
        double velocity = 0, displacement = 0, peak = 0;
        for (std::size_t i = 1; i < a.size(); ++i) {
            std::array const v{velocity, a[i - 1], (a[i] - a[i - 1]) / (2 * dt)};
            std::array const d{displacement, v[0], v[1] / 2, v[2] / 3};
            auto const turns = roots_in(v, 0.0, dt);
            for (double const t : turns.all()) {
                peak = std::max(peak, std::abs(evaluate(d, t)));
            }
            displacement += velocity * dt + dt * dt / 3 * a[i - 1] + dt * dt / 6 * a[i];
            velocity += 0.5 * dt * (a[i - 1] + a[i]);
            peak = std::max(peak, std::abs(displacement));
        }
        EXPECT_EQ(intensity_of(a, dt).pgd_m, peak) << wave;
    }
}

TEST(Intensity, MirrorImageHasEqualMeasures) {
    std::vector<double> const motion{0.0, 1.0, -3.0, 2.0, 0.5};
    std::vector<double> const mirrored{0.0, -1.0, 3.0, -2.0, -0.5};

    auto const a = intensity_of(motion, 0.1);
    auto const b = intensity_of(mirrored, 0.1);

    EXPECT_EQ(a.pgv_mps, b.pgv_mps);
    EXPECT_EQ(a.pgd_m, b.pgd_m);
    EXPECT_EQ(a.arias_mps, b.arias_mps);
}

TEST(Intensity, SilenceAndSingleSampleAreZeroButForTheirPeak) {
    EXPECT_EQ(intensity_of(std::vector(10, 0.0), 0.01).pgd_m, 0.0);
    auto const single = intensity_of(std::vector{-2.0}, 0.01);
    EXPECT_EQ(single.pga_mps2, 2.0);
    EXPECT_EQ(single.pgv_mps, 0.0);
}

// both horizontal components together have a peak of their own.
TEST(Intensity, OfBothComponentsIsThatOfTheVector) {
    GroundMotion motion{.time_step_s = 0.1,
                        .horizontal_mps2 = {0, 3, -1, 0},
                        .transverse_mps2 = {0, -4, 4.5, 0},
                        .vertical_mps2 = {9, 9, 9, 9}};
    EXPECT_EQ(intensity_of(motion).vector_pga_mps2, 5);
    EXPECT_EQ(intensity_of(motion).pga_mps2, 3);
    motion.transverse_mps2.clear();
    EXPECT_EQ(intensity_of(motion).vector_pga_mps2, 3);
}

}  // namespace
}  // namespace overturn
