#include "stats/detail/drawn_numbers.hpp"

#include <limits>

#include "core/error.hpp"

namespace overturn {
namespace {

__extension__ using Wide = unsigned __int128;

}  // namespace

DrawnNumbers::DrawnNumbers(std::uint64_t seed, std::uint64_t wave, Purpose purpose, std::uint64_t index,
                           std::uint64_t count)
    : words_({seed, wave, purpose, index}), count_(count), scale_(std::numeric_limits<std::uint64_t>::max() / count) {
    OVERTURN_EXPECT(count > 0 && count <= std::numeric_limits<std::uint32_t>::max());
}

// GSL takes bits / scale and throws away what reaches `count`. The product's upper half is that quotient or one less.
void DrawnNumbers::draw(std::span<std::uint32_t> numbers) {
    constexpr unsigned half = 64;
    for (std::size_t drawn = 0; drawn < numbers.size();) {
        auto const bits = words_.next();
        auto quotient = static_cast<std::uint64_t>(static_cast<Wide>(bits) * count_ >> half);
        quotient += bits - quotient * scale_ >= scale_ ? 1 : 0;
        numbers[drawn] = static_cast<std::uint32_t>(quotient);
        drawn += quotient < count_ ? 1 : 0;
    }
}

}  // namespace overturn
