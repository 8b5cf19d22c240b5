#include "motion/ground_motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.hpp"

namespace overturn {

void GroundMotion::scale(double factor) {
    for (auto* component : {&horizontal_mps2, &transverse_mps2, &vertical_mps2}) {
        for (double& a : *component) {
            a *= factor;
        }
    }
}

void validate_motion(GroundMotion const& motion) {
    validate(motion.time_step_s > 0 && std::isfinite(motion.time_step_s),
             "time step {} s (must be positive and finite). State the step of the samples", motion.time_step_s);
    validate(motion.samples() > 0, "no horizontal sample (nothing to shake with). Give at least one");
    for (auto const* component : {&motion.horizontal_mps2, &motion.transverse_mps2, &motion.vertical_mps2}) {
        validate(component->empty() || component->size() == motion.samples(),
                 "components of {} and {} samples (they must agree). Cut them to one length", motion.samples(),
                 component->size());
        auto const bad =
            std::find_if_not(component->begin(), component->end(), [](double a) { return std::isfinite(a); });
        validate(bad == component->end(), "sample {} is not a finite number (it cannot be integrated). Mend the motion",
                 bad - component->begin() + 1);
    }
}

std::vector<double> velocity_of(std::span<double const> acceleration_mps2, double time_step_s) {
    std::vector<double> velocity(acceleration_mps2.size(), 0.0);
    for (std::size_t i = 1; i < velocity.size(); ++i) {
        velocity[i] = velocity[i - 1] + 0.5 * time_step_s * (acceleration_mps2[i - 1] + acceleration_mps2[i]);
    }
    return velocity;
}

std::vector<double> displacement_of(std::span<double const> acceleration_mps2, double time_step_s) {
    std::vector<double> displacement(acceleration_mps2.size(), 0.0);
    double velocity = 0;
    double const third = time_step_s * time_step_s / 3;
    double const sixth = time_step_s * time_step_s / 6;
    for (std::size_t i = 1; i < displacement.size(); ++i) {
        double const a0 = acceleration_mps2[i - 1];
        double const a1 = acceleration_mps2[i];
        displacement[i] = displacement[i - 1] + velocity * time_step_s + third * a0 + sixth * a1;
        velocity += 0.5 * time_step_s * (a0 + a1);
    }
    return displacement;
}

double peak_of(std::span<double const> values) {
    constexpr std::size_t width = 4;
    std::array<double, width> peaks{};  // side by side: one would wait for itself
    std::size_t i = 0;
    for (; i + width <= values.size(); i += width) {
        for (std::size_t j = 0; j < width; ++j) {
            peaks[j] = std::max(peaks[j], std::abs(values[i + j]));
        }
    }
    for (; i < values.size(); ++i) {
        peaks[0] = std::max(peaks[0], std::abs(values[i]));
    }
    return std::max(std::max(peaks[0], peaks[1]), std::max(peaks[2], peaks[3]));
}

}  // namespace overturn
