// Requirement R-105: filtered noise has the density of its published filter, the variance that is its integral, and its
// envelope.
#include "generators/detail/filtered_noise.hpp"

#include <algorithm>
#include <cmath>

#include "generators/envelope.hpp"
#include "generators/wave_quality.hpp"
#include "motion/intensity.hpp"
#include "support/expect_input_error.hpp"
#include "support/sources.hpp"
#include "support/tolerance.hpp"

namespace overturn {
namespace {

using testing::near;

// Trapezoids in log frequency up to `to`; beyond it shape goes with `tail`/w^2.
double numeric_integral(GroundFilter const& filter, double tail) {
    constexpr double from = 1e-5;
    constexpr double to = 1e5;
    constexpr int steps = 400000;
    double const gap = std::log(to / from) / steps;
    double sum = 0;
    for (int i = 0; i <= steps; ++i) {
        double const w = from * std::exp(gap * i);
        sum += (i == 0 || i == steps ? 0.5 : 1.0) * gap * w * filter.shape(w);
    }
    return sum + from * filter.shape(from) + tail / to;
}

TEST(GroundFilter, ClosedFormIntegralsAreThoseOfTheDensity) {
    for (double const z : {0.2, 0.6, 1.0}) {
        GroundFilter filter{.ground_radps = 15.6, .ground_damping = z};
        double const tail = 4 * z * z * 15.6 * 15.6;
        EXPECT_TRUE(near(filter.integral_radps(), numeric_integral(filter, tail), testing::Tolerance{1e-6, "numeric"}));
        filter.filter_radps = 1.56;
        filter.filter_damping = 0.5;
        EXPECT_TRUE(near(filter.integral_radps(), numeric_integral(filter, tail), testing::Tolerance{1e-6, "numeric"}));
    }
}

TEST(GroundFilter, PublishedLimits) {
    GroundFilter filter{.ground_radps = 10, .ground_damping = 0.5};
    EXPECT_TRUE(near(filter.shape(1e-6), 1, testing::exact_formula));            // static
    EXPECT_TRUE(near(filter.shape(10), (1 + 1) / 1.0, testing::exact_formula));  // resonance: (1+4z^2)/4z^2
    filter.filter_radps = 1;
    EXPECT_TRUE(near(filter.shape(1e-4), 1e-16, testing::Tolerance{1e-6, "leading term"}));  // q^4
}

// The mean square of stationary draws is the integral up to the Nyquist frequency; beyond it lies tail/w.
TEST(FilteredNoise, StationaryVarianceIsItsIntegral) {
    for (char const* model : {"kanai-tajimi", "clough-penzien"}) {
        auto const source = testing::source_of(std::string("source='filtered-noise'\nmodel='") + model
                                               + "'\nduration='60 s'\nrms='100 gal'\n[envelope]\nshape='constant'\n");
        double variance = 0;
        constexpr int waves = 60;
        for (std::uint64_t wave = 0; wave < waves; ++wave) {
            auto const a = source->make(3, wave).motion.horizontal_mps2;
            for (std::size_t i = 500; i < 5500; ++i) {
                variance += a[i] * a[i] / 5000 / waves;
            }
        }
        GroundFilter filter{.ground_radps = 2 * pi * 2.5, .ground_damping = 0.6};
        filter.filter_radps = std::string(model) == "clough-penzien" ? 2 * pi * 0.25 : 0;
        double const beyond = 4 * 0.6 * 0.6 * filter.ground_radps * filter.ground_radps / (pi / 0.01);
        double const expected = 1 - beyond / filter.integral_radps();
        EXPECT_NEAR(variance, expected, 0.05) << model;  // one wave scatters by 0.14
    }
}

TEST(FilteredNoise, GrowsAndFadesWithItsEnvelope) {
    auto const source = testing::source_of(
        "source='filtered-noise'\nmodel='clough-penzien'\nduration='60 s'\nrms=1\n"
        "[envelope]\nshape='saragoni-hart'\npeak='10 s'\ngamma=4\n");
    std::vector<double> power(6, 0.0);
    constexpr int waves = 100;
    for (std::uint64_t wave = 0; wave < waves; ++wave) {
        auto const a = source->make(4, wave).motion.horizontal_mps2;
        for (std::size_t i = 0; i < 6000; ++i) {
            power[i / 1000] += a[i] * a[i] / 1000 / waves;
        }
    }
    Envelope const envelope{.shape = EnvelopeShape::saragoni_hart, .peak_s = 10, .gamma = 4};
    for (std::size_t tens = 0; tens < 5; ++tens) {
        double wanted = 0;
        for (int i = 0; i < 1000; ++i) {
            double const e = envelope.at(10.0 * static_cast<double>(tens) + 0.01 * i);
            wanted += e * e / 1000;
        }
        EXPECT_NEAR(power[tens] / wanted, 1, 0.1) << tens;
    }
}

// Property: whatever the model, the ground ends at rest, and its displacement stays that of oscillations:
// Kanai-Tajimi's density, finite at frequency zero, would else carry it off by tens of metres.
TEST(FilteredNoise, EndsAtRestWhereItBegan) {
    for (char const* model : {"kanai-tajimi", "clough-penzien"}) {
        auto const source = testing::source_of(
            std::string("source='filtered-noise'\nmodel='") + model
            + "'\nduration='60 s'\nrms='100 gal'\n[transverse]\nratio=0.8\n[vertical]\nratio=0.5\n"
              "[envelope]\nshape='jennings'\nrise='6 s'\nlevel_end='40 s'\nend='55 s'\n");
        for (std::uint64_t wave = 0; wave < 10; ++wave) {
            auto const motion = source->make(5, wave).motion;
            for (auto const* component : {&motion.horizontal_mps2, &motion.transverse_mps2, &motion.vertical_mps2}) {
                ASSERT_FALSE(component->empty());
                double velocity = 0;
                double displacement = 0;
                double pgv = 0;
                double pgd = 0;
                for (std::size_t i = 1; i < component->size(); ++i) {  // linear between samples
                    double const dt = motion.time_step_s;
                    double const before = (*component)[i - 1];
                    double const after = (*component)[i];
                    displacement += velocity * dt + (2 * before + after) * dt * dt / 6;
                    velocity += 0.5 * (before + after) * dt;
                    pgv = std::max(pgv, std::abs(velocity));
                    pgd = std::max(pgd, std::abs(displacement));
                }
                EXPECT_LT(std::abs(velocity), 1e-9 * pgv) << model << wave;
                EXPECT_LT(std::abs(displacement), 0.05 * pgd) << model << wave;
            }
        }
    }
}

TEST(FilteredNoise, RefusesWhatItCannotMake) {
    auto const noise = [](std::string const& keys) { (void)testing::source_of("source='filtered-noise'\n" + keys); };
    testing::expect_input_error([&] { noise("model='kanai-tajimi'\nduration=10\n"); }, "rms");
    testing::expect_input_error([&] { noise("model='kanai-tajima'\nduration=10\nrms=1\n"); }, "'kanai-tajimi'?");
    testing::expect_input_error([&] { noise("model='kanai-tajimi'\nduration=10\nrms=1\nfilter_damping=0.5\n"); },
                                "filter_damping", "nothing reads it");
    testing::expect_input_error([&] { noise("model='kanai-tajimi'\nduration=0.1\nrms=1\n"); }, "time steps");
}

// Drawn together: of the stated correlation on the mean, the horizontal one as it is alone.
TEST(FilteredNoise, HasThreeComponents) {
    std::string const noise =
        "source='filtered-noise'\nmodel='clough-penzien'\nrms='1 m/s2'\nduration='40.96 s'\ntime_step=0.01\n";
    auto const source = testing::source_of(noise + "transverse={ratio=0.8, correlation=0.6}\nvertical={ratio=0.5}\n");
    double sum = 0;
    double upright = 0;
    double ratio = 0;
    constexpr int waves = 40;
    for (std::uint64_t wave = 0; wave < waves; ++wave) {
        auto const motion = source->make(3, wave).motion;
        sum += correlation_of(motion.horizontal_mps2, motion.transverse_mps2);
        upright += correlation_of(motion.horizontal_mps2, motion.vertical_mps2);
        ratio +=
            intensity_of(motion.transverse_mps2, 0.01).arias_mps / intensity_of(motion.horizontal_mps2, 0.01).arias_mps;
    }
    EXPECT_NEAR(sum / waves, 0.6, 0.03);
    EXPECT_NEAR(upright / waves, 0, 0.04);
    EXPECT_NEAR(ratio / waves, 0.64, 0.05);
    EXPECT_EQ(source->make(3, 1).motion.horizontal_mps2, testing::source_of(noise)->make(3, 1).motion.horizontal_mps2);
    auto const same = testing::source_of(noise + "transverse={ratio=1, correlation=1}\n")->make(3, 1).motion;
    EXPECT_EQ(same.transverse_mps2, same.horizontal_mps2);
    testing::expect_input_error([&] { (void)testing::source_of(noise + "transverse={ratio=1, correlation=1.1}\n"); },
                                "correlation");
}

// However coarse the time step, the noise that it can hold has the rms that was asked for, and what it cuts is
// said.
TEST(FilteredNoise, HasItsRmsAtAnyTimeStep) {
    for (char const* step : {"0.005 s", "0.02 s", "0.05 s"}) {
        auto const source = testing::source_of(
            std::string("source='filtered-noise'\nmodel='kanai-tajimi'\nrms=1\namplitudes='fixed'\ntime_step='") + step
            + "'\nduration='400 s'\n[envelope]\nshape='constant'\n");
        double variance = 0;
        double samples = 0;
        for (std::uint64_t wave = 0; wave < 8; ++wave) {
            for (double const a : source->make(3, wave).motion.horizontal_mps2) {
                variance += a * a;
                samples += 1;
            }
        }
        EXPECT_TRUE(near(variance / samples, 1, testing::Tolerance{0.01, "a window of the period, and its ends"}))
            << step;
        EXPECT_EQ(source->about().text.find("cut at") != std::string::npos, std::string(step) != "0.005 s") << step;
    }
    testing::expect_input_error(
        [] {
            (void)testing::source_of(
                "source='filtered-noise'\nmodel='kanai-tajimi'\nrms=1\nduration='60 s'\nground_frequency='200 Hz'\n");
        },
        "less than 4 time steps a period");
}

}  // namespace
}  // namespace overturn
