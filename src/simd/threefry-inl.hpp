// The random words of core/random_stream, of several counters side by side. Included once per instruction set, so
// without a #pragma once; after simd/targets.hpp and foreach_target.h.
#if defined(OVERTURN_THREEFRY) == defined(HWY_TARGET_TOGGLE)
#ifdef OVERTURN_THREEFRY
#undef OVERTURN_THREEFRY
#else
#define OVERTURN_THREEFRY
#endif

#include <array>
#include <cstdint>
#include <utility>

#include <hwy/highway.h>

#include "core/random_stream.hpp"

HWY_BEFORE_NAMESPACE();
namespace overturn::simd::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Four words a counter. The fifth word of the key is the parity of the others.
template <class D> class Threefry {
  public:
    using Words = hn::Vec<D>;
    struct Four {
        Words a, b, c, d;
    };

    explicit Threefry(StreamKey const& key)
        : key_{key.seed, key.wave, static_cast<std::uint64_t>(key.purpose), key.index} {
        constexpr std::uint64_t parity = 0x1BD11BDAA9FC1A22U;  // of Threefish
        key_[4] = parity ^ key_[0] ^ key_[1] ^ key_[2] ^ key_[3];
    }

    /// Of the counters {first, 0, 0, 0}, {first + 1, 0, 0, 0}, ...
    HWY_INLINE Four operator()(std::uint64_t first) const {
        Four x{hn::Add(hn::Iota(D(), first), word(key_[0])), word(key_[1]), word(key_[2]), word(key_[3])};
        mix_all(x, std::make_integer_sequence<int, rounds>());
        return x;
    }

  private:
    static constexpr int rounds = 20;
    static constexpr std::array<std::array<int, 2>, 8> rotations{
        {{14, 16}, {52, 57}, {23, 40}, {5, 37}, {25, 33}, {46, 12}, {58, 22}, {32, 32}}};

    static HWY_INLINE Words word(std::uint64_t x) { return hn::Set(D(), x); }

    template <int Round> HWY_INLINE void mix(Four& x) const {
        x.a = hn::Add(x.a, x.b);
        x.b = hn::Xor(hn::RotateRight<64 - rotations[Round % 8][0]>(x.b), x.a);
        x.c = hn::Add(x.c, x.d);
        x.d = hn::Xor(hn::RotateRight<64 - rotations[Round % 8][1]>(x.d), x.c);
        std::swap(x.b, x.d);
        if constexpr (Round % 4 == 3) {
            constexpr std::uint64_t injection = Round / 4 + 1;
            x.a = hn::Add(x.a, word(key_[injection % 5]));
            x.b = hn::Add(x.b, word(key_[(injection + 1) % 5]));
            x.c = hn::Add(x.c, word(key_[(injection + 2) % 5]));
            x.d = hn::Add(x.d, word(key_[(injection + 3) % 5] + injection));
        }
    }

    template <int... Round> HWY_INLINE void mix_all(Four& x, std::integer_sequence<int, Round...> /*all*/) const {
        (mix<Round>(x), ...);
    }

    std::array<std::uint64_t, 5> key_;
};

}  // namespace overturn::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
