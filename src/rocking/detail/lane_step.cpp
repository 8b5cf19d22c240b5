#include "rocking/detail/lane_step.hpp"

#include "simd/targets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rocking/detail/lane_step.cpp"
#include <hwy/foreach_target.h>
// foreach_target comes first: it includes this file once per instruction set
#include "rocking/detail/lane_step-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace overturn::rocking::HWY_NAMESPACE {

using Wide = simd::HWY_NAMESPACE::Doubles<2>;
using Half = simd::HWY_NAMESPACE::Doubles<1>;
using Single = simd::HWY_NAMESPACE::OneDouble;

template <class V, bool Vertical> std::uint32_t step_many(RockingFields<most_lanes>& lanes) {
    Stepper<V, most_lanes, Vertical> stepper(lanes.values.data(), lanes.samples.data());
    for (;;) {
        if (auto const care = stepper.step(nullptr); any(care)) {
            return bits(care);
        }
    }
}

template <bool Vertical> void step_alone(RockingFields<1>& lane) {
    Stepper<Single, 1, Vertical> stepper(lane.values.data(), lane.samples.data());
    while (!any(stepper.step(nullptr))) {}
}

template <bool Vertical> bool step_once(RockingFields<1>& lane, LaneStep& series) {
    return !any(Stepper<Single, 1, Vertical>(lane.values.data(), lane.samples.data()).step(&series));
}

std::uint32_t many_lanes(RockingFields<most_lanes>& lanes, int used, bool vertical) {
    if (used <= Half::count) {
        return vertical ? step_many<Half, true>(lanes) : step_many<Half, false>(lanes);
    }
    return vertical ? step_many<Wide, true>(lanes) : step_many<Wide, false>(lanes);
}
void one_lane(RockingFields<1>& lane, bool vertical) { vertical ? step_alone<true>(lane) : step_alone<false>(lane); }
bool shown_lane(RockingFields<1>& lane, bool vertical, LaneStep& series) {
    return vertical ? step_once<true>(lane, series) : step_once<false>(lane, series);
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

std::uint32_t step_lanes(RockingFields<most_lanes>& lanes, int used, bool vertical) {
    return HWY_DYNAMIC_DISPATCH(many_lanes)(lanes, used, vertical);
}

void step_lanes(RockingFields<1>& lane, bool vertical) { HWY_DYNAMIC_DISPATCH(one_lane)(lane, vertical); }

bool step_lane_once(RockingFields<1>& lane, bool vertical, LaneStep& series) {
    return HWY_DYNAMIC_DISPATCH(shown_lane)(lane, vertical, series);
}

int lane_width() { return HWY_DYNAMIC_DISPATCH(lane_count)(); }

}  // namespace overturn::rocking
#endif
