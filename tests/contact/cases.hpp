/// Bodies, waves and instants that the tests of contact share.
#pragma once

#include <cmath>
#include <vector>

#include "contact/planar_contact.hpp"

namespace overturn::testing {

/// A uniform rectangle of 12.6 t, 1.045 m from base to centre: b 0.68 m is type A, 0.45 m the slender B.
inline RigidBody rectangle(double half_width_m) {
    double const h = 1.045;
    double const m = 12.6e3;
    return RigidBody({.mass_kg = m,
                      .half_width_m = half_width_m,
                      .centre_height_m = h,
                      .inertia_kgm2 = m * (half_width_m * half_width_m + h * h) / 3});
}
inline RigidBody body_a() { return rectangle(0.68); }
inline RigidBody body_b() { return rectangle(0.45); }

inline BasePlan bed(double corner_share, int points = 11) {
    return {.shape = BaseShape::square, .corners_m = {}, .corner_share = corner_share, .points = points};
}
inline BasePlan flat_bed(int points = 11) { return bed(flat_share(points), points); }

/// On corners, elastic.
inline ContactBlock on_corners(RigidBody const& body, double friction, Pad const& pad = {}) {
    return contact_block(body, {}, pad, Friction{friction, friction});
}

inline ContactAccuracy steps_of(double seconds, ContactBlock const& block, bool rest_gate = false) {
    return {.step_ratio = seconds * block.vertical_radps(), .rest_gate = rest_gate};
}

/// Keeps every instant.
struct ContactHistory : ContactObserver {
    std::vector<ContactInstant> instants;
    void at(ContactInstant const& instant) override { instants.push_back(instant); }

    /// First time after `from_s` at which a quantity passes zero, by the cubic of its values and rates.
    [[nodiscard]] double zero_of(double ContactInstant::*value, double ContactInstant::*rate, double from_s = 0) const {
        for (std::size_t i = 1; i < instants.size(); ++i) {
            auto const& a = instants[i - 1];
            auto const& b = instants[i];
            if (a.time_s < from_s || (a.*value > 0) == (b.*value > 0)) {
                continue;
            }
            double const step = b.time_s - a.time_s;
            double low = 0;
            double high = 1;
            for (int k = 0; k < 60; ++k) {
                double const u = (low + high) / 2;
                double const cubic = a.*value * (1 + 2 * u) * (1 - u) * (1 - u) + a.*rate * step * u * (1 - u) * (1 - u)
                                     + b.*value * u * u * (3 - 2 * u) - b.*rate * step * u * u * (1 - u);
                ((cubic > 0) == (a.*value > 0) ? low : high) = u;
            }
            return a.time_s + low * step;
        }
        return never;
    }
};

/// So many samples of a constant.
inline std::vector<double> constant(double value, std::size_t samples) { return std::vector<double>(samples, value); }

/// amplitude sin(2 pi f t) for `cycles`, then nothing for `still_s`; samples of 1 ms.
inline std::vector<double> sine(double amplitude, double frequency_hz, double cycles, double still_s,
                                double step_s = 1e-3) {
    auto const count = static_cast<std::size_t>(std::lround((cycles / frequency_hz + still_s) / step_s));
    std::vector<double> wave(count + 1, 0.0);
    for (std::size_t i = 0; i <= count; ++i) {
        double const t = static_cast<double>(i) * step_s;
        wave[i] = t < cycles / frequency_hz ? amplitude * std::sin(2 * pi * frequency_hz * t) : 0;
    }
    return wave;
}

inline ContactOutcome shaken(ContactBlock const& block, std::vector<double> const& wave, double step_s,
                             ContactAccuracy const& accuracy = {}, ContactObserver* observer = nullptr,
                             std::optional<ContactStart> const& start = {}) {
    return simulate_contact(block, {.horizontal_mps2 = wave, .time_step_s = step_s}, accuracy, start, observer);
}

}  // namespace overturn::testing
