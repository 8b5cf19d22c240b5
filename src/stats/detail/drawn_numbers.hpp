/// Whole numbers below a bound, many at a time: those that gsl_rng_uniform_int draws one by one from a RandomStream.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/random_stream.hpp"

namespace overturn {

class DrawnNumbers {
  public:
    /// Those of RandomStream(seed, wave, purpose, index), from its first on. \pre 0 < count < 2^32
    DrawnNumbers(std::uint64_t seed, std::uint64_t wave, Purpose purpose, std::uint64_t index, std::uint64_t count);

    void draw(std::span<std::uint32_t> numbers);

  private:
    static constexpr std::size_t counters = 32;  // at once; of each come four words

    StreamKey key_;
    std::uint64_t count_, scale_;
    std::uint64_t next_counter_ = 0;
    std::array<std::uint64_t, 4 * counters> words_{};
    std::size_t used_ = words_.size();
};

}  // namespace overturn
