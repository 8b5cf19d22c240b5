#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "core/boundary.hpp"
#include "core/units.hpp"
#include "generators/pulse_shape.hpp"
#include "qualify/detail/published_parts.hpp"
#include "rocking/closed_forms.hpp"
#include "rocking/overturning_search.hpp"
#include "rocking/rocking_accuracy.hpp"

namespace overturn::qualify {
namespace {

PulseShape shape_of(std::string_view name) { return config::find_entry(pulse_shapes(), name, "pulse").value({}); }

// Amplitudes over alpha g, of a block of alpha 0.25 and restitution 0.9.
std::vector<FateRange> ranges_of(char const* pulse_name, double omega_over_p, Restoring restoring) {
    RockingBlock const block{.alpha_rad = 0.25, .p_radps = 2, .restitution = 0.9};
    double const period = 2 * pi / (omega_over_p * block.p_radps);
    constexpr double samples = 8000;
    auto const pulse = sample_pulse_alone(shape_of(pulse_name), period, period / samples);
    auto ranges = overturning_ranges(block, {.horizontal_mps2 = pulse.values, .time_step_s = pulse.time_step_s},
                                     {.highest = 10, .step = 0.05, .accuracy = {.restoring = restoring}})
                      .ranges;
    for (auto& range : ranges) {
        range.from /= block.alpha_rad * block.gravity_mps2;
        range.to /= block.alpha_rad * block.gravity_mps2;
    }
    return ranges;
}

// Where the fate begins the first time.
double start_of(std::vector<FateRange> const& ranges, Fate fate) {
    auto const found = std::ranges::find(ranges, fate, &FateRange::fate);
    return found == ranges.end() ? std::nan("") : found->from;
}

double end_of(std::vector<FateRange> const& ranges, Fate fate) {
    auto const found = std::ranges::find(ranges, fate, &FateRange::fate);
    return found == ranges.end() ? std::nan("") : found->to;
}

constexpr double of_chords = 1e-7;  // (2 pi / 8000)^2 / 8 of a sine, and a little
constexpr double seven_digits = 1e-6;

std::string decided(std::string const& by) {
    return fmt::format("{}; the difference is of the chords of 8000 samples a period", by);
}

Checks of_half_sines() {
    struct Known {
        char const* number;
        double ratio;
    };
    Checks all;
    for (auto const& [number, ratio] : {Known{"L-01", 1}, Known{"L-02", 4}, Known{"L-03", 10}}) {
        auto const found = ranges_of("half-sine", ratio, Restoring::linear);
        all.push_back(
            relative(number, fmt::format("least half-sine that overturns the linearised block, omega/p {:g}", ratio),
                     "Shi and others (1996), closed form", "alpha g", start_of(found, Fate::without_impact),
                     sine_without_impact(ratio, 1), of_chords,
                     decided(fmt::format("{}: cos x + exp((x - pi) p/omega) = (omega/p) sin x, 1 / sin x", derived))));
    }
    return all;
}

Checks of_one_sine() {
    constexpr double ratio = 5;
    auto const linear = ranges_of("one-sine", ratio, Restoring::linear);
    auto const nonlinear = ranges_of("one-sine", ratio, Restoring::nonlinear);
    struct Edge {
        char const *number, *nonlinear_number, *what;
        double (*of)(std::vector<FateRange> const&);
        double linear, nonlinear;
        char const* equation;
    };
    constexpr char const* piecewise = "hyperbolic sines and cosines between the impacts, bisected apart";
    std::array const edges{
        Edge{"L-04", "L-07", "least one-sine that overturns the {} block",
             [](auto const& ranges) { return start_of(ranges, Fate::after_impact); }, 3.018599860872, 3.032339,
             piecewise},
        Edge{"L-05", "L-08", "one-sine from which on the {} block stands again",
             [](auto const& ranges) { return end_of(ranges, Fate::after_impact); }, 6.318070529827, 6.743019,
             piecewise},
        Edge{"L-06", "L-09", "least one-sine that overturns the {} block without an impact",
             [](auto const& ranges) { return start_of(ranges, Fate::without_impact); }, sine_without_impact(ratio, 2),
             7.493000, "cos x - exp((x - 2 pi) p/omega) = (omega/p) sin x, 1 / sin x"}};
    Checks all;
    for (auto const& edge : edges) {
        all.push_back(relative(edge.number, fmt::format(fmt::runtime(edge.what), "linearised") + ", omega/p 5, e 0.9",
                               "Zhang and Makris (2001), closed form", "alpha g", edge.of(linear), edge.linear,
                               of_chords, decided(fmt::format("{}: {}", derived, edge.equation))));
    }
    for (auto const& edge : edges) {
        all.push_back(relative(
            edge.nonlinear_number, fmt::format(fmt::runtime(edge.what), "nonlinear") + ", alpha 0.25, omega/p 5, e 0.9",
            "Zhang and Makris (2001), problem; independent integration", "alpha g", edge.of(nonlinear), edge.nonlinear,
            seven_digits, decided("solved again, as the paper prints figures alone; known to seven digits")));
    }
    return all;
}

Check of_ricker() {
    return relative("L-31", "least Ricker pulse that overturns the nonlinear block, alpha 0.25, omega/p 3, e 0.9",
                    "Ricker (1953), pulse; independent integration", "alpha g",
                    start_of(ranges_of("ricker", 3, Restoring::nonlinear), Fate::after_impact), 2.765281, seven_digits,
                    decided("solved again, no paper at hand prints this number; known to seven digits"));
}

}  // namespace

Checks published_pulses() {
    auto all = of_half_sines();
    auto const one_sine = of_one_sine();
    all.insert(all.end(), one_sine.begin(), one_sine.end());
    all.push_back(of_ricker());
    return all;
}

}  // namespace overturn::qualify
