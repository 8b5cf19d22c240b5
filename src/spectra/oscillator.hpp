/// The damped oscillator under acceleration that is linear between samples: an exact recursion, any damping, any step.
#pragma once

namespace overturn {

/// One step of y'' + 2 zeta w y' + w^2 y = -a (Nigam and Jennings 1969), from (y0, v0) over `step_s` with a going
/// linearly from a0 to a1:
///     y1 = yy y0 + yv v0 + ya0 a0 + ya1 a1,   v1 = vy y0 + vv v0 + va0 a0 + va1 a1,
///     mean of y over the step = my y0 + mv v0 + ma0 a0 + ma1 a1.
/// Coefficients hold to about 1e-15 of their natural size for any w step: a power series where the closed form cancels
/// (w step below 1), exponentials without overflow where damping is above critical.
struct OscillatorStep {
    double yy = 1, yv = 0, ya0 = 0, ya1 = 0;
    double vy = 0, vv = 1, va0 = 0, va1 = 0;
    double my = 1, mv = 0, ma0 = 0, ma1 = 0;

    /// \param angular_frequency_radps w, not negative [rad/s]
    /// \param damping zeta, ratio to critical, not negative [-]
    /// \throws InputError if an argument is negative or not finite, or the step not positive.
    OscillatorStep(double angular_frequency_radps, double damping, double step_s);
};

}  // namespace overturn
