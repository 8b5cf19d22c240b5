// Requirement R-105: a sweep of sinusoids is one source, one wave for each frequency.
#include "generators/detail/harmonic.hpp"

#include <cmath>

#include <fmt/format.h>

#include "motion/intensity.hpp"
#include "support/expect_input_error.hpp"
#include "support/sources.hpp"
#include "support/tolerance.hpp"

namespace overturn {
namespace {

using testing::near;
using testing::source_of;

TEST(Harmonic, IsTheFormula) {
    auto const wave = source_of("source='harmonic'\namplitude='0.3 g'\nfrequency='2 Hz'\ncycles=4\n")->make(1, 0);

    ASSERT_EQ(wave.motion.samples(), 201U);
    for (std::size_t i = 0; i < 201; ++i) {
        double const exact = 0.3 * g0 * std::sin(2 * pi * 2 * 0.01 * static_cast<double>(i));
        EXPECT_NEAR(wave.motion.horizontal_mps2[i], exact, 1e-13);
    }
    EXPECT_FALSE(wave.match.matched);
}

TEST(Harmonic, SweepTakesTheNthEntry) {
    auto const source = source_of("source='harmonic'\namplitude=1\nfrequencies=[0.5,1,2]\nduration='10 s'\n");

    EXPECT_EQ(source->about().available, 3U);
    EXPECT_EQ(source->make(1, 2).label, "sinusoid of 2 Hz");
    EXPECT_TRUE(near(source->make(9, 0).motion.horizontal_mps2[50], 1, testing::exact_formula));
    testing::expect_input_error([&] { (void)source->make(1, 3); }, "wave 3 of 3");
}

TEST(Harmonic, RampGrowsAndFades) {
    auto const plain = source_of("source='harmonic'\namplitude=1\nperiod=1\nduration=10\n")->make(1, 0).motion;
    auto const ramped = source_of("source='harmonic'\namplitude=1\nperiod=1\nduration=10\nramp=2\n")->make(1, 0).motion;

    EXPECT_NEAR(ramped.horizontal_mps2[125], plain.horizontal_mps2[125] * 1.25 / 2, 1e-15);
    EXPECT_EQ(ramped.horizontal_mps2[525], plain.horizontal_mps2[525]);
    EXPECT_NEAR(ramped.horizontal_mps2[975], plain.horizontal_mps2[975] * 0.25 / 2, 1e-15);
}

/// Property: whatever part of a cycle the ramps and the wave end in, between the ramps the ground swings about where it
/// stood, by amplitude / omega^2, and it comes to rest there. Before, 0.63 Hz drifted 4.5 times as far.
TEST(Harmonic, RampsLeaveNoDrift) {
    for (double const frequency : {0.4, 0.5, 0.63, 0.777, 1.25, 3.3}) {
        auto const motion =
            source_of(fmt::format("source='harmonic'\namplitude=1\nfrequency={}\nduration=160\nramp=20\n"
                                  "time_step=0.01\nvertical={{ratio=0.5, phase='30 deg'}}\n",
                                  frequency))
                ->make(1, 0)
                .motion;
        for (auto const& [samples, amplitude] :
             {std::pair{&motion.horizontal_mps2, 1.0}, {&motion.vertical_mps2, 0.5}}) {
            double const omega = 2 * pi * frequency;
            auto const intensity = intensity_of(*samples, 0.01);
            EXPECT_NEAR(intensity.pgd_m * omega * omega / amplitude, 1, 0.02) << frequency;
            EXPECT_NEAR(velocity_of(*samples, 0.01).back() * omega / amplitude, 0, 1e-9) << frequency;
            EXPECT_NEAR(displacement_of(*samples, 0.01).back() * omega * omega / amplitude, 0, 1e-8) << frequency;
            EXPECT_NEAR(intensity.pga_mps2, amplitude, 0.002);
        }
    }
}

// A quarter period ahead across, the motion goes round in a circle.
TEST(Harmonic, HasThreeComponents) {
    auto const motion = source_of(
                            "source='harmonic'\namplitude=2\nfrequency='2 Hz'\ncycles=4\n"
                            "transverse={ratio=1, phase='90 deg'}\nvertical={ratio=0.5}\n")
                            ->make(1, 0)
                            .motion;
    ASSERT_EQ(motion.transverse_mps2.size(), motion.samples());
    for (std::size_t i = 0; i < motion.samples(); ++i) {
        EXPECT_NEAR(std::hypot(motion.horizontal_mps2[i], motion.transverse_mps2[i]), 2, 1e-13);
        EXPECT_EQ(motion.vertical_mps2[i], 0.5 * motion.horizontal_mps2[i]);
    }
    EXPECT_NEAR(motion.transverse_mps2[0], 2, 1e-15);
}

TEST(Harmonic, RefusesNonsense) {
    auto const refuse = [](std::string const& keys, char const* part) {
        testing::expect_input_error([&] { (void)source_of("source='harmonic'\namplitude=1\n" + keys); }, part);
    };
    refuse("cycles=3\n", "no single frequency");
    refuse("period=1\nfrequency=1\ncycles=3\n", "no single frequency");
    refuse("period=1\n", "no single length");
    refuse("period=1\ncycles=3\nduration=1\n", "no single length");
    refuse("period=0\ncycles=3\n", "period: 0 s");
    refuse("period=0.03\ncycles=3\n", "needs at least 4 steps");
    refuse("period=1\nduration=1\nramp=0.6\n", "both ramps");
}

}  // namespace
}  // namespace overturn
