#include "rocking/detail/swing.hpp"

#include "simd/targets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rocking/detail/swing.cpp"
#include <hwy/foreach_target.h>
// foreach_target comes first: it includes this file once per instruction set
#include "rocking/detail/swing_step-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace overturn::rocking::HWY_NAMESPACE {

using Wide = simd::HWY_NAMESPACE::Doubles<2>;
using Half = simd::HWY_NAMESPACE::Doubles<1>;
using Single = simd::HWY_NAMESPACE::OneDouble;

template <class V, bool Vertical> std::uint32_t swing_many(SwingLanes<most_lanes>& lanes) {
    Stepper<V, most_lanes, Vertical> stepper(lanes.values.data(), lanes.samples.data());
    for (;;) {
        if (auto const care = stepper.step(nullptr); any(care)) {
            return bits(care);
        }
    }
}

template <bool Vertical> void swing_alone(SwingLanes<1>& lane) {
    Stepper<Single, 1, Vertical> stepper(lane.values.data(), lane.samples.data());
    while (!any(stepper.step(nullptr))) {}
}

template <bool Vertical> bool swing_shown(SwingLanes<1>& lane, SwingSeries& series) {
    return !any(Stepper<Single, 1, Vertical>(lane.values.data(), lane.samples.data()).step(&series));
}

std::uint32_t many_lanes(SwingLanes<most_lanes>& lanes, int used, bool vertical) {
    if (used <= Half::count) {
        return vertical ? swing_many<Half, true>(lanes) : swing_many<Half, false>(lanes);
    }
    return vertical ? swing_many<Wide, true>(lanes) : swing_many<Wide, false>(lanes);
}
void one_lane(SwingLanes<1>& lane, bool vertical) { vertical ? swing_alone<true>(lane) : swing_alone<false>(lane); }
bool shown_lane(SwingLanes<1>& lane, bool vertical, SwingSeries& series) {
    return vertical ? swing_shown<true>(lane, series) : swing_shown<false>(lane, series);
}
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
    return HWY_DYNAMIC_DISPATCH(many_lanes)(lanes, used, vertical);
}

void swing_on(SwingLanes<1>& lane, bool vertical) { HWY_DYNAMIC_DISPATCH(one_lane)(lane, vertical); }

bool swing_once(SwingLanes<1>& lane, bool vertical, SwingSeries& series) {
    return HWY_DYNAMIC_DISPATCH(shown_lane)(lane, vertical, series);
}

int swing_width() { return HWY_DYNAMIC_DISPATCH(lane_count)(); }

}  // namespace overturn::rocking
#endif
