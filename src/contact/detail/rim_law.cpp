#include "contact/detail/rim_law.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.hpp"

namespace overturn {
namespace {

// What an element gives back, by Simpson's rule in t, u = c + (1 - c) t^2: close to c, below which 1 + y u (1 - u^2)
// has its root, points lie closer. Against fifty times as many points: 6e-8.
double rebound(double y) {
    double const end = y > 1 ? -1 / y : -1;
    constexpr int steps = 400;
    double sum = 0;
    for (int i = 0; i <= steps; ++i) {
        double const t = static_cast<double>(i) / steps;
        double const u = end + (1 - end) * t * t;
        double const weight = i == 0 || i == steps ? 1 : i % 2 == 0 ? 2 : 4;
        sum += weight * t * y * u * u / (1 + y * u * (1 - u * u));
    }
    return -end * std::exp(-2 * (1 - end) * sum / (3 * steps));
}

/// Centre of gravity, tilt, their rates, and how far friction's springs are stretched.
using Plane = std::array<double, 7>;
enum : std::size_t { at_x, at_z, tilt, speed_x, speed_z, spin, shear };

/// The rim, or the face within it, in its rocking plane.
class RimPlane {
  public:
    RimPlane(ContactBlock const& plane, std::optional<double> const& inner_m)
        : plane_(plane),
          inner_m_(inner_m),
          w_(plane.vertical_radps()),
          damping_(rim_damping(plane.pad.normal_restitution)) {}

    /// Leaning at rest, so deep that the rim bears the weight.
    [[nodiscard]] Plane leaning(double start_rad) const {
        double const change = plane_.half_width_m * std::abs(std::sin(start_rad));
        double low = -change;
        double high = plane_.settlement_m();
        for (int i = 0; i < 100; ++i) {
            double const middle = (low + high) / 2;
            (pressed({middle, change}, {0, 0}).press < plane_.gravity_mps2 ? low : high) = middle;
        }
        return {0, plane_.centre_height_m * std::cos(start_rad) - low, start_rad, 0, 0, 0, 0};
    }

    /// How far springs stretch that friction holds.
    [[nodiscard]] double most_shear(Plane const& at) const {
        double const ratio = plane_.pad.tangential_ratio;
        return plane_.friction * (rate(at)[speed_z] + plane_.gravity_mps2) / (ratio * w_ * w_);
    }

    [[nodiscard]] Plane rate(Plane const& at) const {
        double const h = plane_.centre_height_m;
        double const r = plane_.half_width_m;
        double const s = std::sin(at[tilt]);
        double const c = std::cos(at[tilt]);
        double const side = s < 0 ? -1 : 1;
        double const base_z = at[at_z] - h * c;
        auto const [press, lever, patch] =
            pressed({-base_z, r * std::abs(s)}, {-(at[speed_z] + at[spin] * h * s), at[spin] * side * r * c});
        double const grip = side * r * patch;
        double const arm_z = -s * grip - c * h;
        double const slide = at[speed_x] + at[spin] * arm_z;
        double const ratio = plane_.pad.tangential_ratio;
        double const drag = 2 * plane_.pad.tangential_damping * std::sqrt(ratio) * w_;
        double const most = plane_.friction * press;
        double const held = std::clamp(-ratio * w_ * w_ * at[shear] - drag * slide, -most, most);
        double const moment = arm_z * held - (c * side * r * lever - s * h * press);
        return {
            at[speed_x], at[speed_z], at[spin], held, press - plane_.gravity_mps2, moment / plane_.inertia_over_mass_m2,
            slide};
    }

  private:
    /// middle + change cos(phi) round the rim.
    struct Round {
        double middle, change;
    };
    struct Pressed {
        double press, lever, patch;  // force, its moment over the radius, and where the elastic pressure has its centre
    };

