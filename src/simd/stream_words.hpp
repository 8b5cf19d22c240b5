/// Many random words of a stream at once.
#pragma once

#include <cstdint>
#include <span>

#include "core/random_stream.hpp"

namespace overturn::simd {

/// Words are made for so many counters together; of each come four.
inline constexpr std::size_t counters_together = 8, words_together = 4 * counters_together;

/// The bits of RandomStream(key) from the word 4 `first_counter` on. \pre a multiple of words_together
void stream_words(StreamKey const& key, std::uint64_t first_counter, std::span<std::uint64_t> words);

}  // namespace overturn::simd
