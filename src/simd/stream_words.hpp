/// Many random words of a stream at once.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/random_stream.hpp"

namespace overturn::simd {

/// Words are made for so many counters together; of each come four.
inline constexpr std::size_t counters_together = 8, words_together = 4 * counters_together;

/// The bits of RandomStream(key) from the word 4 `first_counter` on. \pre a multiple of words_together
void stream_words(StreamKey const& key, std::uint64_t first_counter, std::span<std::uint64_t> words);

/// The bits of RandomStream(key), one after the other, made many at a time.
class StreamWords {
  public:
    explicit StreamWords(StreamKey const& key) : key_(key) {}

    std::uint64_t next() {
        if (used_ == words_.size()) {
            stream_words(key_, next_counter_, words_);
            next_counter_ += words_.size() / 4;
            used_ = 0;
        }
        return words_[used_++];
    }

  private:
    StreamKey key_;
    std::uint64_t next_counter_ = 0;
    std::array<std::uint64_t, 4 * words_together> words_{};
    std::size_t used_ = words_.size();
};

}  // namespace overturn::simd
