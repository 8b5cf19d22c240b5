#include "spectra/detail/direct_sums.hpp"

#include <algorithm>
#include <cmath>

#include "simd/targets.hpp"
#include "spectra/detail/phase_table.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "spectra/detail/direct_sums.cpp"
#include <hwy/foreach_target.h>
// foreach_target comes first: it includes this file once per instruction set
#include "simd/lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace overturn::HWY_NAMESPACE {

using AllLanes = simd::HWY_NAMESPACE::SweepDoubles<4>;

// sum_n a_n exp(-ixn): block sums from the last to the first, joined by Horner's rule.
template <class V> void sum_some(std::span<double const> signal, PhaseTable& table, std::size_t lane) {
    constexpr auto block = PhaseTable::block;
    V const turn_c = V::load(table.turn_cosine.data() + lane);
    V const turn_s = V::load(table.turn_sine.data() + lane);
    V re = 0;
    V im = 0;
    for (std::size_t b = (signal.size() + block - 1) / block; b-- > 0;) {
        auto const part = signal.subspan(b * block, std::min(block, signal.size() - b * block));
        V c = 0;
        V s = 0;
        for (std::size_t j = 0; j < part.size(); ++j) {
            V const a = part[j];
            c = fma(V::load(table.cosine.data() + j * simd::sweep_lanes + lane), a, c);
            s = fma(V::load(table.sine.data() + j * simd::sweep_lanes + lane), a, s);
        }
        V const turned = turn_c * re + turn_s * im;
        im = turn_c * im - turn_s * re - s;
        re = turned + c;
    }
    re.store(table.real.data() + lane);
    im.store(table.imaginary.data() + lane);
}

void sum_all(std::span<double const> signal, PhaseTable& table) {
    for (std::size_t lane = 0; lane < simd::sweep_lanes; lane += AllLanes::count) {
        sum_some<AllLanes>(signal, table, lane);
    }
}

}  // namespace overturn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace overturn {

HWY_EXPORT(sum_all);

std::vector<std::complex<double>> direct_sums(std::span<double const> signal, std::span<double const> x) {
    std::vector<std::complex<double>> sums(x.size());
    PhaseTable table;
    for (std::size_t begin = 0; begin < x.size(); begin += simd::sweep_lanes) {
        for (std::size_t lane = 0; lane < simd::sweep_lanes; ++lane) {
            double const phase = x[std::min(begin + lane, x.size() - 1)];
            for (std::size_t j = 0; j < PhaseTable::block; ++j) {
                table.cosine.at(j * simd::sweep_lanes + lane) = std::cos(phase * static_cast<double>(j));
                table.sine.at(j * simd::sweep_lanes + lane) = std::sin(phase * static_cast<double>(j));
            }
            table.turn_cosine.at(lane) = std::cos(phase * static_cast<double>(PhaseTable::block));
            table.turn_sine.at(lane) = std::sin(phase * static_cast<double>(PhaseTable::block));
        }
        HWY_DYNAMIC_DISPATCH(sum_all)(signal, table);
        for (std::size_t lane = 0; lane < simd::sweep_lanes && begin + lane < x.size(); ++lane) {
            sums[begin + lane] = {table.real.at(lane), table.imaginary.at(lane)};
        }
    }
    return sums;
}

}  // namespace overturn
#endif
