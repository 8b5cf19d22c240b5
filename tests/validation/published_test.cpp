// Requirement: what others published or integrated on their own is met: Housner's spectral intensities of
// El Centro, and the displacement of a rigid body that slides.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/units.hpp"
#include "motion/record.hpp"
#include "rocking/planar_rocking.hpp"
#include "spectra/response_spectrum.hpp"
#include "support/read_record.hpp"

namespace overturn {
namespace {

// Integral of the pseudo-velocity from 0.1 to 2.5 s [m].
double spectral_intensity(GroundMotion const& motion, double damping) {
    constexpr double from_s = 0.1;
    constexpr double to_s = 2.5;
    constexpr int steps = 480;
    std::vector<double> periods;
    for (int i = 0; i <= steps; ++i) {
        periods.push_back(from_s + (to_s - from_s) * i / steps);
    }
    auto const spectrum = response_spectrum(motion.horizontal_mps2, motion.time_step_s, periods, damping);
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        sum +=
            0.5 * (spectrum.psv_mps[static_cast<std::size_t>(i)] + spectrum.psv_mps[static_cast<std::size_t>(i) + 1]);
    }
    return sum * (to_s - from_s) / steps;
}

// Housner's 8.35, 2.71 and 1.89 ft are of another digitisation of the record, by an analogue machine: found are 6.0 %
// more undamped, where every digit is felt, and 1.8 and 3.7 % less.
TEST(Published, SpectralIntensityOfElCentro) {
    auto const* const named = std::getenv("OVERTURN_RECORDS");
    std::filesystem::path const folder =
        named != nullptr ? std::filesystem::path(named) : std::filesystem::path(OVERTURN_SOURCE "/../shared/records");
    std::ifstream file(folder / "csv_two_column" / "ImperialValley1940_ElCentro_NS.csv", std::ios::binary);
    if (!file) {
        GTEST_SKIP() << "no record of El Centro: set OVERTURN_RECORDS to a folder of records";
    }
    std::string const content((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    RecordRequest request;
    request.unit_mps2 = 0.01;
    auto const motion = testing::read_record(content, request);
    constexpr double foot_m = 0.3048;
    struct Case {
        double damping, feet, tolerance;
    };
    for (auto const& [damping, feet, tolerance] : {Case{0, 8.35, 0.07}, {0.2, 2.71, 0.03}, {0.4, 1.89, 0.05}}) {
        double const found = spectral_intensity(motion, damping) / foot_m;
        EXPECT_NEAR(found / feet, 1, tolerance) << "damping " << damping;
        RecordProperty("feet_at_" + std::to_string(damping), std::to_string(found));
    }
}

// A sample interval's straight line of acceleration.
struct Line {
    double from, rate;
    [[nodiscard]] double at(double t) const { return from + rate * t; }
};

// Slip of a rigid body on a level ground, by small steps of its relative velocity: nothing of ours but the law of
// Coulomb.
double peak_slip(std::vector<double> const& wave, double step_s, double friction) {
    constexpr int parts = 2000;
    double const h = step_s / parts;
    double const most = friction * g0;
    double v = 0;
    double x = 0;
    double peak = 0;
    for (std::size_t i = 0; i + 1 < wave.size(); ++i) {
        Line const line{wave[i], (wave[i + 1] - wave[i]) / step_s};
        for (int k = 0; k < parts; ++k) {
            double const a = line.at((k + 0.5) * h);
            if (v == 0 && std::abs(a) <= most) {
                continue;
            }
            double const grip = v != 0 ? -std::copysign(most, v) : std::copysign(most, a);
            double next = v + (-a + grip) * h;
            next = v != 0 && (next > 0) != (v > 0) ? 0 : next;
            x += 0.5 * (v + next) * h;
            v = next;
            peak = std::max(peak, std::abs(x));
        }
    }
    for (; v != 0;) {  // after the wave friction alone acts
        x += v * std::abs(v) / (2 * most);
        peak = std::max(peak, std::abs(x));
        v = 0;
    }
    return peak;
}

// The sliding spectrum: peak slip over friction, of a body too wide to rock.
TEST(Published, SlidingSpectrumIsThatOfAnIndependentIntegrator) {
    constexpr double step_s = 0.01;
    std::vector<double> wave(2001, 0.0);
    for (std::size_t i = 0; i < 1500; ++i) {
        double const t = step_s * static_cast<double>(i);
        double const rise = std::pow(std::sin(std::numbers::pi * t / 15), 2);
        wave[i] = rise * (3 * std::sin(2.3 * t) + 4 * std::sin(5.9 * t + 1) + 2 * std::sin(17 * t));
    }
    for (double const friction : {0.05, 0.1, 0.2, 0.3, 0.45, 0.6}) {
        RockingBlock const block{.alpha_rad = std::atan(3.0),
                                 .p_radps = 2,
                                 .restitution = 0.5,
                                 .friction_static = friction,
                                 .friction_kinetic = friction};
        auto const found =
            simulate_rocking(block, {.horizontal_mps2 = wave, .time_step_s = step_s}, {}, {}, nullptr, Slip::simulated);
        double const expected = peak_slip(wave, step_s, friction);
        EXPECT_GT(expected, 1e-3);
        EXPECT_NEAR(found.peak_slip_m / expected, 1, 1e-4) << friction;
    }
}

}  // namespace
}  // namespace overturn
