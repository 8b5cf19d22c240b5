#include "campaign/plan.hpp"

#include <algorithm>

#include "core/error.hpp"

namespace overturn {
namespace {

constexpr std::int64_t ids_per_level = 1'000'000'000;
constexpr std::int64_t blocks_wanted = 256;  // enough for any schedule to balance, few enough to merge at once
constexpr std::int64_t largest_block = 256;  // waves lost at most when a rank is killed

}  // namespace

Plan::Plan(CampaignSpec const& spec)
    : independent_(spec.levels.independent_waves),
      waves_per_level_(spec.wave_count),
      waves_(independent_ ? spec.wave_count * static_cast<std::int64_t>(spec.levels.levels.size()) : spec.wave_count),
      bodies_(static_cast<std::int64_t>(spec.bodies.size())),
      levels_per_wave_(independent_ ? 1 : static_cast<std::int64_t>(spec.levels.levels.size())),
      block_size_(std::clamp(waves_ / blocks_wanted, std::int64_t{1}, largest_block)) {
    for (auto const& level : spec.levels.levels) {
        level_keys_.push_back(level.key());
    }
}

std::uint64_t Plan::wave_id(std::int64_t wave) const {
    if (!independent_) {
        return static_cast<std::uint64_t>(wave);
    }
    auto const key = level_keys_.at(static_cast<std::size_t>(wave / waves_per_level_));
    return static_cast<std::uint64_t>(key * ids_per_level + wave % waves_per_level_);
}

DrawnFor Plan::drawn_for(CampaignSpec const& spec, std::int64_t wave) const {
    auto const group = independent_ ? level_keys_.at(static_cast<std::size_t>(wave / waves_per_level_)) : 0;
    return {.seed = spec.seed,
            .wave = wave_id(wave),
            .sampling = spec.sampling,
            .place = static_cast<std::uint64_t>(wave % waves_per_level_),
            .count = static_cast<std::uint64_t>(waves_per_level_),
            .group = static_cast<std::uint64_t>(group)};
}

std::int64_t Plan::first_level(std::int64_t wave) const { return independent_ ? wave / waves_per_level_ : 0; }

Plan::Waves Plan::waves_of_block(std::int64_t block) const {
    auto const first = block * block_size_;
    return {first, std::min(block_size_, waves_ - first)};
}

Plan::Trial Plan::trial(std::int64_t number) const {
    OVERTURN_EXPECT(number >= 0 && number < trials());
    auto const wave = number / trials_per_wave();
    auto const rest = number % trials_per_wave();
    return {wave, rest / levels_per_wave_, first_level(wave) + rest % levels_per_wave_};
}

}  // namespace overturn
