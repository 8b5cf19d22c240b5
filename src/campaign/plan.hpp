/// A campaign numbered: waves, trials and blocks. Nothing here knows of ranks.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "campaign/campaign_spec.hpp"
#include "store/block_lock.hpp"

namespace overturn {

/// One of the parts that an array job splits a campaign into, counted from 1.
struct Part {
    std::int64_t number = 1, of = 1;

    [[nodiscard]] bool is_whole() const { return of == 1; }
};

/// Waves are counted from 0 over the whole campaign; trials likewise, wave by wave, then body, then level. Where waves
/// are held to a rule the plan of the campaign is of all that may be drawn; of the accepted ones is chosen().
class Plan {
  public:
    explicit Plan(CampaignSpec const& spec);

    [[nodiscard]] std::int64_t waves() const { return waves_; }
    [[nodiscard]] std::int64_t bodies() const { return bodies_; }
    [[nodiscard]] std::int64_t trials_per_wave() const { return bodies_ * levels_per_wave_; }
    [[nodiscard]] std::int64_t trials() const { return waves_ * trials_per_wave(); }
    [[nodiscard]] std::int64_t blocks() const { return (waves_ + block_size_ - 1) / block_size_; }
    [[nodiscard]] std::int64_t block_size() const { return block_size_; }
    /// Size of the models' extra values of a trial (ModelSelector::extra_bytes) [bytes].
    [[nodiscard]] std::int64_t extra_bytes() const { return extra_bytes_; }

    /// The same campaign with these of its waves only, rising, `count` of each group or all that could be had. Its own
    /// first wave is the first of them.
    [[nodiscard]] Plan chosen(std::vector<std::int64_t> numbers, std::int64_t count) const;
    /// The same where a rule refuses none: for sizes and times before anything is drawn.
    [[nodiscard]] Plan without_refusals() const;
    /// Number of the plan's wave among the waves that may be drawn.
    [[nodiscard]] std::int64_t number(std::int64_t wave) const;
    /// Is the one of that number among the plan's waves?
    [[nodiscard]] bool has(std::int64_t number) const;
    /// One past the last number of a group that was drawn for the plan's waves.
    [[nodiscard]] std::int64_t drawn_until(std::int64_t group) const;
    /// Waves that the campaign requests in all, whatever had to be drawn for them.
    [[nodiscard]] std::int64_t asked() const { return count_ * groups(); }
    /// Waves that the plan was to have in each group; fewer than count() where the campaign ended early.
    [[nodiscard]] std::int64_t chosen_per_group() const { return chosen_per_group_; }
    /// The group that a number belongs to.
    [[nodiscard]] std::int64_t group_of(std::int64_t number) const { return number / drawn_per_group_; }
    /// Number of the wave with that identity. \pre there is one
    [[nodiscard]] std::int64_t number_of(std::int64_t wave_id) const;
    /// One of waves that all levels share, or one for each level.
    [[nodiscard]] std::int64_t groups() const;
    [[nodiscard]] std::int64_t drawn_per_group() const { return drawn_per_group_; }
    /// Waves of a group that the campaign requests.
    [[nodiscard]] std::int64_t count() const { return count_; }

    /// The wave's identity in every random stream. With independent waves those of a level are Level::key 10^9 + 0, 1,
    /// 2,
    /// ..., so that more waves or more levels, wherever they lie, change no other's.
    [[nodiscard]] std::uint64_t wave_id(std::int64_t wave) const;
    /// The levels at which a wave is tried: [first, first + count).
    [[nodiscard]] std::int64_t first_level(std::int64_t wave) const;
    [[nodiscard]] std::int64_t level_count() const { return levels_per_wave_; }
    /// Key of a body's draw under the wave; waves of one level are sliced together where levels have their own.
    [[nodiscard]] DrawnFor drawn_for(CampaignSpec const& spec, std::int64_t wave) const;

    struct Waves {
        std::int64_t first, count;
    };
    [[nodiscard]] Waves waves_of_block(std::int64_t block) const;
    /// The blocks of one of several equal parts: [first, last). Together the parts are all blocks, each once.
    [[nodiscard]] store::BlockRange blocks_of(Part part) const;
    /// The same campaign, ended after its first `blocks` blocks. \pre levels share waves
    [[nodiscard]] Plan first(std::int64_t blocks) const;
    /// "0 to 5, 18 to 23": the waves of the blocks, given in rising order.
    [[nodiscard]] std::string waves_text(std::vector<std::int64_t> const& blocks) const;

    struct TrialPlace {
        std::int64_t wave, body, level;
    };
    /// \pre 0 <= number < trials()
    [[nodiscard]] TrialPlace trial(std::int64_t number) const;

  private:
    bool independent_;
    std::vector<std::int64_t> level_keys_;
    std::int64_t count_;            ///< waves requested, shared or per level
    std::int64_t drawn_per_group_;  ///< that may be drawn, shared or per level
    std::int64_t chosen_per_group_;
    std::int64_t waves_, bodies_, levels_per_wave_, block_size_, extra_bytes_;
    std::optional<std::vector<std::int64_t>> numbers_;  ///< of chosen waves
};

}  // namespace overturn
