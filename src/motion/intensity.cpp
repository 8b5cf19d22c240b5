#include "motion/intensity.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/polynomial.hpp"
#include "core/units.hpp"
#include "motion/ground_motion.hpp"

namespace overturn {
namespace {

// May the velocity pass zero in a step? It strays by a step of the larger acceleration at most.
bool may_turn(double velocity, double a0, double a1, double dt) {
    constexpr double rounding = 1 + 1e-9;
    return std::abs(velocity) <= rounding * dt * std::max(std::abs(a0), std::abs(a1));
}

// The largest |displacement| where it turns inside a step, or 0.
double turning_displacement(double displacement, std::array<double, 3> const& velocity, double dt) {
    std::array const d{displacement, velocity[0], velocity[1] / 2, velocity[2] / 3};
    double largest = 0;
    auto const turns = roots_in(velocity, 0.0, dt);
    for (double const t : turns.all()) {
        largest = std::max(largest, std::abs(evaluate(d, t)));
    }
    return largest;
}

}  // namespace

Intensity intensity_of(std::span<double const> acceleration_mps2, double time_step_s) {
    OVERTURN_EXPECT(time_step_s > 0);
    double const dt = time_step_s;
    Intensity peak{.pga_mps2 = peak_of(acceleration_mps2)};
    peak.vector_pga_mps2 = peak.pga_mps2;
    double squares = 0;  // integral of a^2 over dt / 3
    double velocity = 0, peak_velocity = 0;
    double displacement = 0, peak_displacement = 0;
    for (std::size_t i = 1; i < acceleration_mps2.size(); ++i) {
        double const a0 = acceleration_mps2[i - 1];
        double const a1 = acceleration_mps2[i];
        auto const v = [&] { return std::array{velocity, a0, (a1 - a0) / (2 * dt)}; };  // few steps need its quotient
        if ((a0 < 0) != (a1 < 0)) {
            peak_velocity = std::max(peak_velocity, std::abs(evaluate(v(), dt * a0 / (a0 - a1))));
        }
        if (may_turn(velocity, a0, a1, dt)) {
            peak_displacement = std::max(peak_displacement, turning_displacement(displacement, v(), dt));
        }
        displacement += velocity * dt + dt * dt / 3 * a0 + dt * dt / 6 * a1;
        velocity += 0.5 * dt * (a0 + a1);
        peak_velocity = std::max(peak_velocity, std::abs(velocity));
        peak_displacement = std::max(peak_displacement, std::abs(displacement));
        squares += a0 * a0 + a0 * a1 + a1 * a1;
    }
    peak.pgv_mps = peak_velocity;
    peak.pgd_m = peak_displacement;
    peak.arias_mps = pi / (2 * g0) * squares * dt / 3;
    return peak;
}

Intensity intensity_of(GroundMotion const& motion) {
    auto intensity = intensity_of(motion.horizontal_mps2, motion.time_step_s);
    // A length of linear functions is convex: it peaks at a sample.
    for (std::size_t i = 0; i < motion.transverse_mps2.size(); ++i) {
        intensity.vector_pga_mps2 =
            std::max(intensity.vector_pga_mps2, std::hypot(motion.horizontal_mps2[i], motion.transverse_mps2[i]));
    }
    return intensity;
}

namespace {

std::string changes_of(std::vector<double> const& from, double from_step_s, std::vector<double> const& to,
                       double to_step_s) {
    auto const before = intensity_of(from, from_step_s);
    auto const after = intensity_of(to, to_step_s);
    auto const change = [](double a, double b) {
        constexpr double percent = 100;
        return a > 0 ? fmt::format("{:+.3g} %", percent * (b - a) / a) : std::string("0 %");
    };
    return fmt::format("PGA {}, PGV {}, PGD {}", change(before.pga_mps2, after.pga_mps2),
                       change(before.pgv_mps, after.pgv_mps), change(before.pgd_m, after.pgd_m));
}

}  // namespace

std::string changes_text(GroundMotion const& from, GroundMotion const& to) {
    auto text = changes_of(from.horizontal_mps2, from.time_step_s, to.horizontal_mps2, to.time_step_s);
    for (auto const& [name, component] :
         {std::pair{"transverse", &GroundMotion::transverse_mps2}, {"vertical", &GroundMotion::vertical_mps2}}) {
        if (!(from.*component).empty()) {
            text += fmt::format("; {} {}", name,
                                changes_of(from.*component, from.time_step_s, to.*component, to.time_step_s));
        }
    }
    return text;
}

}  // namespace overturn
