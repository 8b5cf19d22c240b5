#include "stats/detail/wave_cells.hpp"

#include <algorithm>
#include <numeric>

#include <gsl/gsl_rng.h>

namespace overturn {

WaveCells::WaveCells(std::span<SingleTrial const> trials, std::size_t most) {
    auto cells = cells_of(trials, most);
    points_ = std::move(cells.points);
    std::vector<std::size_t> order(trials.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    auto const wave_of = [&](std::size_t i) { return trials[i].wave; };
    if (!std::ranges::is_sorted(order, {}, wave_of)) {
        std::ranges::stable_sort(order, {}, wave_of);
    }
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (i == 0 || wave_of(order[i]) != wave_of(order[i - 1])) {
            first_of_wave_.push_back(entries_.size());
        }
        add(cells.cell_of_trial[order[i]], trials[order[i]].overturned);
    }
    first_of_wave_.push_back(entries_.size());
}

void WaveCells::add(std::size_t cell, bool overturned) {
    auto const number = static_cast<std::uint32_t>(cell);
    auto const own = std::span(entries_).subspan(first_of_wave_.back());
    auto const found = std::ranges::find(own, number, &Entry::cell);
    auto& entry = found != own.end() ? *found : entries_.emplace_back(Entry{number, 0, 0});
    ++entry.trials;
    entry.overturned += overturned ? 1 : 0;
}

std::vector<FragilityPoint> WaveCells::draw(RandomStream& stream) const {
    std::vector<std::uint32_t> times(waves());
    for (std::size_t w = 0; w < times.size(); ++w) {
        ++times[gsl_rng_uniform_int(stream.gsl(), times.size())];
    }
    struct Count {
        std::uint64_t trials = 0, overturned = 0;
    };
    std::vector<Count> counts(points_.size());
    for (std::size_t w = 0; w < times.size(); ++w) {
        std::uint64_t const often = times[w];
        if (often == 0) {
            continue;
        }
        for (auto e = first_of_wave_[w]; e < first_of_wave_[w + 1]; ++e) {
            auto const& entry = entries_[e];
            counts[entry.cell].trials += often * entry.trials;
            counts[entry.cell].overturned += often * entry.overturned;
        }
    }
    auto drawn = points_;
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        drawn[i].trials = static_cast<double>(counts[i].trials);
        drawn[i].overturned = static_cast<double>(counts[i].overturned);
    }
    return drawn;
}

}  // namespace overturn
