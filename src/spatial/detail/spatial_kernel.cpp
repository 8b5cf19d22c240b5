#include "simd/targets.hpp"
#include "spatial/detail/spatial_state.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "spatial/detail/spatial_kernel.cpp"
#include <hwy/foreach_target.h>
// foreach_target comes first: it includes this file once per instruction set
#include "spatial/detail/spatial_log-inl.hpp"
#include "spatial/detail/spatial_step-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace overturn::spatial::HWY_NAMESPACE {

using Wide = simd::HWY_NAMESPACE::Doubles<2>;
using Half = simd::HWY_NAMESPACE::Doubles<1>;
using Single = simd::HWY_NAMESPACE::OneDouble;

template <class Force, class Lanes> std::uint32_t step_until_care(Lanes& lanes, bool once) {
    SpatialStepper<Force> stepper(lanes);
    for (;;) {
        if (auto const care = stepper.step(); once || any(care)) {
            stepper.complete();
            return bits(care);
        }
    }
}

template <class V, int Stride> std::uint32_t step_lanes(SpatialLanes<Stride>& lanes, bool once) {
    return lanes.points > 0 ? step_until_care<PointForce<V, Stride>>(lanes, once)
           : lanes.disc     ? step_until_care<PatchForce<FacePressure<V, Stride>>>(lanes, once)
                            : step_until_care<PatchForce<RimPressure<V, Stride>>>(lanes, once);
}

std::uint32_t many_lanes(SpatialLanes<simd::most_lanes>& lanes, int used) {
    return used <= Half::count ? step_lanes<Half>(lanes, false) : step_lanes<Wide>(lanes, false);
}
std::uint32_t one_lane(SpatialLanes<1>& lane, bool once) { return step_lanes<Single>(lane, once); }
int lane_count() { return Wide::count; }

}  // namespace overturn::spatial::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace overturn::spatial {

HWY_EXPORT(many_lanes);
HWY_EXPORT(one_lane);
HWY_EXPORT(lane_count);

std::uint32_t step_on(SpatialLanes<simd::most_lanes>& lanes, int used) {
    return HWY_DYNAMIC_DISPATCH(many_lanes)(lanes, used);
}
void step_on(SpatialLanes<1>& lane) { HWY_DYNAMIC_DISPATCH(one_lane)(lane, false); }
bool step_once(SpatialLanes<1>& lane) { return HWY_DYNAMIC_DISPATCH(one_lane)(lane, true) != 0; }
int step_width() { return HWY_DYNAMIC_DISPATCH(lane_count)(); }

}  // namespace overturn::spatial
#endif
