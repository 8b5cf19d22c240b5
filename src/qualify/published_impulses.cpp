#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <fmt/format.h>

#include "core/boundary.hpp"
#include "core/units.hpp"
#include "generators/pulse_shape.hpp"
#include "qualify/detail/published_parts.hpp"
#include "rocking/planar_rocking.hpp"

namespace overturn::qualify {
namespace {

constexpr double at_once_s = 5e-6;  // half of the base of a triangle of acceleration that stands for an impulse

struct Impacts : RockingObserver {
    struct Impact {
        double time_s, before_radps, after_radps;
    };
    void at(RockingInstant const& instant) override {
        if (instant.rotation_rad != 0) {
            return;
        }
        if (instant.time_s == seen_.time_s && instant.velocity_radps != seen_.velocity_radps) {
            all.push_back({seen_.time_s, seen_.velocity_radps, instant.velocity_radps});
        }
        seen_ = instant;
    }
    std::vector<Impact> all;

  private:
    RockingInstant seen_{};
};

// Let go of at half of alpha.
Check energies() {
    RockingBlock const block{.alpha_rad = 0.25, .p_radps = 2, .restitution = 0.9};
    std::vector<double> const calm(3000, 0.0);
    Impacts impacts;
    (void)simulate_rocking(block, {.horizontal_mps2 = calm, .time_step_s = 0.01}, {},
                           {.rotation_rad = 0.5 * block.alpha_rad}, &impacts);
    constexpr std::size_t third = 2;
    double const left = impacts.all.size() > third
                            ? std::pow(impacts.all[third].after_radps / impacts.all[0].before_radps, 2)
                            : std::nan("");
    return relative("L-25", "energy left after three impacts, e 0.9", "Siconos, example of a rocking block; e^6", "1",
                    left, std::pow(block.restitution, 6), 1e-9, "0.53144 there, sampled");
}

// The block and the cases of the example that comes with the element: 1 m wide, alpha 0.2, by its own gravity.
RockingBlock rocking_bc_block() {
    constexpr double alpha = 0.2, width = 1, gravity = 9.81;
    return {.alpha_rad = alpha,
            .p_radps = std::sqrt(1.5 * gravity * std::sin(alpha) / width),
            .restitution = 1 - 1.5 * std::pow(std::sin(alpha), 2),
            .gravity_mps2 = gravity};
}

Check rocking_bc_period() {
    auto const block = rocking_bc_block();
    std::vector<double> const calm(300, 0.0);
    Impacts impacts;
    (void)simulate_rocking(block, {.horizontal_mps2 = calm, .time_step_s = 0.01}, {.restoring = Restoring::linear},
                           {.rotation_rad = 0.5 * block.alpha_rad}, &impacts);
    double const found = impacts.all.empty() ? std::nan("") : 4 * impacts.all[0].time_s;
    return relative("L-33", "period of a linearised block of 1 m, alpha 0.2, let go of at half of alpha",
                    "OpenSees, RockingBC_example.tcl: its Thousner", "s", found, 3.080961947739, 1e-9,
                    "4/p acosh(2), to which the example holds its element; what the element gives is left out");
}

Check rocking_bc_pulse() {
    auto const block = rocking_bc_block();
    constexpr double omega_over_p = 6, amplitude = 2, samples = 8000;
    double const period = 2 * pi / (omega_over_p * block.p_radps);
    auto const pulse =
        sample_pulse_alone(config::find_entry(pulse_shapes(), "one-sine", "pulse").value({}), period, period / samples);
    auto const out = simulate_rocking(block, {.horizontal_mps2 = pulse.values,
                                              .time_step_s = pulse.time_step_s,
                                              .scale = amplitude * block.alpha_rad * block.gravity_mps2});
    return relative("L-34", "largest rotation over alpha of that block under a one-sine, omega/p 6, 2 alpha g",
                    "OpenSees, RockingBC_example.tcl, problem; independent integration", "1",
                    out.peak_rotation_rad / block.alpha_rad, 0.334273151415, 1e-6,
                    "solved again, with Housner's restitution: the example prints no answer; the difference is of "
                    "the chords of 8000 samples a period");
}

// An impulse, and the opposite one at the first impact: of all times the worst (Nabeshima and others 2016).
class DoubleImpulse {
  public:
    [[nodiscard]] bool overturns(double velocity_mps) const {
        std::vector<double> wave(samples_, 0.0);
        wave[1] = velocity_mps / at_once_s;
        Impacts impacts;
        auto const first = simulate_rocking(block_, shaking(wave), {}, {}, &impacts);
        if (first.verdict == Verdict::overturned || impacts.all.empty()) {
            return first.verdict == Verdict::overturned;
        }
        auto const next = static_cast<std::size_t>(impacts.all[0].time_s / at_once_s) + 2;
        wave[next] = -velocity_mps / at_once_s;
        return simulate_rocking(block_, shaking(wave)).verdict == Verdict::overturned;
    }

