/// Planar rocking of a rigid block about its base corners, one trial or many. Equations, modes and their places in the
/// sources: README.md of this folder.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>

#include "core/units.hpp"
#include "model/excitation.hpp"
#include "model/friction.hpp"
#include "model/outcome.hpp"
#include "rocking/rocking_accuracy.hpp"

namespace overturn {

/// One of two corners that differ.
struct RockingCorner {
    double alpha_rad = 0;         ///< the tilt at which it falls by itself: that of its base -/+ slope
    double base_angle_rad = 0;    ///< atan(b/h), from the base's normal
    double p_radps = 0;           ///< about this corner
    double restitution = 1;       ///< of the impact that leaves it for the other one
    double inertia_ratio = 0.75;  ///< m R^2 / I_O
};

/// A block whose corners differ, as its centre of gravity is off the base's middle or its ground is inclined.
struct Lopsided {
    double slope_rad = 0;                    ///< the ground falls towards +x
    std::array<RockingCorner, 2> corners{};  ///< at +x and at -x
};

/// Constants of the rocking equation. Plain data, validated where the body is.
struct RockingBlock {
    double alpha_rad = 0;         ///< critical angle atan(b/h)
    double p_radps = 0;           ///< frequency parameter sqrt(m g R / I_O)
    double restitution = 1;       ///< angular velocity after / before a base impact
    double inertia_ratio = 0.75;  ///< m R^2 / I_O; 3/4 for a uniform rectangle
    double gravity_mps2 = g0;
    double friction_static = std::numeric_limits<double>::infinity();   ///< mu_s; read unless slip is ignored
    double friction_kinetic = std::numeric_limits<double>::infinity();  ///< mu_k <= mu_s
    /// Corners, where they differ. Then alpha, p, restitution and inertia ratio of the block are those of the weaker
    /// one, over which less energy tips it, and energies are stated over that energy.
    std::optional<Lopsided> lopsided = {};

    [[nodiscard]] double radius_m() const { return inertia_ratio * gravity_mps2 / (p_radps * p_radps); }
};

/// Treatment of slip, where friction is not enough.
enum class Slip {
    ignored,    ///< the corner never slips; friction demand is monitored
    detected,   ///< the same motion, ended at the instant the block would slip: RockingOutcome::slip_onset
    simulated,  ///< at rest, sliding, rocking, slide-rocking
};

/// State at the start; at rest unless stated.
struct RockingStart {
    double rotation_rad = 0;
    double velocity_radps = 0;
};

/// Energies per mass [J/kg] up to the end of the simulation, with Slip::simulated:
/// input = mechanical + impact_loss + friction_work.
struct EnergyBalance {
    double input = 0;          ///< work of the shaking on the body, in the ground's frame
    double mechanical = 0;     ///< kinetic + potential at the end
    double impact_loss = 0;    ///< lost in impacts and in the bouncing that settles
    double friction_work = 0;  ///< lost in slip, impacts apart
};

/// Outcome of a trial of planar rocking. Forces are looked at where steps start and just before impacts. Some neutral
/// fields are left to rocking_models.cpp: peak_rotation_ratio, the landing but for its spin, peak_impact_velocity_mps,
/// response_velocity_mps, friction_work_jpkg and called.
struct RockingOutcome : Outcome {
    /// Peak rotation as the same share of the weaker corner's alpha, where corners differ; the peak is then the one
    /// nearest to its own corner's alpha. Else the peak rotation.
    double peak_reach_rad = 0;
    double peak_side = 0;                      ///< the sign of the peak rotation; 0: it never moved
    double impact_spin_radps = 0;              ///< largest |omega| before an impact
    double most_slip_m = 0, least_slip_m = 0;  ///< farthest that the base slipped to either side
    double landing_slip_mps = 0;               ///< of the corner at the end, towards the fall
    /// Of the centre of gravity where it lies, towards the fall and down, where it left the ground as it fell; NaN: it
    /// did not. Whatever it would still fall then is added: it lies no slower.
    double flight_along_mps = never, flight_down_mps = never;
    bool slip_onset = false;  ///< Slip::detected ended here: nothing else of this outcome counts
    EnergyBalance energy;     ///< with Slip::simulated only
};

/// One instant of a history.
struct RockingInstant {
    double time_s, rotation_rad, velocity_radps, friction_ratio, contact_force_ratio, slip_m, slip_velocity_mps;
};

/// Receives every step's start, and both sides of every impact.
class RockingObserver {
  public:
    virtual void at(RockingInstant const& instant) = 0;

    RockingObserver() = default;
    RockingObserver(RockingObserver const&) = delete;
    RockingObserver& operator=(RockingObserver const&) = delete;
    RockingObserver(RockingObserver&&) = delete;
    RockingObserver& operator=(RockingObserver&&) = delete;
    virtual ~RockingObserver() = default;
};

/// Integrates I_O theta'' = -m R (s gv sin psi + a cos psi), psi = alpha - s theta, with uplift from rest when
/// |a| > gv tan(alpha), impacts omega -> e omega over the other corner, and overturning at |theta| = pi/2 (Housner
/// 1963). With Slip::simulated also sliding, slide-rocking and slip at impacts under Coulomb friction.
///
/// A Taylor series per sample, on which every event is located to rounding; uplift is located exactly. After the wave,
/// energy decides. Mirrored motion gives the bit-equal mirrored trial; a trial in which nothing slips is bit-equal in
/// all three slip modes. Allocates nothing.
///
/// A block whose corners differ rocks on each as a symmetric block of that corner's alpha, R, p does; on inclined
/// ground theta counts from the ground, alpha from the vertical, forces along and across the ground. Slip is followed
/// along it.
///  Loss of contact (N <= 0) below the critical angle or while turning back ends the trial as contact_lost. Beyond it,
/// on the way out, the fall is certain and free of torque: the trial is overturned, at the instant to which the
/// rotation at the loss leads, and contact_lost_s records the loss.
///
/// \pre block quantities are positive, alpha < pi/2, restitution in [0, 1]; components agree in length; friction stays
///      below painleve_bound
/// \throws InputError if the accuracy states an order that is not offered, or for slip or differing corners of the
/// linearised block
[[nodiscard]] RockingOutcome simulate_rocking(RockingBlock const& block, Excitation const& shaking,
                                              RockingAccuracy const& accuracy = {}, RockingStart const& start = {},
                                              RockingObserver* observer = nullptr, Slip slip = Slip::ignored);

struct RockingTrial {
    RockingBlock block;
    Excitation shaking;
    RockingStart start = {};
};

/// Many trials, side by side in the machine's vector lanes: outcomes[i] is bit-equal to that of trials[i]
/// alone. Trials come in any mixture.
void simulate_rocking(std::span<RockingTrial const> trials, RockingAccuracy const& accuracy, Slip slip,
                      std::span<RockingOutcome> outcomes);

}  // namespace overturn
