#include <cmath>
#include <complex>

#include "spectra/detail/oscillator_sweep.hpp"

namespace overturn {
namespace {

// Of x[n+1], over that of a[n+1].
double of_a_now(OscillatorStep const& c) { return (c.ya0 - c.vv * c.ya1 + c.yv * c.va1) / c.ya1; }
double of_a_last(OscillatorStep const& c) { return (c.yv * c.va0 - c.vv * c.ya0) / c.ya1; }

}  // namespace

void OscillatorGroup::set(std::size_t lane, double w, double damping, OscillatorStep const& sample,
                          double time_step_s) {
    switch (form) {
        case SweepForm::amplitude:
            set_amplitude(lane, w, damping, time_step_s);
            break;
        case SweepForm::samples:
            set_samples(lane, sample);
            break;
        case SweepForm::strided:
            set_strided(lane, w, damping, sample, time_step_s);
            break;
    }
}

// y'' + 2 zeta w y' + w^2 y = -a with a = a0 + s t: the ground's line is p = (-a + 2 zeta s / w) / w^2, and y - p
// = exp(-zeta w t) (f cos(wd t) + q sin(wd t)), q = ((y - p)' + zeta w f) / wd: f + iq turns back by wd t. Where s
// changes, y and y' do not: f changes by -2 zeta / w^3, q by (1 - 2 zeta^2) / (w^2 wd), both times the change of s. C
// is f + iq over the size of that and turned so that the change is imaginary.
void OscillatorGroup::set_amplitude(std::size_t lane, double w, double damping, double dt) {
    double const wd = w * std::sqrt(1 - damping * damping);
    double const decay = std::exp(-damping * w * dt);
    std::complex<double> const jump(-2 * damping / (w * w * w * dt), (1 - 2 * damping * damping) / (w * w * wd * dt));
    double const size = std::abs(jump);
    auto const turned = jump / std::complex<double>(0, size);
    ahead.at(lane) = decay * std::cos(wd * dt);
    behind.at(lane) = decay * std::sin(wd * dt);
    now.at(lane) = turned.real();
    last.at(lane) = turned.imag();
    unit.at(lane) = size;
    double const f0 = 1 / (w * w) - jump.real(), f1 = jump.real();  // f = -p, over a[0] and a[1]
    double const slope = 1 / (w * w * dt);                          // of -p', over a[1] - a[0]
    auto const c0 = std::complex<double>(f0, (damping * w * f0 - slope) / wd) / (size * turned);
    auto const c1 = std::complex<double>(f1, (damping * w * f1 + slope) / wd) / (size * turned);
    state_a0.at(lane) = c0.real();
    state_a1.at(lane) = c1.real();
    other_a0.at(lane) = c0.imag();
    other_a1.at(lane) = c1.imag();
}

void OscillatorGroup::set_samples(std::size_t lane, OscillatorStep const& c) {
    ahead.at(lane) = c.yy + c.vv;
    behind.at(lane) = c.yv * c.vy - c.yy * c.vv;
    now.at(lane) = of_a_now(c);
    last.at(lane) = of_a_last(c);
    unit.at(lane) = c.ya1;
    // At rest x[0] = 0, and x[-1] is what makes x[1] = a[1] + ya0/ya1 a[0].
    other_a0.at(lane) = (c.ya0 / c.ya1 - now.at(lane)) / behind.at(lane);
}

// With A, B the coefficients of x[n] and x[n-1], and b those of a[n] and a[n-1]: w[n+1] = A w[n] + B w[n-1] + a[n+1],
// x[n+1] = w[n+1] + b1 w[n] + b2 w[n-1]; -B is the decay in a step, 1 - A - B = w^2 times what a steady a holds y at.
void OscillatorGroup::set_strided(std::size_t lane, double w, double damping, OscillatorStep const& c, double dt) {
    double const b1 = of_a_now(c);
    double const b2 = of_a_last(c);
    double const stiffness = -w * w * c.ya1 * (1 + b1 + b2);
    double const decay = std::exp(-2 * damping * w * dt);
    ahead.at(lane) = decay - stiffness;
    behind.at(lane) = -stiffness;
    now.at(lane) = 1 + b1;
    last.at(lane) = b2;
    unit.at(lane) = c.ya1;
    // At rest x[0] = 0 and x[1] = a[1] + ya0/ya1 a[0]: two equations for w[0] and w[-1], over a[0].
    double const a = 1 + decay - stiffness;
    double const y0w0 = 1 - b2 / decay, y0w1 = b1 + b2 * a / decay, y0 = -b2 / decay;
    double const y1w0 = a + b1, y1w1 = b2 - decay, y1 = c.ya0 / c.ya1;
    double const determinant = y0w0 * y1w1 - y0w1 * y1w0;
    double const w0 = (y0 * y1w1 - y0w1 * y1) / determinant;
    double const w1 = (y0w0 * y1 - y0 * y1w0) / determinant;
    state_a0.at(lane) = w1;
    other_a0.at(lane) = w0 - w1;
}

}  // namespace overturn
