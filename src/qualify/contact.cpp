#include <cmath>
#include <cstddef>
#include <vector>

#include "contact/planar_contact.hpp"
#include "core/units.hpp"
#include "qualify/detail/type_a.hpp"
#include "qualify/known_answers.hpp"
#include "spatial/spatial_motion.hpp"

namespace overturn::qualify {
namespace {

constexpr Friction grip{0.8, 0.8};

// Where a body is that is let go above its pad, in the end.
struct LastInstant : ContactObserver {
    ContactInstant last;
    void at(ContactInstant const& instant) override { last = instant; }
};

ContactInstant dropped(ContactBlock const& block, std::size_t samples, double step_s, ContactStart const& start) {
    std::vector<double> const calm(samples, 0.0);
    LastInstant observer;
    (void)simulate_contact(block, {.horizontal_mps2 = calm, .time_step_s = 1e-3},
                           {.step_ratio = step_s * block.vertical_radps(), .longest_after_s = 0, .rest_gate = false},
                           start, &observer);
    return observer.last;
}

Check settlement() {
    auto const block = contact_block(type_a(), {}, {}, grip);
    constexpr double height = 1e-3;
    auto const end = dropped(block, 3001, 5e-5, {.rise_m = height});
    double const expected = g0 / (block.vertical_radps() * block.vertical_radps());
    return {"P-01",      "a body that fell on its pad rests where the pad bears its weight",
            "statics",   "m",
            -end.rise_m, expected,
            1e-9};
}

Check rebound() {
    constexpr double restitution = 0.5, speed = 1;
    auto block = contact_block(type_a(), {}, {.normal_restitution = restitution}, grip);
    block.gravity_mps2 = 1e-9;
    auto const end = dropped(block, 41, 1e-5, {.rise_m = 1e-3, .rise_mps = -speed});
    return {"P-02",
            "a point of the base rebounds with the stated restitution",
            "Hunt and Crossley (1975)",
            "1",
            end.rise_mps / speed,
            restitution,
            1e-6};
}

// Pushed at 15 degrees to its base's edge, slowly: what the push must be to tip it.
Check oblique_threshold() {
    constexpr double direction = 15 * pi / 180;
    constexpr std::size_t rise = 2000;
    auto const block = spatial_block(type_a(), {}, Friction{10, 10});
    std::vector<double> x(rise + 500, std::cos(direction));
    std::vector<double> y(rise + 500, std::sin(direction));
    for (std::size_t i = 0; i < rise; ++i) {
        double const share = static_cast<double>(i) / rise;
        x[i] *= share * share * (3 - 2 * share);
        y[i] *= share * share * (3 - 2 * share);
    }
    auto const tips = [&](double level_g) {
        auto const end = simulate_spatial(
            block, {.horizontal_mps2 = x, .transverse_mps2 = y, .time_step_s = 0.01, .scale = level_g * g0},
            {.longest_after_s = 0});
        return end.verdict == Verdict::overturned;
    };
    double const expected = 0.68 / 1.045 / std::cos(direction);
    double low = 0.98 * expected;
    double high = 1.02 * expected;
    while (high - low > 1e-5) {
        double const middle = 0.5 * (low + high);
        (tips(middle) ? high : low) = middle;
    }
    return {"P-03", "a square base tips in space at (b / h) / cos(15 degrees)", "statics", "g", high, expected, 5e-4};
}

}  // namespace

Checks contact() { return {settlement(), rebound(), oblique_threshold()}; }

}  // namespace overturn::qualify
