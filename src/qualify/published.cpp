#include "qualify/published.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "core/boundary.hpp"
#include "core/units.hpp"
#include "qualify/detail/published_parts.hpp"
#include "qualify/known_answers.hpp"
#include "rocking/overturning_search.hpp"
#include "rocking/planar_rocking.hpp"

namespace overturn::qualify {
namespace {

// A block at once on moving ground: angular momentum about the corner is kept, then energy decides.
Check velocity_step() {
    RockingBlock const block{.alpha_rad = 0.25, .p_radps = 2, .restitution = 0.9};
    constexpr double at_once_s = 5e-6;
    std::vector<double> const triangle{0, 1, 0};
    auto const found = overturning_ranges(block, {.horizontal_mps2 = triangle, .time_step_s = at_once_s},
                                          {.highest = 1e6, .step = 0.5});
    double const expected = block.gravity_mps2 * std::sqrt(2 * (1 - std::cos(block.alpha_rad)))
                            / (block.p_radps * std::cos(block.alpha_rad));
    auto check =
        relative("L-10", "least step of the ground's velocity that overturns, alpha 0.25, p 2 rad/s",
                 "closed form: angular momentum about the corner, then energy", "m/s", found.overturning() * at_once_s,
                 expected, 2e-5, "g sqrt(2 (1 - cos alpha)) / (p cos alpha); the step takes 1e-5 s here");
    check.basis = Basis::law;
    return check;
}

/// The largest of one quantity, either way, before a time.
class PeakUntil : public RockingObserver {
  public:
    PeakUntil(double RockingInstant::*quantity, double until_s) : quantity_(quantity), until_s_(until_s) {}
    void at(RockingInstant const& instant) override {
        peak = instant.time_s > until_s_ ? peak : std::max(peak, std::abs(instant.*quantity_));
    }
    double peak = 0;

  private:
    double RockingInstant::*quantity_;
    double until_s_;
};

// In which of his modes a block of h/b = 2 at rest begins under 1 g.
Checks shenton() {
    RockingBlock block{.alpha_rad = std::atan(0.5), .p_radps = 2, .restitution = 0.5};
    std::vector<double> const pulse(11, block.gravity_mps2);
    constexpr double dt = 1e-3;
    auto const peak = [&](double RockingInstant::*quantity, double friction) {
        block.friction_static = block.friction_kinetic = friction;
        PeakUntil seen(quantity, dt * static_cast<double>(pulse.size() - 1));
        (void)simulate_rocking(block, {.horizontal_mps2 = pulse, .time_step_s = dt}, {}, {}, &seen, Slip::simulated);
        return seen.peak;
    };
    double const rocks =
        boundary(0.3, 0.6, [&](double friction) { return peak(&RockingInstant::rotation_rad, friction) > 0; });
    double const holds =
        boundary(0.5, 0.7, [&](double friction) { return peak(&RockingInstant::slip_m, friction) == 0; });
    constexpr double bracket = 1e-6;
    auto const decided = [](char const* by) {
        return fmt::format("{}: {}; looked for over the 10 ms of the pulse, the initiation is at once", derived, by);
    };
    return {
        relative("L-32", "friction from which a block of h/b = 2 that slides under 1 g rocks as well",
                 "Shenton (1996), modes", "1", rocks, 0.5, bracket, decided("b/h")),
        relative("L-11", "friction from which it rocks without slip", "Shenton (1996), modes", "1", holds, 14.0 / 23,
                 bracket, decided("(1 - q h/b) / (1 + q), q = 3 (h/b - 1) / (4 (1 + (h/b)^2)), which is 14/23"))};
}

class SlipSeen : public RockingObserver {
  public:
    explicit SlipSeen(double from_s) : from_s_(from_s) {}
    void at(RockingInstant const& instant) override {
        if (instant.time_s >= from_s_) {
            least_ = std::min(least_, instant.slip_m);
            most_ = std::max(most_, instant.slip_m);
        }
    }
    [[nodiscard]] double amplitude() const { return 0.5 * (most_ - least_); }

