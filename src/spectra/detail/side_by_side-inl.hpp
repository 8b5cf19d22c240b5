// Two groups of sixteen oscillators in four registers, where two hold a group. There each step of a group waits longer
// for the one before than it takes, so two go side by side. Included once per instruction set, so without a
// #pragma once; after simd/targets.hpp and foreach_target.h.
#if defined(OVERTURN_SIDE_BY_SIDE) == defined(HWY_TARGET_TOGGLE)
#ifdef OVERTURN_SIDE_BY_SIDE
#undef OVERTURN_SIDE_BY_SIDE
#else
#define OVERTURN_SIDE_BY_SIDE
#endif

#include "simd/lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace overturn::HWY_NAMESPACE {

using GroupLanes = simd::HWY_NAMESPACE::Doubles<2>;
using TwoGroupsLanes = simd::HWY_NAMESPACE::Doubles<4>;

inline constexpr bool pairs_win = GroupLanes::count == simd::sweep_lanes;

OVERTURN_LANES_INLINE TwoGroupsLanes load_two(simd::LaneValues<> const& from, simd::LaneValues<> const& others_from) {
    auto const one = GroupLanes::load(from.data());
    auto const other = GroupLanes::load(others_from.data());
    TwoGroupsLanes both;
    both.part.a = one.part.a;
    both.part.b = one.part.b;
    both.part.c = other.part.a;
    both.part.d = other.part.b;
    return both;
}

OVERTURN_LANES_INLINE void store_two(TwoGroupsLanes const& both, double* to, double* others_to) {
    GroupLanes one;
    GroupLanes other;
    one.part.a = both.part.a;
    one.part.b = both.part.b;
    other.part.a = both.part.c;
    other.part.b = both.part.d;
    one.store(to);
    other.store(others_to);
}

}  // namespace overturn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
