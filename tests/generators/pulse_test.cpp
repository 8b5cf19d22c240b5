// Requirement R-105: pulses have exactly the peaks, areas and lengths their formulas name.
#include "generators/detail/pulse.hpp"

#include <algorithm>
#include <cmath>

#include "support/expect_input_error.hpp"
#include "support/sources.hpp"
#include "support/tolerance.hpp"

namespace overturn {
namespace {

using testing::near;
using testing::rounding;
using testing::source_of;

GroundMotion pulse(std::string const& shape, std::string const& more = "") {
    return source_of("source='pulse'\namplitude=2.5\nperiod=0.73\nshape='" + shape + "'\n" + more)->make(1, 0).motion;
}

double end_velocity(GroundMotion const& motion) {
    return velocity_of(motion.horizontal_mps2, motion.time_step_s).back();
}

TEST(Pulse, OneSineHitsItsPeaksAndEndsAtRest) {
    auto const motion = pulse("one-sine");

    EXPECT_TRUE(near(motion.duration_s(), 0.73, rounding));
    EXPECT_LE(motion.time_step_s, 0.005);
    auto const& a = motion.horizontal_mps2;
    EXPECT_TRUE(near(*std::max_element(a.begin(), a.end()), 2.5, rounding));
    EXPECT_TRUE(near(*std::min_element(a.begin(), a.end()), -2.5, rounding));
    EXPECT_NEAR(end_velocity(motion), 0, 1e-14);
}

TEST(Pulse, HalfSineHasItsArea) {
    auto const motion = pulse("half-sine", "time_step=1e-4");

    EXPECT_TRUE(near(motion.duration_s(), 0.365, rounding));
    EXPECT_TRUE(near(peak_of(motion.horizontal_mps2), 2.5, rounding));
    // 2 A / w, less the area that chords cut off: (w dt)^2 / 12 of it.
    EXPECT_TRUE(near(end_velocity(motion), 2 * 2.5 * 0.73 / (2 * pi), testing::Tolerance{1e-7, "chords"}));
}

TEST(Pulse, RickerIsSymmetricAndEndsAtRest) {
    auto const motion = pulse("ricker");
    auto const& a = motion.horizontal_mps2;

    EXPECT_TRUE(near(peak_of(a), 2.5, rounding));
    EXPECT_NEAR(end_velocity(motion), 0, 1e-13);
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_NEAR(a[i], a[a.size() - 1 - i], 1e-14);
        // Ricker (1953), over four periods; what its cut ends leave is taken off.
        double const u = motion.time_step_s * static_cast<double>(i) / 0.73 - 2;
        double const v = pi * pi * u * u;
        EXPECT_NEAR(a[i], 2.5 * (1 - 2 * v) * std::exp(-v), 1e-6);
    }
}

TEST(Pulse, OneCosineBeginsAndEndsAtItsPeak) {
    auto const motion = pulse("one-cosine", "quiet_before=0.2\nquiet_after=0.2\n");
    auto const& a = motion.horizontal_mps2;

    EXPECT_TRUE(
        near(*std::max_element(a.begin(), a.end()), 2.5 * std::cos(2 * pi * motion.time_step_s / 0.73), rounding))
        << "half of the peak is left of the jump";
    EXPECT_TRUE(near(*std::min_element(a.begin(), a.end()), -2.5, rounding));
    EXPECT_NEAR(end_velocity(motion), 0, 1e-14);
    auto const first = std::find_if(a.begin(), a.end(), [](double x) { return x != 0; });
    EXPECT_TRUE(near(*first, 1.25, rounding));
}

// Vassiliou and Makris (2011): a = a_p/1.38 (x^2 - 3) x exp(-x^2/2), x = 2 pi t / (sqrt 3 T_p); 1.38 is its peak.
TEST(Pulse, AntisymmetricRickerIsThePublishedOne) {
    auto const motion = pulse("antisymmetric-ricker");
    auto const& a = motion.horizontal_mps2;
    double const middle_s = 0.5 * motion.duration_s();

    EXPECT_TRUE(near(*std::max_element(a.begin(), a.end()), 2.5, rounding));
    EXPECT_TRUE(near(*std::min_element(a.begin(), a.end()), -2.5, rounding));
    EXPECT_NEAR(end_velocity(motion), 0, 1e-13);
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_NEAR(a[i], -a[a.size() - 1 - i], 1e-13);
        double const x = 2 * pi / std::sqrt(3.0) * (motion.time_step_s * static_cast<double>(i) - middle_s) / 0.73;
        EXPECT_NEAR(a[i], 2.5 / 1.38 * (x * x - 3) * x * std::exp(-0.5 * x * x), 2.5 * 2e-4) << "1.38 has three digits";
    }
}

