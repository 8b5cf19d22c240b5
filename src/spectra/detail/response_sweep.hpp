/// Sixteen damped oscillators at a time over a wave: how far, how fast and with what acceleration each swings.
#pragma once

#include <span>

#include "simd/lane_values.hpp"

namespace overturn {

/// Coefficients and results of oscillators that share a number of steps per sample. What the acceleration at the end of
/// a step adds is kept apart from the state, so that each step takes one forcing term; and the state is counted in what
/// that term makes of a unit, so that it takes no product:
/// y = unit_z (z + ya a), v = unit_u (u + va a), z1 = zz z0 + zu u0 + a0, u1 = uz z0 + uu u0 + a0.
struct ResponseLanes {
    simd::LaneValues<> zz, zu, za, ya, uz, uu, ua, va;
    simd::LaneValues<> cv, cy;          ///< absolute acceleration = cv v + cy y
    simd::LaneValues<> unit_z, unit_u;  ///< see above [m, m/s]
    simd::LaneValues<> end_z, end_u;    ///< at the last sample
    simd::LaneValues<> y2, v2, a2;      ///< largest squares, of y over unit_z, v over unit_u, absolute acceleration
};

enum class SweptPeaks { displacement, all };
enum class ForcingTerm {
    unit,   ///< counts as one, as above
    factor  ///< some lane's is too small to count in: units are 1, za and ua its factors
};

/// What oscillators of a sweep share.
struct ResponseForm {
    int steps;  ///< to a sample, along the straight line between two
    SweptPeaks peaks;
    ForcingTerm forcing;

    friend bool operator==(ResponseForm const&, ResponseForm const&) = default;
};

/// From rest. Fills lanes.y2, end_z and end_u; with SweptPeaks::all also v2 and a2.
void sweep_response(std::span<double const> acceleration_mps2, ResponseForm const& form, ResponseLanes& lanes);

/// The same of two groups, which takes less time than one after the other.
void sweep_response(std::span<double const> acceleration_mps2, ResponseForm const& form, ResponseLanes& lanes,
                    ResponseLanes& others);

}  // namespace overturn
