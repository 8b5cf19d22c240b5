#include "stats/detail/drawn_waves.hpp"

#include <algorithm>
#include <utility>

#include "stats/detail/drawn_numbers.hpp"

namespace overturn {

DrawnWaves::DrawnWaves(std::vector<std::uint32_t> group_of_wave, std::size_t groups)
    : group_of_wave_(std::move(group_of_wave)), counts_(groups), times_(groups * at_once) {}

void DrawnWaves::draw(BootstrapKey const& key, Purpose purpose, std::int64_t first) {
    for (std::size_t k = 0; k < at_once && waves() > 0; ++k) {
        DrawnNumbers stream(key.seed, static_cast<std::uint64_t>(first) + k, purpose, key.stream, waves());
        std::ranges::fill(counts_, 0U);
        for (std::size_t left = waves(); left > 0;) {
            auto const numbers = std::span(numbers_).first(std::min(left, numbers_.size()));
            stream.draw(numbers);
            for (auto const wave : numbers) {
                ++counts_[group_of_wave_[wave]];
            }
            left -= numbers.size();
        }
        for (std::size_t g = 0; g < counts_.size(); ++g) {
            times_[g * at_once + k] = counts_[g];
        }
    }
}

}  // namespace overturn