    [[nodiscard]] double closed_form() const {
        double const cosine = std::cos(block_.alpha_rad);
        return block_.gravity_mps2 * std::sqrt(2 * (1 - cosine)) / (block_.p_radps * cosine * (1 + block_.restitution));
    }

  private:
    [[nodiscard]] static Excitation shaking(std::vector<double> const& wave) {
        return {.horizontal_mps2 = wave, .time_step_s = at_once_s};
    }

    RockingBlock block_{.alpha_rad = 0.25, .p_radps = 2, .restitution = 0.9};
    std::size_t samples_ = 200'000;
};

Check double_impulse() {
    DoubleImpulse const impulses;
    double const high = boundary(
        0.9 * impulses.closed_form(), 1.1 * impulses.closed_form(),
        [&](double velocity) { return impulses.overturns(velocity); }, 24);
    return relative(
        "L-24", "least double impulse that overturns, the second at the first impact, e 0.9",
        "Nabeshima and others (2016), closed form", "m/s", high, impulses.closed_form(), 1e-4,
        fmt::format("{}: g sqrt(2 (1 - cos alpha)) / (p cos alpha (1 + e)); an impulse takes 1e-5 s here", derived));
}

// Ishiyama's least velocity, in metres: 10 B / sqrt(H) of centimetres and cm/s.
Check ishiyama() {
    constexpr double width = 0.5;
    constexpr double height = 2;
    double const alpha = std::atan(width / height);
    double const bound = width / std::sqrt(height);
    RockingBlock const block{.alpha_rad = alpha,
                             .p_radps = std::sqrt(1.5 * g0 / std::hypot(width, height)),
                             .restitution = 1 - 1.5 * std::pow(std::sin(alpha), 2)};
    constexpr int per_cycle = 400;
    constexpr int cycles = 10;
    int fallen = 0;
    constexpr int frequencies = 48;
    for (int n = 0; n <= frequencies; ++n) {
        double const frequency = 0.1 * std::pow(100, static_cast<double>(n) / frequencies);
        std::vector<double> wave(per_cycle * cycles + 1);
        for (std::size_t i = 0; i < wave.size(); ++i) {
            wave[i] = 2 * pi * frequency * bound * std::cos(2 * pi * static_cast<double>(i) / per_cycle);
        }
        auto const out = simulate_rocking(block, {.horizontal_mps2 = wave, .time_step_s = 1 / (frequency * per_cycle)});
        fallen += out.verdict == Verdict::overturned ? 1 : 0;
    }
    return {"L-26",
            "sinusoids at the least velocity that overturns, 0.1 to 10 Hz, that overturn a block of 0.5 m by 2 m",
            "Ishiyama (1982), bound",
            "sinusoids",
            static_cast<double>(fallen),
            0,
            0.5,
            "10 B / sqrt(H) in cm and cm/s is a bound: none may"};
}

// From balance to its side: half of its square is what the centre of gravity falls.
Check landing() {
    RockingBlock const block{.alpha_rad = 0.5, .p_radps = 1.6, .restitution = 0.8};
    std::vector<double> const calm(6000, 0.0);
    auto const out = simulate_rocking(block, {.horizontal_mps2 = calm, .time_step_s = 0.01}, {},
                                      {.rotation_rad = block.alpha_rad * (1 + 1e-9)});
    double const expected = block.p_radps * std::sqrt(2 * (1 - std::sin(block.alpha_rad)));
    auto check = relative(
        "L-27", "angular velocity of a body that lies down from balance, alpha 0.5, p 1.6 rad/s",
        "closed form: potential energy", "rad/s", out.landing_spin_radps, expected, 1e-9,
        "p sqrt(2 (1 - sin alpha)): a fall from rest, and no bound: shaken bodies land up to 1.6 times as fast");
    check.basis = Basis::law;
    return check;
}

}  // namespace

Checks published_impulses() {
    return {double_impulse(), energies(), ishiyama(), landing(), rocking_bc_period(), rocking_bc_pulse()};
}

}  // namespace overturn::qualify
