#include "rare/detail/normals.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

#include "simd/targets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rare/detail/normals.cpp"
#include <hwy/foreach_target.h>
// foreach_target comes first: it includes this file once per instruction set
#include "rare/detail/lane_functions-inl.hpp"
#include "simd/threefry-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace overturn::rare::HWY_NAMESPACE {

// The upper 52 bits as a number in [1, 2).
HWY_INLINE Reals one_to_two(Words x) {
    return hn::BitCast(Real(), hn::Or(hn::ShiftRight<12>(x), hn::Set(Word(), bits_of_one)));
}

struct Pair {
    Reals one, other;
};

HWY_INLINE Pair normal_pair(Words radius, Words angle) {
    auto const r = hn::Sqrt(hn::Mul(real(-2), log_of(hn::Sub(real(2), one_to_two(radius)))));
    auto const turn = turn_of(hn::Sub(one_to_two(angle), real(1)));
    return {hn::Mul(r, turn.cosine), hn::Mul(r, turn.sine)};
}

// Four normals of every counter from `first` on.
void fill(StreamKey const& key, std::uint64_t first, double* normals, std::size_t counters) {
    constexpr auto lanes = hn::MaxLanes(Real());
    simd::HWY_NAMESPACE::Threefry<Word> const threefry(key);
    for (std::size_t i = 0; i < counters; i += lanes) {
        auto const x = threefry(first + i);
        auto const [a, b] = normal_pair(x.a, x.b);
        auto const [c, d] = normal_pair(x.c, x.d);
        hn::StoreInterleaved4(a, b, c, d, Real(), normals + 4 * i);
    }
}

}  // namespace overturn::rare::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace overturn::rare {

HWY_EXPORT(fill);

void draw_normals(DrawKey const& key, std::span<double> normals) {
    auto const words = key.key(Purpose::rare_normals);
    constexpr std::size_t together = 32;  // a multiple of what any machine makes at once
    auto const whole = normals.size() / together * together;
    HWY_DYNAMIC_DISPATCH(fill)(words, 0, normals.data(), whole / 4);
    if (auto const left = normals.subspan(whole); !left.empty()) {
        std::array<double, together> last;
        HWY_DYNAMIC_DISPATCH(fill)(words, whole / 4, last.data(), together / 4);
        std::copy_n(last.begin(), left.size(), left.begin());
    }
}

}  // namespace overturn::rare
#endif
