#include "contact/detail/contact_step.hpp"

#include "simd/targets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "contact/detail/contact_step.cpp"
#include <hwy/foreach_target.h>
// foreach_target comes first: it includes this file once per instruction set
#include "contact/detail/contact_step-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace overturn::contact::HWY_NAMESPACE {

using Wide = simd::HWY_NAMESPACE::Doubles<2>;
using Half = simd::HWY_NAMESPACE::Doubles<1>;
using Single = simd::HWY_NAMESPACE::OneDouble;

template <class V, int Stride, int Points> std::uint32_t step_until_care(ContactLanes<Stride>& lanes, bool once) {
    ContactStepper<V, Stride, Points> stepper(lanes);
    for (;;) {
        if (auto const care = stepper.step(); once || any(care)) {
            return bits(care);
        }
    }
}

// Two corners have a loop of their own, which the compiler unrolls.
template <class V, int Stride> std::uint32_t step_until_care(ContactLanes<Stride>& lanes, bool once) {
    return lanes.points == 2 ? step_until_care<V, Stride, 2>(lanes, once) : step_until_care<V, Stride, 0>(lanes, once);
}

std::uint32_t many_lanes(ContactLanes<simd::most_lanes>& lanes, int used) {
    return used <= Half::count ? step_until_care<Half, simd::most_lanes>(lanes, false)
                               : step_until_care<Wide, simd::most_lanes>(lanes, false);
}
std::uint32_t one_lane(ContactLanes<1>& lane, bool once) { return step_until_care<Single, 1>(lane, once); }
int lane_count() { return Wide::count; }

}  // namespace overturn::contact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace overturn::contact {

HWY_EXPORT(many_lanes);
HWY_EXPORT(one_lane);
HWY_EXPORT(lane_count);

std::uint32_t step_lanes(ContactLanes<simd::most_lanes>& lanes, int used) {
    return HWY_DYNAMIC_DISPATCH(many_lanes)(lanes, used);
}
void step_lanes(ContactLanes<1>& lane) { HWY_DYNAMIC_DISPATCH(one_lane)(lane, false); }
bool step_lane_once(ContactLanes<1>& lane) { return HWY_DYNAMIC_DISPATCH(one_lane)(lane, true) != 0; }
int lane_width() { return HWY_DYNAMIC_DISPATCH(lane_count)(); }

}  // namespace overturn::contact
#endif
