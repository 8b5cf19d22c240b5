/// Whole numbers below a bound, many at a time: those that gsl_rng_uniform_int draws one by one from a RandomStream.
#pragma once

#include <cstdint>
#include <span>

#include "core/random_stream.hpp"
#include "simd/stream_words.hpp"

namespace overturn {

class DrawnNumbers {
  public:
    /// Those of RandomStream(seed, wave, purpose, index), from its first on. \pre 0 < count < 2^32
    DrawnNumbers(std::uint64_t seed, std::uint64_t wave, Purpose purpose, std::uint64_t index, std::uint64_t count);

    void draw(std::span<std::uint32_t> numbers);

  private:
    simd::StreamWords words_;
    std::uint64_t count_, scale_;
};

}  // namespace overturn