// Mavroeidis and Papageorgiou (2003), eq. 3: v(t) = A/2 [1 + cos(2 pi f t/gamma)] cos(2 pi f t + nu), abs(t) <=
// gamma/2f.
TEST(Pulse, MavroeidisPapageorgiouHasItsVelocityAndEndsAtRest) {
    struct Case {
        double gamma, phase_deg;
    };
    for (auto const& [gamma, phase_deg] : {Case{1.5, 0}, Case{2, 90}, Case{3.2, 217}}) {
        auto const motion = pulse("mavroeidis-papageorgiou",
                                  fmt::format("gamma={}\nphase='{} deg'\ntime_step=1e-4\n", gamma, phase_deg));
        auto const velocity = velocity_of(motion.horizontal_mps2, motion.time_step_s);
        double const nu = phase_deg * pi / 180;
        std::vector<double> published;
        for (std::size_t i = 0; i < velocity.size(); ++i) {
            double const w = motion.time_step_s * static_cast<double>(i) / 0.73 - 0.5 * gamma;
            published.push_back(0.5 * (1 + std::cos(2 * pi * w / gamma)) * std::cos(2 * pi * w + nu));
        }
        double const amplitude = peak_of(velocity) / peak_of(published);

        EXPECT_TRUE(near(motion.duration_s(), gamma * 0.73, testing::exact_formula));
        EXPECT_TRUE(near(peak_of(motion.horizontal_mps2), 2.5, testing::Tolerance{1e-7, "between samples"}));
        EXPECT_NEAR(velocity.back(), 0, 1e-7 * amplitude);
        for (std::size_t i = 0; i < velocity.size(); ++i) {
            ASSERT_NEAR(velocity[i], amplitude * published[i], 1e-6 * amplitude) << gamma << ' ' << i;
        }
    }
}

TEST(Pulse, OnlyMavroeidisPapageorgiouHasParameters) {
    testing::expect_input_error([] { (void)pulse("mavroeidis-papageorgiou", "gamma=2\n"); }, "phase");
    testing::expect_input_error([] { (void)pulse("mavroeidis-papageorgiou", "gamma=1\nphase=0\n"); },
                                "c.toml:5:", "gamma");
    testing::expect_input_error([] { (void)pulse("one-sine", "gamma=2\n"); }, "c.toml:5:", "gamma");
}

TEST(Pulse, RectangleHasExactlyItsArea) {
    for (auto const* quiet : {"", "quiet_before=0.3\nquiet_after=1\n"}) {
        auto const motion = pulse("rectangle", quiet);

        EXPECT_TRUE(near(end_velocity(motion), 2.5 * 0.73, testing::exact_formula));
        EXPECT_EQ(peak_of(motion.horizontal_mps2), 2.5);
        EXPECT_EQ(motion.horizontal_mps2.front(), 0);
        EXPECT_EQ(motion.horizontal_mps2.back(), 0);
    }
}

TEST(Pulse, QuietTimeSurroundsIt) {
    auto const motion = pulse("one-sine", "quiet_before=1\nquiet_after=2\ntime_step=0.01\n");

    auto const& a = motion.horizontal_mps2;
    auto const moving = [](double x) { return x != 0; };
    auto const first = std::find_if(a.begin(), a.end(), moving) - a.begin();
    EXPECT_NEAR(static_cast<double>(first) * motion.time_step_s, 1, 0.02);
    EXPECT_NEAR(motion.duration_s(), 3.73, 0.01);
}

TEST(Pulse, ListOfPeriodsIsASweep) {
    auto const source = source_of("source='pulse'\nshape='one-sine'\namplitude='300 gal'\nperiods=[0.5,'1 s',2]\n");

    EXPECT_EQ(source->about().available, 3U);
    EXPECT_TRUE(near(source->make(1, 2).motion.duration_s(), 2, rounding));
    EXPECT_EQ(source->make(1, 1).label, "one-sine of 1 s");
    testing::expect_input_error([&] { (void)source->make(1, 3); }, "wave 3 of 3");
}

TEST(Pulse, HasThreeComponents) {
    auto const source = source_of(
        "source='pulse'\nshape='one-sine'\namplitude=2\nperiod=1\ntime_step=0.05\n"
        "transverse={ratio=0.5, lag='0.25 s'}\nvertical={ratio=0.1}\n");
    auto const motion = source->make(1, 0).motion;
    ASSERT_EQ(motion.samples(), 26U);
    for (std::size_t i = 0; i < 26; ++i) {
        double const before = i < 5 ? 0 : motion.horizontal_mps2[i - 5];
        EXPECT_EQ(motion.transverse_mps2[i], 0.5 * before) << i;
        EXPECT_EQ(motion.vertical_mps2[i], 0.1 * motion.horizontal_mps2[i]) << i;
    }
    EXPECT_EQ(motion.horizontal_mps2[25], 0);
    EXPECT_NE(source->about().text.find("transverse 0.5 of it, 0.25 s later"), std::string::npos);
}

TEST(Pulse, RefusesNonsense) {
    testing::expect_input_error([] { (void)pulse("one_sine"); }, "c.toml:4:", "'one-sine'?");
    testing::expect_input_error([] { (void)source_of("source='pulse'\nshape='ricker'\namplitude=1\n"); },
                                "period, periods");
    testing::expect_input_error([] { (void)source_of("source='pulse'\nshape='ricker'\namplitude=-1\nperiod=1"); },
                                "c.toml:3:", "amplitude");
    testing::expect_input_error([] { (void)pulse("ricker", "time_step=1e-6"); }, "c.toml:5:", "Raise it");
}

}  // namespace
}  // namespace overturn
