/// Taylor series of the rocking equation over one step, in mirrored coordinates (phi = s theta >= 0, A = s a / g).
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace overturn::rocking {

/// Forcing at the start of a step and its slope; linear within the step, in units of g.
struct Forcing {
    double horizontal, horizontal_slope;  ///< A [-], dA/dt [1/s]
    double vertical, vertical_slope;      ///< Gv = 1 + a_vertical/g [-], dGv/dt [1/s]
};

/// Housner's block as it is: restoring sin(psi), driving cos(psi).
struct NonlinearRestoring {
    static double uplift_ratio(double alpha) { return std::tan(alpha); }
    /// Potential energy above rest, over m g R. [-]
    static double potential(double alpha, double phi) {
        return 2 * std::sin(alpha - 0.5 * phi) * std::sin(0.5 * phi);  // cos(alpha - phi) - cos(alpha)
    }
    static double top(double alpha) {
        double const s = std::sin(0.5 * alpha);
        return 2 * s * s;
    }
    /// The rotation at which a block of energy `e` < top turns back.
    static double turning_point(double alpha, double e) {
        double const s = std::sqrt(std::fmax(0.0, 0.5 * (top(alpha) - e)));  // sin((alpha - phi)/2)
        return alpha - 2 * std::asin(std::fmin(1.0, s));
    }
};

/// The linearised block of the closed forms: restoring psi, driving 1.
struct LinearRestoring {
    static double uplift_ratio(double alpha) { return alpha; }
    static double potential(double alpha, double phi) { return phi * (alpha - 0.5 * phi); }
    static double top(double alpha) { return 0.5 * alpha * alpha; }
    static double turning_point(double alpha, double e) {
        return alpha - std::sqrt(std::fmax(0.0, alpha * alpha - 2 * e));
    }
};

/// phi, sin(psi) and cos(psi) (or their linear stand-ins) as power series in the time since the step's start.
template <int Order> struct Series {
    std::array<double, Order + 1> phi{};
    std::array<double, Order> sine{};    ///< restoring factor
    std::array<double, Order> cosine{};  ///< driving factor
};

/// phi'' = -p^2 (Gv sin psi + A cos psi), psi' = -phi'.
/// \param from_rest the step starts with the uplift itself, where phi'' is zero to rounding and must not be negative
template <int Order, class Restoring, bool Vertical>
void expand(Series<Order>& s, double alpha, double p, double phi, double omega, Forcing const& forcing,
            bool from_rest) {
    s.phi[0] = phi;
    s.phi[1] = omega;
    constexpr bool nonlinear = std::is_same_v<Restoring, NonlinearRestoring>;
    if constexpr (nonlinear) {
        s.sine[0] = std::sin(alpha - phi);
        s.cosine[0] = std::cos(alpha - phi);
    } else {
        s.sine[0] = alpha - phi;
        s.cosine[0] = 1;
    }
    double const square = p * p;
    for (int k = 0; k + 2 <= Order; ++k) {
        double pull = forcing.horizontal * s.cosine[k];
        if (k > 0) {
            pull += forcing.horizontal_slope * s.cosine[k - 1];
        }
        if constexpr (Vertical) {
            pull += forcing.vertical * s.sine[k];
            if (k > 0) {
                pull += forcing.vertical_slope * s.sine[k - 1];
            }
        } else {
            pull += s.sine[k];
        }
        s.phi[k + 2] = -square * pull / ((k + 1) * (k + 2));
        if (k == 0 && from_rest && s.phi[2] < 0) {
            s.phi[2] = 0;
        }
        if constexpr (nonlinear) {
            double sine = 0;
            double cosine = 0;
            for (int j = 0; j <= k; ++j) {
                double const rate = (j + 1) * s.phi[j + 1];
                sine -= rate * s.cosine[k - j];
                cosine += rate * s.sine[k - j];
            }
            s.sine[k + 1] = sine / (k + 1);
            s.cosine[k + 1] = cosine / (k + 1);
        } else {
            s.sine[k + 1] = -s.phi[k + 1];
            s.cosine[k + 1] = 0;
        }
    }
}

}  // namespace overturn::rocking
