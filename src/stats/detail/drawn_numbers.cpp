#include "stats/detail/drawn_numbers.hpp"

#include "simd/targets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "stats/detail/drawn_numbers.cpp"
#include <hwy/foreach_target.h>
// foreach_target comes first: it includes this file once per instruction set
#include <limits>
#include <utility>

#include <hwy/highway.h>

#include "core/error.hpp"

HWY_BEFORE_NAMESPACE();
namespace overturn::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::CappedTag<std::uint64_t, 8>;
using Word = hn::Vec<Tag>;

template <int by> HWY_INLINE Word rotated(Word x) { return hn::Or(hn::ShiftLeft<by>(x), hn::ShiftRight<64 - by>(x)); }

// One round's mix of two words.
template <int by> HWY_INLINE void mix(Word& a, Word& b) {
    a = hn::Add(a, b);
    b = hn::Xor(rotated<by>(b), a);
}

// Four rounds, and the key after them.
template <bool odd> HWY_INLINE void four_rounds(Word& x0, Word& x1, Word& x2, Word& x3) {
    if constexpr (!odd) {
        mix<14>(x0, x1), mix<16>(x2, x3);
        mix<52>(x0, x3), mix<57>(x2, x1);
        mix<23>(x0, x1), mix<40>(x2, x3);
        mix<5>(x0, x3), mix<37>(x2, x1);
    } else {
        mix<25>(x0, x1), mix<33>(x2, x3);
        mix<46>(x0, x3), mix<12>(x2, x1);
        mix<58>(x0, x1), mix<22>(x2, x3);
        mix<32>(x0, x3), mix<32>(x2, x1);
    }
}

// Threefry4x64-20 of the counters {first, 0, 0, 0}, {first + 1, 0, 0, 0}, ...
void encrypt_counters(std::array<std::uint64_t, 4> const& key, std::uint64_t first, std::span<std::uint64_t> words) {
    Tag const tag;
    constexpr std::uint64_t parity = 0x1BD11BDAA9FC1A22;
    std::array const keys{key[0], key[1], key[2], key[3], parity ^ key[0] ^ key[1] ^ key[2] ^ key[3]};
    auto const width = hn::Lanes(tag);
    for (std::size_t c = 0; 4 * c < words.size(); c += width) {
        auto x0 = hn::Add(hn::Iota(tag, first + c), hn::Set(tag, keys[0]));
        auto x1 = hn::Set(tag, keys[1]);
        auto x2 = hn::Set(tag, keys[2]);
        auto x3 = hn::Set(tag, keys[3]);
        for (std::uint64_t s = 1; s <= 5; ++s) {
            s % 2 == 1 ? four_rounds<false>(x0, x1, x2, x3) : four_rounds<true>(x0, x1, x2, x3);
            x0 = hn::Add(x0, hn::Set(tag, keys[s % 5]));
            x1 = hn::Add(x1, hn::Set(tag, keys[(s + 1) % 5]));
            x2 = hn::Add(x2, hn::Set(tag, keys[(s + 2) % 5]));
            x3 = hn::Add(x3, hn::Set(tag, keys[(s + 3) % 5] + s));
        }
        hn::StoreInterleaved4(x0, x1, x2, x3, tag, words.data() + 4 * c);
    }
}

}  // namespace overturn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace overturn {

HWY_EXPORT(encrypt_counters);

namespace {

__extension__ using Wide = unsigned __int128;

}  // namespace

DrawnNumbers::DrawnNumbers(std::uint64_t seed, std::uint64_t wave, Purpose purpose, std::uint64_t index,
                           std::uint64_t count)
    : key_{seed, wave, static_cast<std::uint64_t>(purpose), index},
      count_(count),
      scale_(std::numeric_limits<std::uint64_t>::max() / count) {
    OVERTURN_EXPECT(count > 0 && count <= std::numeric_limits<std::uint32_t>::max());
}

// GSL takes bits / scale and throws away what reaches `count`. The product's upper half is that quotient or one less.
void DrawnNumbers::draw(std::span<std::uint32_t> numbers) {
    constexpr unsigned half = 64;
    for (std::size_t drawn = 0; drawn < numbers.size();) {
        if (used_ == words_.size()) {
            HWY_DYNAMIC_DISPATCH(encrypt_counters)(key_, next_counter_, words_);
            next_counter_ += counters;
            used_ = 0;
        }
        auto const bits = words_[used_++];
        auto quotient = static_cast<std::uint64_t>(static_cast<Wide>(bits) * count_ >> half);
        quotient += bits - quotient * scale_ >= scale_ ? 1 : 0;
        numbers[drawn] = static_cast<std::uint32_t>(quotient);
        drawn += quotient < count_ ? 1 : 0;
    }
}

}  // namespace overturn
#endif
