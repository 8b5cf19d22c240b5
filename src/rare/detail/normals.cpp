#include "rare/detail/normals.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "simd/targets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rare/detail/normals.cpp"
#include <hwy/foreach_target.h>
// foreach_target comes first: it includes this file once per instruction set
#include "rare/detail/lane_functions-inl.hpp"

#ifndef OVERTURN_RARE_KEY
#define OVERTURN_RARE_KEY
namespace overturn::rare {
using Key = std::array<std::uint64_t, 5>;  // the fifth word is the others' parity
}  // namespace overturn::rare
#endif

HWY_BEFORE_NAMESPACE();
namespace overturn::rare::HWY_NAMESPACE {

// Threefry4x64-20 (Salmon et al., SC'11) as core/random_stream has it, one counter a lane.
constexpr int rounds = 20;
constexpr std::array<std::array<int, 2>, 8> rotations{
    {{14, 16}, {52, 57}, {23, 40}, {5, 37}, {25, 33}, {46, 12}, {58, 22}, {32, 32}}};

struct FourWords {
    Words a, b, c, d;
};

template <int Round> HWY_INLINE void mix(FourWords& x, Key const& key) {
    x.a = hn::Add(x.a, x.b);
    x.b = hn::Xor(hn::RotateRight<64 - rotations[Round % 8][0]>(x.b), x.a);
    x.c = hn::Add(x.c, x.d);
    x.d = hn::Xor(hn::RotateRight<64 - rotations[Round % 8][1]>(x.d), x.c);
    std::swap(x.b, x.d);
    if constexpr (Round % 4 == 3) {
        constexpr std::uint64_t injection = Round / 4 + 1;
        x.a = hn::Add(x.a, hn::Set(Word(), key[injection % 5]));
        x.b = hn::Add(x.b, hn::Set(Word(), key[(injection + 1) % 5]));
        x.c = hn::Add(x.c, hn::Set(Word(), key[(injection + 2) % 5]));
        x.d = hn::Add(x.d, hn::Set(Word(), key[(injection + 3) % 5] + injection));
    }
}

template <int... Round>
HWY_INLINE void mix_all(FourWords& x, Key const& key, std::integer_sequence<int, Round...> /*all*/) {
    (mix<Round>(x, key), ...);
}

HWY_INLINE FourWords threefry(Key const& key, Words counter) {
    FourWords x{hn::Add(counter, hn::Set(Word(), key[0])), hn::Set(Word(), key[1]), hn::Set(Word(), key[2]),
                hn::Set(Word(), key[3])};
    mix_all(x, key, std::make_integer_sequence<int, rounds>());
    return x;
}

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
void fill(Key const& key, std::uint64_t first, double* normals, std::size_t counters) {
    constexpr auto lanes = hn::MaxLanes(Real());
    for (std::size_t i = 0; i < counters; i += lanes) {
        auto const x = threefry(key, hn::Iota(Word(), first + i));
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
    constexpr std::uint64_t parity = 0x1BD11BDAA9FC1A22U;  // of Threefish, as Threefry takes it
    auto const purpose = static_cast<std::uint64_t>(Purpose::rare_normals);
    Key const words{key.seed, key.index, purpose, key.stage(), parity ^ key.seed ^ key.index ^ purpose ^ key.stage()};
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
