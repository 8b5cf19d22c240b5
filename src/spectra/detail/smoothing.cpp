#include "spectra/detail/smoothing.hpp"

#include "simd/lane_values.hpp"
#include "simd/targets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "spectra/detail/smoothing.cpp"
#include <hwy/foreach_target.h>
// foreach_target comes first: it includes this file once per instruction set
#include "simd/lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace overturn::HWY_NAMESPACE {

using SomeLanes = simd::HWY_NAMESPACE::SweepDoubles<4>;

// In an order that does not depend on the registers.
double sum_of(simd::LaneValues<>& lanes) {
    for (std::size_t half = simd::sweep_lanes / 2; half > 0; half /= 2) {
        for (std::size_t i = 0; i < half; ++i) {
            lanes[i] += lanes[i + half];
        }
    }
    return lanes[0];
}

// Two weighted sums of the signal at a time: what is loaded of the kernel serves both.
void smooth_all(std::span<double const> kernel, std::span<double const> signal, std::size_t stride,
                std::span<double> smoothed) {
    simd::LaneValues<> of_one;
    simd::LaneValues<> of_two;
    for (std::size_t m = 0; m < smoothed.size(); m += 2) {
        auto const* const here = signal.data() + m * stride;
        auto const* const next = here + stride;
        for (std::size_t lane = 0; lane < simd::sweep_lanes; lane += SomeLanes::count) {
            SomeLanes one = 0;
            SomeLanes two = 0;
            for (std::size_t t = lane; t < kernel.size(); t += simd::sweep_lanes) {
                auto const weight = SomeLanes::load(kernel.data() + t);
                one = fma(weight, SomeLanes::load(here + t), one);
                two = fma(weight, SomeLanes::load(next + t), two);
            }
            one.store(of_one.data() + lane);
            two.store(of_two.data() + lane);
        }
        smoothed[m] = sum_of(of_one);
        smoothed[m + 1] = sum_of(of_two);
    }
}

}  // namespace overturn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace overturn {

HWY_EXPORT(smooth_all);

void smooth(std::span<double const> kernel, std::span<double const> signal, std::size_t stride,
            std::span<double> smoothed) {
    HWY_DYNAMIC_DISPATCH(smooth_all)(kernel, signal, stride, smoothed);
}

}  // namespace overturn
#endif
