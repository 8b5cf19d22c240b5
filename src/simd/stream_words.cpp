#include "simd/stream_words.hpp"

#include "core/error.hpp"
#include "simd/targets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "simd/stream_words.cpp"
#include <hwy/foreach_target.h>
// foreach_target comes first: it includes this file once per instruction set
#include "simd/threefry-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace overturn::simd::HWY_NAMESPACE {

void fill_words(StreamKey const& key, std::uint64_t first_counter, std::span<std::uint64_t> words) {
    hn::CappedTag<std::uint64_t, counters_together> const tag;
    Threefry<decltype(tag)> const threefry(key);
    for (std::size_t c = 0; 4 * c < words.size(); c += hn::Lanes(tag)) {
        auto const x = threefry(first_counter + c);
        hn::StoreInterleaved4(x.a, x.b, x.c, x.d, tag, words.data() + 4 * c);
    }
}

}  // namespace overturn::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace overturn::simd {

HWY_EXPORT(fill_words);

void stream_words(StreamKey const& key, std::uint64_t first_counter, std::span<std::uint64_t> words) {
    OVERTURN_EXPECT(words.size() % words_together == 0);
    HWY_DYNAMIC_DISPATCH(fill_words)(key, first_counter, words);
}

}  // namespace overturn::simd
#endif
