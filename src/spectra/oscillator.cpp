#include "spectra/oscillator.hpp"

#include <cmath>

#include "core/error.hpp"

namespace overturn {
namespace {

// In steps as the unit of time: h'' + 2c h' + x^2 h = 0 from h(0) = 0, h'(0) = 1, and its integrals over one step
// h1 = int h, h2 = int (1-s) h, h3 = int (1-s)^2/2 h. Everything else follows from these five numbers.
struct Impulse {
    double h, rate, h1, h2, h3;
};

Impulse by_series(double x, double c) {
    constexpr int terms = 32;  // (2 x)^k / k! with x < 1 is below rounding long before
    double before = 0;
    double now = 1;  // coefficients of s^(k-1) and s^k, from k = 1
    Impulse sum{0, 0, 0, 0, 0};
    for (int k = 1; k < terms; ++k) {
        sum.h += now;
        sum.rate += k * now;
        sum.h1 += now / (k + 1);
        sum.h2 += now / ((k + 1) * (k + 2));
        sum.h3 += now / ((k + 1) * (k + 2) * (k + 3));
        double const next = -(2 * c * k * now + x * x * before) / (k * (k + 1));
        before = now;
        now = next;
    }
    return sum;
}

// int_0^1 exp(-z s) (1-s)^(n-1)/(n-1)! ds for n = 1, 2, 3, z >= 0.
struct Phi {
    double one, two, three;
};

Phi phi_of(double z) {
    if (z < 1) {
        Phi sum{0, 0, 0};
        double term = 1;
        for (int k = 0; k < 20; ++k) {
            sum.one += term / (k + 1);
            sum.two += term / ((k + 1) * (k + 2));
            sum.three += term / ((k + 1) * (k + 2) * (k + 3));
            term *= -z / (k + 1);
        }
        return sum;
    }
    double const one = -std::expm1(-z) / z;
    double const two = (1 - one) / z;
    return {one, two, (0.5 - two) / z};
}

Impulse far_above_critical(double x, double c, double d) {
    double const fast = c + d;
    double const slow = x * x / fast;
    auto const a = phi_of(slow);
    auto const b = phi_of(fast);
    double const scale = 1 / (2 * d);
    return {(std::exp(-slow) - std::exp(-fast)) * scale, (fast * std::exp(-fast) - slow * std::exp(-slow)) * scale,
            (a.one - b.one) * scale, (a.two - b.two) * scale, (a.three - b.three) * scale};
}

Impulse by_closed_form(double x, double c) {
    double const d2 = (x - c) * (x + c);
    double const d = std::sqrt(std::abs(d2));
    double cosine = 1;
    double sine_over_d = 1;
    if (d2 > 0) {
        cosine = std::cos(d);
        sine_over_d = std::sin(d) / d;
    } else if (d2 < 0) {
        cosine = std::cosh(d);
        sine_over_d = std::sinh(d) / d;
    }
    double const decay = std::exp(-c);
    Impulse i{decay * sine_over_d, decay * (cosine - c * sine_over_d), 0, 0, 0};
    // The equation itself, multiplied by 1, (1-s), (1-s)^2/2 and integrated; x is not small here.
    i.h1 = (1 - i.rate - 2 * c * i.h) / (x * x);
    i.h2 = (1 - i.h - 2 * c * i.h1) / (x * x);
    i.h3 = (0.5 - i.h1 - 2 * c * i.h2) / (x * x);
    return i;
}

Impulse impulse_of(double x, double c) {
    if (x < 1 && c < 1) {
        return by_series(x, c);
    }
    double const d2 = (c - x) * (c + x);
    return d2 > 0.25 ? far_above_critical(x, c, std::sqrt(d2)) : by_closed_form(x, c);
}

}  // namespace

OscillatorStep::OscillatorStep(double angular_frequency_radps, double damping, double step_s) {
    validate(angular_frequency_radps >= 0 && std::isfinite(angular_frequency_radps),
             "angular frequency {} rad/s (must be finite and not negative). Give a positive period",
             angular_frequency_radps);
    validate(damping >= 0 && std::isfinite(damping), "damping ratio {} (must be finite and not negative). Use 0.05",
             damping);
    validate(step_s > 0 && std::isfinite(step_s), "time step {} s (must be positive and finite). Mend it", step_s);
    double const x = angular_frequency_radps * step_s;
    double const c = damping * x;
    auto const i = impulse_of(x, c);
    double const dt2 = step_s * step_s;
    yy = i.rate + 2 * c * i.h;
    yv = step_s * i.h;
    ya0 = -dt2 * (i.h1 - i.h2);
    ya1 = -dt2 * i.h2;
    vy = -x * x * i.h / step_s;
    vv = i.rate;
    va0 = -step_s * (i.h - i.h1);
    va1 = -step_s * i.h1;
    my = i.h + 2 * c * i.h1;
    mv = step_s * i.h1;
    ma0 = -dt2 * (i.h2 - i.h3);
    ma1 = -dt2 * i.h3;
}

}  // namespace overturn
