/// Capacities of an unanchored body by hand, from energy balances, as cross-checks of simulated ones. Reserve-energy
/// methods of this kind stand in ASCE/SEI 43-05, Appendix A. Read of its public opening: mu_e = mu (1 - 0.4 A_v / g),
/// c_s = 2 mu_e g, a vector spectrum at 10 % damping. Its coefficients for rocking could not be consulted: what stands
/// here is the balance itself, and is not printed as the standard's.
#pragma once

#include "body/rigid_body.hpp"

namespace overturn {

/// Demand of a response spectrum at which the body rocks to a given rotation.
struct RockingCapacity {
    double rotation_rad = 0;
    double spectral_mps2 = 0;  ///< SA_CAP = 2 g f1 / theta
    double frequency_hz = 0;   ///< at which the spectrum is read: f_e
    double damping = 0;        ///< of the spectrum: beta_e [-]
};

/// The equivalent oscillator of the rocking body at a peak rotation theta. With a = b / h:
///   f1      = cos theta + a sin theta - 1              rise of the centre of gravity over h
///   C_I     = I_O / (m h^2)                            4/3 (1 + a^2) for a uniform block
///   f_e     = sqrt(2 f1 g / (C_I theta^2 h)) / (2 pi)  whose elastic energy at theta is m g h f1
///   beta_e  = gamma / sqrt(4 pi^2 + gamma^2), gamma = -2 ln e   loss of two impacts a cycle (e for Housner's
///             1 - 2 a^2 / C_I where a restitution is stated)
///   SA_CAP  = 2 g f1 / theta                           (2 pi f_e)^2 C_I h theta
/// Under horizontal motion: a vertical component has no part in it.
/// \pre 0 < rotation_rad <= alpha
[[nodiscard]] RockingCapacity rocking_capacity(RigidBody const& body, double rotation_rad);

/// For sliding: the spectral acceleration c_s = 2 mu_e g, at 10 % damping, at which the body slides by c_s / (2 pi
/// f_s)^2, f_s the lowest frequency at which the spectrum reaches it. A block that slides x spends mu m g x, an
/// oscillator of that capacity and distance stores half of c_s m x. Vertical motion lightens the base: mu_e = mu (1 -
/// 0.4 A_v / g), A_v its peak acceleration. [m/s2]; 0: it does not hold at all. \pre friction > 0
[[nodiscard]] double sliding_capacity_mps2(double friction, double vertical_mps2 = 0, double gravity_mps2 = g0);
inline constexpr double sliding_damping = 0.1;

/// The distance that belongs to it. \param frequency_hz f_s [m]
[[nodiscard]] double sliding_distance_m(double capacity_mps2, double frequency_hz);

}  // namespace overturn