  private:
    double from_s_, least_ = 1e300, most_ = -1e300;
};

// Begun where the steady slip turns, or where it sets in if it sticks at each turn: there is nothing to die away.
double slip_amplitude(double eta) {
    constexpr double acceleration = 4;
    constexpr int per_cycle = 4000;
    constexpr int cycles = 6;
    double const turn = 0.5 * pi * eta;
    double const phase = turn < std::sqrt(1 - eta * eta) ? std::acos(turn) : std::asin(eta);
    std::vector<double> wave(per_cycle * cycles + 1);
    for (std::size_t i = 0; i < wave.size(); ++i) {
        wave[i] = acceleration * std::sin(phase + 2 * pi * static_cast<double>(i) / per_cycle);
    }
    double const friction = eta * acceleration / g0;
    RockingBlock const slab{
        .alpha_rad = 1.3, .p_radps = 2, .restitution = 0.5, .friction_static = friction, .friction_kinetic = friction};
    SlipSeen seen(cycles - 1);
    (void)simulate_rocking(slab, {.horizontal_mps2 = wave, .time_step_s = 1.0 / per_cycle}, {}, {}, &seen,
                           Slip::simulated);
    return seen.amplitude();
}

Checks harmonic_slip() {
    struct Known {
        char const* number;
        double eta, expected;
        char const* equation;
    };
    constexpr char const* slips_on = "(a / omega^2) sqrt(1 - (pi eta / 2)^2)";
    constexpr char const* sticks = "it sticks at each turn and slips from the phase of sine eta on";
    Checks all;
    for (auto const& [number, eta, expected, equation] :
         {Known{"L-12", 0.1, 0.100063376395, slips_on}, Known{"L-13", 0.5, 0.062716889887, slips_on},
          Known{"L-14", 0.8, 0.009513781657, sticks}}) {
        all.push_back(relative(
            number, fmt::format("steady amplitude of slip under 4 m/s2 at 1 Hz, friction {:g} of it", eta),
            "Den Hartog (1931)", "m", slip_amplitude(eta), expected, 3e-6,
            fmt::format("{}: {}; the difference is of the chords of 4000 samples a cycle", derived, equation)));
    }
    return all;
}

struct Orbit {
    char const* number;
    double sigma, k, restitution, middle, largest;
};

// Let go on the steady orbit, in the middle of a half cycle.
Check steady_rocking(Orbit const& o) {
    RockingBlock const block{.alpha_rad = 0.2, .p_radps = 2, .restitution = o.restitution};
    double const half = pi / (2 * o.sigma);
    double const c = o.k / (1 + o.sigma * o.sigma);
    double const sine = (o.middle - 1 + 1 / std::cosh(half)) / c;
    double const r = (1 - o.restitution) / (1 + o.restitution);
    double const d = std::tanh(half);
    double const cosine = r * o.sigma * d * sine + r * d * d / c;
    double const rate = o.sigma * c * cosine - c * cosine / std::sinh(half);
    constexpr int per_cycle = 4000;
    constexpr int cycles = 10;
    double const dt = 2 * pi / (o.sigma * block.p_radps) / per_cycle;
    std::vector<double> wave(std::size_t{per_cycle} * cycles);
    for (std::size_t i = 0; i < wave.size(); ++i) {
        wave[i] = o.k * block.gravity_mps2 * block.alpha_rad
                  * std::sin(2 * pi * static_cast<double>(i) / per_cycle + std::atan2(sine, cosine));
    }
    PeakUntil seen(&RockingInstant::rotation_rad, dt * static_cast<double>(wave.size() - 1));
    (void)simulate_rocking(
        block, {.horizontal_mps2 = wave, .time_step_s = dt}, {.restoring = Restoring::linear},
        {.rotation_rad = o.middle * block.alpha_rad, .velocity_radps = rate * block.alpha_rad * block.p_radps}, &seen);
    return relative(
        o.number,
        fmt::format("largest rotation over alpha under a steady sinusoid, omega/p {:g}, {:g} alpha g, e {:g}", o.sigma,
                    o.k, o.restitution),
        "Spanos and Koh (1984)", "1", seen.peak / block.alpha_rad, o.largest, 2e-6,
        fmt::format("{}: the orbit whose half cycles mirror each other; ten cycles of 4000 samples", derived));
}

}  // namespace

Checks published() {
    Checks all = published_pulses();
    auto const add = [&](Checks const& more) { all.insert(all.end(), more.begin(), more.end()); };
    add({velocity_step()});
    add(shenton());
    add(harmonic_slip());
    for (auto const& orbit :
         {Orbit{"L-15", 3, 1.5, 0.9, 0.27115540, 0.27132594}, Orbit{"L-16", 5, 2, 0.9, 0.12353437, 0.12360780},
          Orbit{"L-17", 8, 4, 0.8, 0.07878169, 0.07896934}}) {
        all.push_back(steady_rocking(orbit));
    }
    add(published_fits());
    add(published_impulses());
    add(published_round_bases());
    auto const half_sine = std::ranges::find(all, "L-02", &Check::number);
    add(published_apart(half_sine->found));
    for (auto& check : all) {
        bool const again = check.remark.starts_with(derived) || check.remark.starts_with(solved_again);
        check.basis = again ? Basis::solved_again : check.basis;
    }
    // What the qualification of an installation holds to published numbers anyway.
    static constexpr std::array<std::string_view, 8> known{"M-06", "M-07", "M-08", "M-10",
                                                           "M-12", "S-06", "S-07", "S-08"};
    for (auto const& checks : {mechanics(), spectra()}) {
        for (auto check : checks) {
            if (std::ranges::count(known, check.number) > 0) {
                check.remark = "rounding, or the digits that are known";
                check.basis = check.number == "M-08" ? Basis::law : Basis::printed;  // an elliptic integral
                all.push_back(std::move(check));
            }
        }
    }
    return all;
}

}  // namespace overturn::qualify
