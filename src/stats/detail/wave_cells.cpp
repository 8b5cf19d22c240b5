#include "stats/detail/wave_cells.hpp"

#include <algorithm>
#include <bit>
#include <numeric>

namespace overturn {
namespace {

std::size_t hash_of(std::span<CellCount const> counts) {
    constexpr std::uint64_t odd = 0x9e3779b97f4a7c15;  // 2^64 over the golden ratio
    std::uint64_t hash = counts.size();
    for (auto const& [cell, trials, overturned] : counts) {
        hash = (hash ^ cell ^ std::uint64_t{trials} << 12U ^ std::uint64_t{overturned} << 36U) * odd;
        hash ^= hash >> 29U;
    }
    return hash;
}

}  // namespace

WaveCells::WaveCells(std::span<SingleTrial const> trials, std::size_t most) {
    auto cells = cells_of(trials, most);
    points_ = std::move(cells.points);
    std::vector<std::size_t> order(trials.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    auto const wave_of = [&](std::size_t i) { return trials[i].wave; };
    if (!std::ranges::is_sorted(order, {}, wave_of)) {
        std::ranges::stable_sort(order, {}, wave_of);
    }
    first_of_pattern_.push_back(0);
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (i > 0 && wave_of(order[i]) != wave_of(order[i - 1])) {
            close_wave();
        }
        add(cells.cell_of_trial[order[i]], trials[order[i]].overturned);
    }
    if (!order.empty()) {
        close_wave();
    }
    patterns_by_hash_ = {};
}

void WaveCells::add(std::size_t cell, bool overturned) {
    auto const number = static_cast<std::uint32_t>(cell);
    auto const own = std::span(entries_).subspan(first_of_pattern_.back());
    auto const found = std::ranges::find(own, number, &CellCount::cell);
    auto& entry = found != own.end() ? *found : entries_.emplace_back(CellCount{number, 0, 0});
    ++entry.trials;
    entry.overturned += overturned ? 1 : 0;
}

// The entries behind the last pattern's are a wave's: a new pattern, or one that is there already.
void WaveCells::close_wave() {
    if (2 * first_of_pattern_.size() > patterns_by_hash_.size()) {
        constexpr std::size_t fewest = 64;
        patterns_by_hash_.assign(std::bit_ceil(std::max(fewest, 4 * first_of_pattern_.size())), 0);
        for (std::size_t p = 0; p + 1 < first_of_pattern_.size(); ++p) {
            auto const counts =
                std::span(entries_).subspan(first_of_pattern_[p], first_of_pattern_[p + 1] - first_of_pattern_[p]);
            auto slot = hash_of(counts) % patterns_by_hash_.size();
            while (patterns_by_hash_[slot] != 0) {
                slot = (slot + 1) % patterns_by_hash_.size();
            }
            patterns_by_hash_[slot] = static_cast<std::uint32_t>(p + 1);
        }
    }
    auto const own = std::span(entries_).subspan(first_of_pattern_.back());
    std::ranges::sort(own, {}, &CellCount::cell);
    auto slot = hash_of(own) % patterns_by_hash_.size();
    for (; patterns_by_hash_[slot] != 0; slot = (slot + 1) % patterns_by_hash_.size()) {
        auto const p = patterns_by_hash_[slot] - 1;
        auto const known =
            std::span(entries_).subspan(first_of_pattern_[p], first_of_pattern_[p + 1] - first_of_pattern_[p]);
        if (std::ranges::equal(known, own)) {
            entries_.resize(first_of_pattern_.back());
            pattern_of_wave_.push_back(p);
            return;
        }
    }
    pattern_of_wave_.push_back(static_cast<std::uint32_t>(patterns()));
    patterns_by_hash_[slot] = pattern_of_wave_.back() + 1;
    first_of_pattern_.push_back(entries_.size());
}

WaveResamples::WaveResamples(WaveCells const& cells, BootstrapKey const& key, Purpose purpose)
    : cells_(cells),
      key_(key),
      purpose_(purpose),
      draws_(cells.pattern_of_wave_, cells.patterns()),
      points_(cells.points()) {}

std::vector<FragilityPoint> const& WaveResamples::points(int resample) {
    constexpr std::int64_t at_once = DrawnWaves::at_once;
    auto const first = resample / at_once * at_once;
    if (first != drawn_from_) {
        drawn_from_ = first;
        draws_.draw(key_, purpose_, first);
        sums_.assign(2 * points_.size() * at_once, 0.0);
        add_cell_counts(cells_.first_of_pattern_, cells_.entries_, draws_.times(), sums_);
    }
    std::size_t const lane = resample - first;
    for (std::size_t c = 0; c < points_.size(); ++c) {
        points_[c].trials = sums_[2 * c * at_once + lane];
        points_[c].overturned = sums_[(2 * c + 1) * at_once + lane];
    }
    return points_;
}

}  // namespace overturn
