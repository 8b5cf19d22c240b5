/// Rocking on one corner without slip, stepped in SIMD lanes of any mixture of trials up to the first instant that
/// needs care. One arithmetic serves one lane and many: whatever the machine's vectors, the bits are the same.
#pragma once

#include <array>
#include <cstdint>

#include "rocking/rocking_accuracy.hpp"
#include "simd/lane_fields.hpp"

namespace overturn::rocking {

/// Fields of a lane. Time in s, angles in rad, mirrored to the corner that the block stands on as in State (phi = side
/// * theta >= 0); forces over m g, energies over m g R.
enum class RockingField : int {
    // state
    phi,
    omega,
    sine,    ///< sin(alpha - phi), carried by rotation
    cosine,  ///< cos(alpha - phi)
    side,
    index,  ///< of the sample
    tau,    ///< time since that sample
    start,  ///< 1: phi = 0 here, and this zero is no event
    // log
    peak,
    peak_time,
    peak_side,
    energy,
    demand,
    normal,
    steps,
    impacts,
    impact_spin,  ///< fastest before an impact
    // trial
    p,
    inverse_p,
    r,  ///< R / g [s2]
    inertia_ratio,
    restitution,
    sine_alpha,
    cosine_alpha,
    uplift_ratio,
    friction_limit,  ///< mu_s; large where friction is unlimited
    impact_demand,   ///< friction that a sticking impact needs; above the limit every impact needs care
    incline_sine,    ///< of the ground's slope, towards the corner; level: 0
    incline_cosine,
    settle_speed,  ///< slower rebounds may settle
    settle_rate,   ///< longest_bouncing: rebound times this, over hold: how long the bouncing lasts at most
    tolerance,     ///< of the last term of the series
    scale,         ///< of the samples, over g
    time_step,
    sampling_rate,  ///< its inverse
    last,           ///< index of the last sample
    count
};

/// Bouncing slower than this fraction of RockingAccuracy::settle is rest, whatever the forcing does next. Empirical:
/// low enough for a rebound of 1e-8 p at most to be lost, by the default `settle`; how results move with it was not
/// measured.
inline constexpr double rest_speed_share = 1e-3;

/// Largest turn of a step in lanes [rad]. Up to it the sums for the sine and cosine of a turn are exact to rounding:
/// the first terms that they leave out are turn^8 / 9! of the sine, 2e-18, and turn^10 / 10! of the cosine, 2e-22.
inline constexpr double most_arc = 0.03;

/// Largest inertia ratio m R^2 / I_O of a block that is stepped in lanes: up to it the bound of the contact forces'
/// change holds (derived above contact_holds in lane_bounds-inl.hpp). A block beyond it has next to no inertia about
/// its own centre, and takes its steps in stick.cpp; a uniform rectangle has 0.75.
inline constexpr double most_lane_inertia_ratio = 0.98;

/// The waves that a lane reads, in m/s2; the vertical one only if it is stepped with vertical motion.
enum class RockingWave : int { horizontal, vertical, count };

using simd::most_lanes;
template <int Lanes> using RockingFields = simd::LaneFields<RockingField, RockingWave, Lanes>;

/// The last step taken, as power series in the share of its length.
struct LaneStep {
    static constexpr int order = campaign_order;
    double length_s = 0;                             ///< as planned
    double share = 1;                                ///< of it, where an impact cut it short
    std::array<double, order> rates{};               ///< phi' length
    std::array<double, order> sine{}, cosine{};      ///< of psi, last terms zero
    std::array<double, 2> horizontal{}, vertical{};  ///< forcing over g, mirrored
};

/// Steps every lane on until one of them needs care: its next step may hold an event other than a clear impact, or
/// turns that may hide a record of rotation or energy, or its wave is over. That lane is then as before this step.
/// \param used the first so many lanes are stepped, at least; half of lane_width() costs half. All that are stepped
///     hold a trial or a copy of one: ask for all or for half
/// \return one bit per such lane
[[nodiscard]] std::uint32_t step_lanes(RockingFields<most_lanes>& lanes, int used, bool vertical);

/// The same for a lane alone.
void step_lanes(RockingFields<1>& lane, bool vertical);

/// One step of a lane alone, if it needs no care. \return false where step_lanes would have stopped
[[nodiscard]] bool step_lane_once(RockingFields<1>& lane, bool vertical, LaneStep& series);

/// Number of lanes, of most_lanes, that this machine steps; the others stay as they are.
[[nodiscard]] int lane_width();

}  // namespace overturn::rocking
