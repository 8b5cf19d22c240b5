#include "campaign/accepted_waves.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"

namespace overturn {
namespace {

constexpr std::int64_t first_look = 100;    // waves
constexpr std::int64_t least_of_them = 10;  // accepted, or the campaign ends

// The blocks of `drawn` that hold the first waves of each group, up to that of number `end(group)`; each once, rising.
template <class End, class Take> void each_block(Plan const& drawn, End&& end, Take&& take) {
    std::int64_t next = 0;  // a block may hold the last waves of one group and the first of another
    for (std::int64_t group = 0; group < drawn.groups(); ++group) {
        auto const last = end(group);
        auto block = std::max(next, group * drawn.drawn_per_group() / drawn.block_size());
        for (; block * drawn.block_size() < last; ++block) {
            take(block);
        }
        next = std::max(next, block);
    }
}

// What was missed, the most often first, and what helps.
std::string missed_text(std::vector<std::int64_t> const& missed) {
    auto const names = clause_names();
    auto const remedies = clause_remedies();
    std::vector<std::size_t> order;
    for (std::size_t c = 0; c < missed.size(); ++c) {
        if (missed[c] > 0) {
            order.push_back(c);
        }
    }
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return missed[a] > missed[b]; });
    std::string text;
    for (auto const c : order) {
        text += fmt::format("{}{} missed by {}", text.empty() ? "" : ", ", names[c], missed[c]);
    }
    return order.empty() ? std::string("they could not be made") : fmt::format("{}. {}", text, remedies[order.front()]);
}

void count_missed(WaveRow const& row, std::vector<std::int64_t>& missed) {
    for (std::size_t c = 0; c < missed.size(); ++c) {
        missed[c] += static_cast<std::int64_t>(static_cast<std::uint64_t>(row.acceptance_failures) >> c & 1U);
    }
}

}  // namespace

std::string missed_text(std::span<WaveRow const> refused) {
    std::vector<std::int64_t> missed(clause_names().size());
    for (auto const& row : refused) {
        count_missed(row, missed);
    }
    return missed_text(missed);
}

AcceptedWaves::AcceptedWaves(CampaignSpec const& spec, Plan const& drawn)
    : acceptance_(spec.source->about().acceptance),
      drawn_(drawn),
      known_(drawn.blocks()),
      waves_(needs_rows() ? static_cast<std::size_t>(drawn.waves()) : 0, Wave::unknown),
      missed_(clause_names().size()) {}

void AcceptedWaves::take(std::int64_t block, std::span<WaveRow const> rows) {
    known_.at(block) = true;
    if (!needs_rows()) {
        return;
    }
    auto const [first, count] = drawn_.waves_of_block(block);
    OVERTURN_EXPECT(count == std::ssize(rows));
    for (std::int64_t w = 0; w < count; ++w) {
        auto const& row = rows[w];
        bool const accepted = is_tried(acceptance_, row);
        waves_.at(first + w) = accepted ? Wave::accepted : Wave::refused;
        if (!accepted) {
            count_missed(row, missed_);
        }
    }
}

AcceptedWaves::Known AcceptedWaves::known(std::int64_t group, std::int64_t count) const {
    Known found;
    auto const first = group * drawn_.drawn_per_group();
    while (found.drawn < drawn_.drawn_per_group() && found.accepted < count) {
        auto const wave = waves_[first + found.drawn];
        if (wave == Wave::unknown) {
            break;
        }
        ++found.drawn;
        found.accepted += wave == Wave::accepted ? 1 : 0;
        found.accepted_of_first += wave == Wave::accepted && found.drawn <= first_look ? 1 : 0;
    }
    return found;
}

// How many of a group to draw in all before the next look: as many as the share so far asks for. The first hundred are
// looked at before the rest.
std::int64_t AcceptedWaves::draw_to(std::int64_t group, std::int64_t count) const {
    if (!needs_rows()) {
        return count;
    }
    auto const [drawn, accepted, of_first] = known(group, count);
    auto const most = drawn_.drawn_per_group();
    if (accepted >= count || drawn == most) {
        return drawn;
    }
    auto const share = drawn == 0 ? 1.0 : std::max(0.1, static_cast<double>(accepted) / static_cast<double>(drawn));
    auto const more = static_cast<std::int64_t>(std::ceil(static_cast<double>(count - accepted) / share));
    bool const before = drawn < first_look;
    return std::min({drawn + more, before ? first_look : most, most});
}

