/// A shuffle without a table: which place each of n things takes, computed from its number alone.
#pragma once

#include <cstdint>

#include "core/random_stream.hpp"

namespace overturn {

/// A permutation of 0 .. n-1, a pure function of its key: eight rounds of a Feistel network on the smallest even number
/// of bits that holds n, walked on until it lands within n (Black & Rogaway 2002). Needs no memory, whatever n is.
class KeyedPermutation {
  public:
    /// \param group, purpose, index keep shuffles of one seed apart, as in RandomStream. \pre count > 0
    KeyedPermutation(std::uint64_t seed, std::uint64_t group, Purpose purpose, std::uint64_t index,
                     std::uint64_t count);

    /// \pre place < count
    [[nodiscard]] std::uint64_t operator()(std::uint64_t place) const;

  private:
    [[nodiscard]] std::uint64_t shuffled(std::uint64_t place) const;

    std::uint64_t seed_, group_, purpose_, index_, count_;
    unsigned half_bits_;
};

}  // namespace overturn
