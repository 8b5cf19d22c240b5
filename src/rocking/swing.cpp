#include "rocking/swing.hpp"

// Machines without fused multiply-add get the plain lane, whose std::fma gives the same bits.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SSE4)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rocking/swing.cpp"
#include <hwy/foreach_target.h>
// foreach_target comes first: it includes this file once per instruction set
#include "rocking/swing_step-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace overturn::rocking::HWY_NAMESPACE {

using Wide = Lanes<hn::ScalableTag<double>, 2>;
using Half = Lanes<hn::ScalableTag<double>, 1>;
using Single = Lanes<hn::CappedTag<double, 1>, 1>;

// NOLINTBEGIN(readability-non-const-parameter): the steppers write through it
template <class V, bool Vertical> std::uint32_t swing_many(double* values) {
    Stepper<V, most_lanes, Vertical> stepper(values);
    for (;;) {
        if (auto const care = stepper.step(nullptr); any(care)) {
            return bits(care);
        }
    }
}

template <bool Vertical> void swing_alone(double* values) {
    Stepper<Single, 1, Vertical> stepper(values);
    while (!any(stepper.step(nullptr))) {}
}

template <bool Vertical> bool swing_shown(double* values, SwingSeries* series) {
    return !any(Stepper<Single, 1, Vertical>(values).step(series));
}

std::uint32_t many_lanes(double* values, int used, bool vertical) {
    if (used <= Half::count) {
        return vertical ? swing_many<Half, true>(values) : swing_many<Half, false>(values);
    }
    return vertical ? swing_many<Wide, true>(values) : swing_many<Wide, false>(values);
}
void one_lane(double* values, bool vertical) { vertical ? swing_alone<true>(values) : swing_alone<false>(values); }
bool shown_lane(double* values, bool vertical, SwingSeries* series) {
    return vertical ? swing_shown<true>(values, series) : swing_shown<false>(values, series);
}
// NOLINTEND(readability-non-const-parameter)
int lane_count() { return Wide::count; }

}  // namespace overturn::rocking::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace overturn::rocking {

HWY_EXPORT(many_lanes);
HWY_EXPORT(shown_lane);
HWY_EXPORT(one_lane);
HWY_EXPORT(lane_count);

std::uint32_t swing_on(SwingLanes<most_lanes>& lanes, int used, bool vertical) {
    return HWY_DYNAMIC_DISPATCH(many_lanes)(lanes.values.data(), used, vertical);
}

void swing_on(SwingLanes<1>& lane, bool vertical) { HWY_DYNAMIC_DISPATCH(one_lane)(lane.values.data(), vertical); }

bool swing_once(SwingLanes<1>& lane, bool vertical, SwingSeries& series) {
    return HWY_DYNAMIC_DISPATCH(shown_lane)(lane.values.data(), vertical, &series);
}

int swing_width() { return HWY_DYNAMIC_DISPATCH(lane_count)(); }

}  // namespace overturn::rocking
#endif