std::vector<std::int64_t> AcceptedWaves::wanted(std::int64_t count) const {
    std::vector<std::int64_t> blocks;
    auto const end = [&](std::int64_t group) { return group * drawn_.drawn_per_group() + draw_to(group, count); };
    each_block(drawn_, end, [&](std::int64_t block) {
        if (!knows(block)) {
            blocks.push_back(block);
        }
    });
    return blocks;
}

Plan AcceptedWaves::chosen(std::int64_t count) const {
    if (!needs_rows()) {
        return count == drawn_.count() ? drawn_ : drawn_.first(count / drawn_.block_size());
    }
    std::vector<std::int64_t> numbers;
    for (std::int64_t group = 0; group < drawn_.groups(); ++group) {
        auto const first = group * drawn_.drawn_per_group();
        std::int64_t accepted = 0;
        for (std::int64_t n = first; n < first + drawn_.drawn_per_group() && accepted < count; ++n) {
            auto const wave = waves_[n];
            OVERTURN_EXPECT(wave != Wave::unknown);
            if (wave == Wave::accepted) {
                numbers.push_back(n);
                ++accepted;
            }
        }
    }
    return drawn_.chosen(std::move(numbers), count);
}

std::string AcceptedWaves::hopeless() const {
    if (!needs_rows()) {
        return {};
    }
    for (std::int64_t group = 0; group < drawn_.groups(); ++group) {
        auto const [drawn, accepted, of_first] = known(group, drawn_.drawn_per_group());
        if (drawn >= first_look && of_first < least_of_them && drawn_.drawn_per_group() > first_look) {
            return fmt::format("{} of the first {} waves meet {} (fewer than one in ten; of those refused: {})",
                               of_first, first_look, acceptance_.rule, missed_text(missed_));
        }
        if (drawn == drawn_.drawn_per_group() && accepted == 0) {
            return fmt::format("none of {} waves meets {} ({})", drawn, acceptance_.rule, missed_text(missed_));
        }
    }
    return {};
}

BlockRows rows_of_chosen(BlockRows rows, Plan const& drawn, std::int64_t block, Plan const& chosen) {
    auto const [first, count] = drawn.waves_of_block(block);
    std::size_t const bodies = drawn.bodies();
    std::size_t const trials = drawn.trials_per_wave();
    auto const extra = trials * drawn.extra_bytes();
    BlockRows kept;
    auto const copy = [](auto const& from, std::size_t each, std::size_t place, auto& to) {
        auto const begin = from.begin() + (place * each);
        to.insert(to.end(), begin, begin + each);
    };
    for (std::int64_t w = 0; w < count; ++w) {
        if (!chosen.has(first + w)) {
            continue;
        }
        std::size_t const place = w;
        kept.waves.push_back(rows.waves[place]);
        copy(rows.measures, bodies, place, kept.measures);
        copy(rows.trials.rows, trials, place, kept.trials.rows);
        copy(rows.trials.extra, extra, place, kept.trials.extra);
    }
    return std::ssize(kept.waves) == count ? std::move(rows) : std::move(kept);
}

std::vector<WaveRow> refused_rows(BlockRows const& rows, Plan const& drawn, std::int64_t block, Plan const& chosen) {
    std::vector<WaveRow> refused;
    auto const [first, waves] = drawn.waves_of_block(block);
    for (std::int64_t w = 0; w < waves; ++w) {
        auto const number = first + w;
        if (!chosen.has(number) && number < chosen.drawn_until(drawn.group_of(number))) {
            refused.push_back(rows.waves[w]);
        }
    }
    return refused;
}

std::vector<std::int64_t> blocks_of_chosen(Plan const& drawn, Plan const& chosen) {
    std::vector<std::int64_t> blocks;
    each_block(
        drawn, [&](std::int64_t group) { return chosen.drawn_until(group); },
        [&](std::int64_t block) { blocks.push_back(block); });
    return blocks;
}

}  // namespace overturn
