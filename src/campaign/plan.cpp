#include "campaign/plan.hpp"

#include <algorithm>

#include "campaign/detail/stated_waves.hpp"
#include "campaign/waves_per_look.hpp"
#include "core/error.hpp"

namespace overturn {
namespace {

constexpr std::int64_t ids_per_level = 1'000'000'000;
// See worker.hpp for what a block's length costs and saves.
constexpr std::int64_t blocks_wanted = 256;         // enough for a workstation to balance, few enough to merge at once
constexpr std::int64_t many_blocks_wanted = 16384;  // of campaigns that are worth a thousand ranks: 16 for each
constexpr std::int64_t shortest_of_many = 16;       // waves: for these blocks do not get shorter, a tenth of a second
constexpr std::int64_t largest_block = 64;          // waves: some seconds, which a killed rank loses
// What is given up when a rank has to leave. A trial on points takes 5 ms to 30 ms, and longer on a stiff pad.
constexpr double longest_block_s = 5;
constexpr double trial_on_points_s = 0.03;
constexpr std::int64_t most_block_trials = 1 << 16U;  // in a block of several waves: 20 MB of rows
constexpr std::int64_t unmeasured_block = 128;        // waves at least: 0.2 ms each, a commit takes 1 ms to 6 ms
constexpr std::int64_t most_blocks = 1 << 20U;        // files, 1024 in a folder

// Waves in a block, so that there are no more blocks than that.
std::int64_t shortest_of_all(std::int64_t waves) { return (waves + most_blocks - 1) / most_blocks; }

std::int64_t groups_of(CampaignSpec const& spec) {
    return spec.levels.independent_waves ? std::ssize(spec.levels.levels) : 1;
}

// Waves of one level, or that all levels share, of which none is drawn beyond.
std::int64_t may_be_drawn(CampaignSpec const& spec) {
    auto const acceptance = spec.source->about().acceptance;
    if (!acceptance.refuses()) {
        return spec.wave_count;
    }
    auto const available = spec.source->about().available;
    return available ? static_cast<std::int64_t>(*available) : spec.wave_count * acceptance.most_drawn;
}

// How many trials of a wave may run on points, which are a hundred times as dear as others.
std::int64_t trials_on_points(CampaignSpec const& spec, std::int64_t levels) {
    auto const points = mask_of(Effect::contact) | mask_of(Effect::spatial);
    bool const across = may_shake_across(spec);
    return levels * std::ranges::count_if(spec.bodies, [&](BodySpec const& body) {
               return body.footing.stated || (spec.effects.include & points) != 0 || (across && body.axes > 1);
           });
}

// By what the campaign says, not by a clock: ranks, parts and resumed runs cut it equally. A block is no longer than a
// rank, and the one that merges, can hold many of. Looks at a target come at the ends of blocks.
std::int64_t waves_per_block(std::int64_t waves, std::int64_t trials_per_wave, std::int64_t on_points,
                             CampaignSpec const& spec) {
    bool const quick = !spec.measures.energy && !spec.measures.wave_quality && !spec.has_target() && on_points == 0;
    auto const least = quick ? std::min(unmeasured_block, waves) : 1;
    auto const of_many = std::clamp(waves / many_blocks_wanted, shortest_of_many, largest_block);
    auto const wanted = std::max(std::min(waves_per_look(waves), of_many), least);
    auto const soon = longest_block_s / (trial_on_points_s * static_cast<double>(std::max<std::int64_t>(on_points, 1)));
    auto const most = std::min(most_block_trials / trials_per_wave,
                               on_points > 0 ? static_cast<std::int64_t>(soon) : most_block_trials);
    auto size = std::max(std::min(wanted, std::max<std::int64_t>(most, 1)), shortest_of_all(waves));
    while (spec.has_target() && waves_per_look(waves) % size != 0) {
        --size;
    }
    return size;
}

}  // namespace

std::int64_t waves_per_look(std::int64_t waves) {
    return std::max(std::clamp(waves / blocks_wanted, std::int64_t{1}, largest_block), shortest_of_all(waves));
}

Plan::Plan(CampaignSpec const& spec)
    : independent_(spec.levels.independent_waves),
      count_(spec.wave_count),
      drawn_per_group_(may_be_drawn(spec)),
      chosen_per_group_(count_),
      waves_(drawn_per_group_ * groups_of(spec)),
      bodies_(std::ssize(spec.bodies)),
      levels_per_wave_(independent_ ? 1 : std::ssize(spec.levels.levels)),
      block_size_(waves_per_block(count_ * groups_of(spec), bodies_ * levels_per_wave_,
                                  trials_on_points(spec, levels_per_wave_), spec)),
      extra_bytes_(static_cast<std::int64_t>(ModelSelector(spec.effects, spec.accuracy).extra_bytes())) {
    for (auto const& level : spec.levels.levels) {
        level_keys_.push_back(level.key());
    }
}

Plan Plan::chosen(std::vector<std::int64_t> numbers, std::int64_t count) const {
    OVERTURN_EXPECT(std::ranges::is_sorted(numbers));
    auto plan = *this;
    plan.waves_ = numbers.size();
    plan.numbers_ = std::move(numbers);
    plan.chosen_per_group_ = count;
    return plan;
}

Plan Plan::without_refusals() const {
    if (drawn_per_group_ == count_) {
        return *this;
    }
    std::vector<std::int64_t> numbers;
    for (std::int64_t group = 0; group < groups(); ++group) {
        for (std::int64_t n = 0; n < count_; ++n) {
            numbers.push_back(group * drawn_per_group_ + n);
        }
    }
    return chosen(std::move(numbers), count_);
}

std::int64_t Plan::number(std::int64_t wave) const { return numbers_ ? numbers_->at(wave) : wave; }

bool Plan::has(std::int64_t number) const {
    return numbers_ ? std::ranges::binary_search(*numbers_, number) : number < waves_;
}

std::int64_t Plan::drawn_until(std::int64_t group) const {
    auto const end = (group + 1) * drawn_per_group_;
    if (!numbers_) {
        return std::min(end, waves_);
    }
    auto const first = std::ranges::lower_bound(*numbers_, group * drawn_per_group_);
    auto const last = std::ranges::lower_bound(*numbers_, end);
    return last - first < chosen_per_group_ ? end : *(last - 1) + 1;
}

std::int64_t Plan::number_of(std::int64_t wave_id) const {
    if (!independent_) {
        return wave_id;
    }
    auto const level = std::ranges::find(level_keys_, wave_id / ids_per_level) - level_keys_.begin();
    return level * drawn_per_group_ + wave_id % ids_per_level;
}

std::int64_t Plan::groups() const { return independent_ ? std::ssize(level_keys_) : 1; }

std::uint64_t Plan::wave_id(std::int64_t wave) const {
    auto const drawn = number(wave);
    if (!independent_) {
        return drawn;
    }
    auto const key = level_keys_.at(drawn / drawn_per_group_);
    return key * ids_per_level + drawn % drawn_per_group_;
}

// Waves drawn beyond `count`, in the place of refused ones, are sliced anew, `count` at a time.
DrawnFor Plan::drawn_for(CampaignSpec const& spec, std::int64_t wave) const {
    auto const drawn = number(wave) % drawn_per_group_;
    auto const key = independent_ ? level_keys_.at(number(wave) / drawn_per_group_) : 0;
    constexpr unsigned above_keys = 48;
    return {.seed = spec.seed,
            .wave = wave_id(wave),
            .sampling = spec.sampling,
            .place = static_cast<std::uint64_t>(drawn % count_),
            .count = static_cast<std::uint64_t>(count_),
            .group = static_cast<std::uint64_t>(key) ^ static_cast<std::uint64_t>(drawn / count_) << above_keys};
}

std::int64_t Plan::first_level(std::int64_t wave) const { return independent_ ? number(wave) / drawn_per_group_ : 0; }

Plan::Waves Plan::waves_of_block(std::int64_t block) const {
    auto const first = block * block_size_;
    return {first, std::min(block_size_, waves_ - first)};
}

store::BlockRange Plan::blocks_of(Part part) const {
    OVERTURN_EXPECT(part.number >= 1 && part.number <= part.of);
    return {blocks() * (part.number - 1) / part.of, blocks() * part.number / part.of};
}

Plan Plan::first(std::int64_t blocks) const {
    OVERTURN_EXPECT(!independent_ && !numbers_ && blocks >= 0 && blocks <= this->blocks());
    auto cut = *this;
    cut.waves_ = std::min(waves_, blocks * block_size_);
    cut.chosen_per_group_ = std::min(count_, cut.waves_);
    return cut;
}

std::string Plan::waves_text(std::vector<std::int64_t> const& blocks) const {
    std::string text;
    for (std::size_t i = 0; i < blocks.size();) {
        auto last = i;
        while (last + 1 < blocks.size() && blocks[last + 1] == blocks[last] + 1) {
            ++last;
        }
        auto const end = waves_of_block(blocks[last]);
        text += fmt::format("{}{} to {}", text.empty() ? "" : ", ", waves_of_block(blocks[i]).first,
                            end.first + end.count - 1);
        i = last + 1;
    }
    return text;
}

Plan::TrialPlace Plan::trial(std::int64_t number) const {
    OVERTURN_EXPECT(number >= 0 && number < trials());
    auto const wave = number / trials_per_wave();
    auto const rest = number % trials_per_wave();
    return {wave, rest / levels_per_wave_, first_level(wave) + rest % levels_per_wave_};
}

}  // namespace overturn
