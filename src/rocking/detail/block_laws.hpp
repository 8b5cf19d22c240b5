/// The laws of the planar block for doubles and power series in time.
#pragma once

#include "core/units.hpp"

namespace overturn::rocking {

/// a b + c, rounded twice.
[[nodiscard]] inline double mul_add(double a, double b, double c) { return a * b + c; }

// The laws' text is included twice, into two namespaces: here for doubles and series, as inline functions; in
// lane_series-inl.hpp for vector lanes, as functions that the compiler must inline and compile for one instruction set.
// OVERTURN_LAW stands before each of them.
#define OVERTURN_LAW [[nodiscard]] inline
#include "rocking/detail/block_laws-inl.hpp"
#undef OVERTURN_LAW

/// A block that has turned so far lies on its side: it has overturned, whatever the shaking does next [rad].
inline constexpr double overturned_rad = 0.5 * pi;

}  // namespace overturn::rocking