    // By 64 midpoints of the arc: of other arithmetic than the lanes' eight Gauss nodes.
    [[nodiscard]] Pressed pressed(Round const& depth, Round const& approach) const {
        double const share = depth.change > 0 ? (depth.middle + depth.change) / (2 * depth.change) : 1;
        double const arc = 2 * std::asin(std::sqrt(std::clamp(share, 0.0, 1.0)));
        if (inner_m_) {
            return pressed_by_strips(depth, approach, arc);
        }
        double const k = w_ * w_ / (2 * pi);
        double const elastic = 2 * k * (depth.middle * arc + depth.change * std::sin(arc));
        double const moment =
            2 * k * (depth.middle * std::sin(arc) + depth.change * (arc + std::sin(arc) * std::cos(arc)) / 2);
        double press = elastic;
        double lever = moment;
        constexpr int nodes = 32;
        for (int i = 0; i < nodes; ++i) {
            double const cosine = std::cos((i + 0.5) * arc / nodes);
            double const d = std::max(0.0, depth.middle + depth.change * cosine);
            double const rate = approach.middle + approach.change * cosine;
            double const root = std::sqrt(rate * rate + w_ * w_ * d * d);
            double const more = root > 0 ? std::max(-d, damping_ * d * rate / root) : 0;
            press += 2 * k * arc / nodes * more;
            lever += 2 * k * arc / nodes * more * cosine;
        }
        return {std::max(0.0, press), lever, elastic > 0 ? std::clamp(moment / elastic, 0.0, 1.0) : 1};
    }

    // Chords across the plane, by midpoints.
    [[nodiscard]] Pressed pressed_by_strips(Round const& depth, Round const& approach, double arc) const {
        double const r = plane_.half_width_m;
        double const hole = *inner_m_ / r;
        double const k = w_ * w_ / (pi * (1 - hole * hole));  // over the radius squared
        double elastic = 0;
        double moment = 0;
        double press = 0;
        double lever = 0;
        constexpr int strips = 256;
        for (int i = 0; i < strips; ++i) {
            double const angle = (i + 0.5) * arc / strips;
            double const x = std::cos(angle);
            double const half = std::sin(angle) - std::sqrt(std::max(0.0, hole * hole - x * x));
            double const share = 2 * k * half * std::sin(angle) * arc / strips;
            double const d = std::max(0.0, depth.middle + depth.change * x);
            double const rate = approach.middle + approach.change * x;
            double const root = std::sqrt(rate * rate + w_ * w_ * d * d);
            double const more = root > 0 ? std::max(-d, damping_ * d * rate / root) : 0;
            elastic += share * d;
            moment += share * d * x;
            press += share * (d + more);
            lever += share * (d + more) * x;
        }
        return {std::max(0.0, press), lever, elastic > 0 ? std::clamp(moment / elastic, 0.0, 1.0) : 1};
    }

    ContactBlock const& plane_;
    std::optional<double> inner_m_;
    double w_, damping_;
};

Plane moved(Plane at, Plane const& rate, double time) {
    for (std::size_t i = 0; i < at.size(); ++i) {
        at[i] += time * rate[i];
    }
    return at;
}

// RK4.
Plane stepped(RimPlane const& body, Plane const& at, double step) {
    auto const a = body.rate(at);
    auto const b = body.rate(moved(at, a, step / 2));
    auto const c = body.rate(moved(at, b, step / 2));
    auto const d = body.rate(moved(at, c, step));
    Plane mean{};
    for (std::size_t i = 0; i < mean.size(); ++i) {
        mean[i] = (a[i] + 2 * (b[i] + c[i]) + d[i]) / 6;
    }
    auto next = moved(at, mean, step);
    double const most = body.most_shear(next);
    next[shear] = std::clamp(next[shear], -most, most);
    return next;
}

}  // namespace

double rim_damping(double normal_restitution) {
    validate(normal_restitution >= 0.05 && normal_restitution <= 1,
             "a rim's restitution of {} (it must lie in 0.05 to 1). Take 0.25", normal_restitution);
    double low = 0;
    double high = 8;
    constexpr int halvings = 40;
    for (int i = 0; i < halvings; ++i) {
        double const y = low + (high - low) / 2;
        (rebound(y) > normal_restitution ? low : high) = y;
    }
    return low;
}

double rim_swing_rad(ContactBlock const& plane, double start_rad, double seconds, double step_ratio,
                     std::optional<double> const& inner_m) {
    RimPlane const body(plane, inner_m);
    double const steps = std::ceil(seconds * plane.vertical_radps() / step_ratio);
    auto at = body.leaning(start_rad);
    double least = at[tilt];
    for (int i = 0; i < static_cast<int>(steps); ++i) {
        at = stepped(body, at, seconds / steps);
        least = std::min(least, at[tilt]);
    }
    return std::max(0.0, -least);
}

}  // namespace overturn
