#include "core/keyed_permutation.hpp"

#include <algorithm>
#include <bit>

#include <Random123/threefry.h>

#include "core/error.hpp"

namespace overturn {

KeyedPermutation::KeyedPermutation(std::uint64_t seed, std::uint64_t group, Purpose purpose, std::uint64_t index,
                                   std::uint64_t count)
    : seed_(seed), group_(group), purpose_(static_cast<std::uint64_t>(purpose)), index_(index), count_(count) {
    OVERTURN_EXPECT(count > 0);
    auto const bits = static_cast<unsigned>(std::bit_width(count - 1));
    half_bits_ = std::max(1U, (bits + 1) / 2);
}

std::uint64_t KeyedPermutation::operator()(std::uint64_t place) const {
    OVERTURN_EXPECT(place < count_);
    do {
        place = shuffled(place);
    } while (place >= count_);
    return place;
}

std::uint64_t KeyedPermutation::shuffled(std::uint64_t place) const {
    constexpr std::uint64_t rounds = 8;
    // Apart from every random stream of the same key: those count their blocks with zeros behind.
    constexpr std::uint64_t apart = 0x7065726d75746521;
    r123::Threefry4x64 threefry;
    auto const mask = (std::uint64_t{1} << half_bits_) - 1;
    auto left = place >> half_bits_;
    auto right = place & mask;
    for (std::uint64_t round = 0; round < rounds; ++round) {
        auto const noise = threefry({{right, round, apart, 0}}, {{seed_, group_, purpose_, index_}})[0];
        auto const next = (left ^ noise) & mask;
        left = right;
        right = next;
    }
    return (left << half_bits_) | right;
}

}  // namespace overturn
