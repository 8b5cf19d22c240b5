#include "contact/detail/pressing.hpp"

#include "simd/targets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "contact/detail/pressing.cpp"
#include <hwy/foreach_target.h>
// foreach_target comes first: it includes this file once per instruction set
#include "contact/detail/press_step-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace overturn::contact::HWY_NAMESPACE {

using Wide = simd::HWY_NAMESPACE::Doubles<2>;
using Half = simd::HWY_NAMESPACE::Doubles<1>;
using Single = simd::HWY_NAMESPACE::OneDouble;

template <class V, int Stride, int Points> std::uint32_t press(PressLanes<Stride>& lanes, bool once) {
    PressStepper<V, Stride, Points> stepper(lanes);
    for (;;) {
        if (auto const care = stepper.step(); once || any(care)) {
            return bits(care);
        }
    }
}

// Two corners have a loop of their own, which the compiler unrolls.
template <class V, int Stride> std::uint32_t press(PressLanes<Stride>& lanes, bool once) {
    return lanes.points == 2 ? press<V, Stride, 2>(lanes, once) : press<V, Stride, 0>(lanes, once);
}

std::uint32_t many_lanes(PressLanes<simd::most_lanes>& lanes, int used) {
    return used <= Half::count ? press<Half, simd::most_lanes>(lanes, false)
                               : press<Wide, simd::most_lanes>(lanes, false);
}
std::uint32_t one_lane(PressLanes<1>& lane, bool once) { return press<Single, 1>(lane, once); }
int lane_count() { return Wide::count; }

}  // namespace overturn::contact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace overturn::contact {

HWY_EXPORT(many_lanes);
HWY_EXPORT(one_lane);
HWY_EXPORT(lane_count);

std::uint32_t press_on(PressLanes<simd::most_lanes>& lanes, int used) {
    return HWY_DYNAMIC_DISPATCH(many_lanes)(lanes, used);
}
void press_on(PressLanes<1>& lane) { HWY_DYNAMIC_DISPATCH(one_lane)(lane, false); }
bool press_once(PressLanes<1>& lane) { return HWY_DYNAMIC_DISPATCH(one_lane)(lane, true) != 0; }
int press_width() { return HWY_DYNAMIC_DISPATCH(lane_count)(); }

}  // namespace overturn::contact
#endif
