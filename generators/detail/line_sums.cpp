#include "generators/detail/line_sums.hpp"

#include "simd/targets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "generators/detail/line_sums.cpp"
#include <hwy/foreach_target.h>
// foreach_target comes first: it includes this file once per instruction set
#include "simd/lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace overturn::HWY_NAMESPACE {

using SomeLanes = simd::HWY_NAMESPACE::SweepFloats<2>;

template <class V>
void sum_some(std::span<std::complex<double> const> lines, std::span<std::size_t const> band_end,
              std::size_t first_line, LineOscillators const& oscillators, float* to, std::size_t lane) {
    auto const from = [lane](simd::LaneValues<float> const& values) HWY_ATTR { return V::load(values.data() + lane); };
    V const w = from(oscillators.frequency);
    V const damped = from(oscillators.twice_damped);
    V const turn_cos = from(oscillators.turn_cos);
    V const turn_sin = from(oscillators.turn_sin);
    V phase_cos = from(oscillators.start_cos);
    V phase_sin = from(oscillators.start_sin);
    V const w2 = w * w;
    std::size_t k = first_line;
    for (std::size_t band = 0; band < band_end.size(); ++band) {
        V sum = 0;
        for (; k < band_end[band]; ++k) {
            auto const x = static_cast<float>(k);
            auto const re = static_cast<float>(-lines[k].real());
            auto const im = static_cast<float>(-lines[k].imag());
            V const d = w2 - x * x;
            V const q = damped * x;
            V const a = fma(phase_sin, -im, phase_cos * re);
            V const b = fma(phase_sin, re, phase_cos * im);
            sum = sum + fma(a, d, b * q) / fma(d, d, q * q);
            V const turned = fma(phase_cos, turn_cos, -phase_sin * turn_sin);
            phase_sin = fma(phase_cos, turn_sin, phase_sin * turn_cos);
            phase_cos = turned;
        }
        sum.store(to + band * simd::sweep_lanes + lane);
    }
}

void sum_all(std::span<std::complex<double> const> lines, std::span<std::size_t const> band_end, std::size_t first_line,
             LineOscillators const& oscillators, float* to) {
    for (std::size_t lane = 0; lane < simd::sweep_lanes; lane += SomeLanes::count) {
        sum_some<SomeLanes>(lines, band_end, first_line, oscillators, to, lane);
    }
}

}  // namespace overturn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace overturn {

HWY_EXPORT(sum_all);

void sum_lines(std::span<std::complex<double> const> lines, std::span<std::size_t const> band_end,
               std::size_t first_line, LineOscillators const& oscillators, std::span<float> sums) {
    HWY_DYNAMIC_DISPATCH(sum_all)(lines, band_end, first_line, oscillators, sums.data());
}

}  // namespace overturn
#endif
