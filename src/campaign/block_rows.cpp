#include "campaign/block_rows.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

#include "core/error.hpp"

namespace overturn {
namespace {

template <class Row> void put(std::vector<std::byte>& bytes, std::vector<Row> const& rows) {
    auto const part = std::as_bytes(std::span(rows));
    bytes.insert(bytes.end(), part.begin(), part.end());
}

template <class Row> void take(std::span<std::byte const>& bytes, std::vector<Row>& rows, std::int64_t count) {
    rows.resize(count);
    auto const size = rows.size() * sizeof(Row);
    if (bytes.size() < size) {
        throw SystemError("a block of results is too short (written by another version?). Start anew with another -o");
    }
    if (size > 0) {
        std::memcpy(rows.data(), bytes.data(), size);
    }
    bytes = bytes.subspan(size);
}

std::vector<std::int64_t> waves_of(Plan const& plan, std::span<std::int64_t const> blocks) {
    std::vector<std::int64_t> numbers;
    for (auto const block : blocks) {
        auto const [first, count] = plan.waves_of_block(block);
        for (auto wave = first; wave < first + count; ++wave) {
            numbers.push_back(wave);
        }
    }
    return numbers;
}

// The first `count` of the rows, which are then no more among them.
template <class Row> std::vector<Row> next_of(std::span<Row const>& rows, std::int64_t count) {
    auto const taken = rows.first(count);
    rows = rows.subspan(taken.size());
    return {taken.begin(), taken.end()};
}

std::vector<BlockRows> parted(BlockRows all, Plan const& plan, std::span<std::int64_t const> blocks) {
    std::vector<BlockRows> parts;
    if (blocks.size() == 1) {
        parts.push_back(std::move(all));
        return parts;
    }
    std::span<WaveRow const> waves(all.waves);
    std::span<MeasureRow const> measures(all.measures);
    std::span<TrialRow const> trials(all.trials.rows);
    std::span<std::byte const> extra(all.trials.extra);
    for (auto const block : blocks) {
        auto const count = plan.waves_of_block(block).count;
        auto const of_trials = count * plan.trials_per_wave();
        parts.push_back({next_of(waves, count),
                         next_of(measures, count * plan.bodies()),
                         {next_of(trials, of_trials), next_of(extra, of_trials * plan.extra_bytes())}});
    }
    return parts;
}

}  // namespace

BlockRows run_block(CampaignSpec const& spec, Plan const& plan, std::int64_t block, PhaseSeconds& seconds) {
    return std::move(run_blocks(spec, plan, std::span(&block, 1), seconds, [] { return true; })->front());
}

std::int64_t blocks_together(Plan const& plan) {
    return std::max<std::int64_t>(1, waves_together(plan) / plan.block_size());
}

std::optional<std::vector<BlockRows>> run_blocks(CampaignSpec const& spec, Plan const& plan,
                                                 std::span<std::int64_t const> blocks, PhaseSeconds& seconds,
                                                 std::function<bool()> const& keep_running, KnownTrials const* known) {
    auto const together = static_cast<std::size_t>(waves_together(plan));
    auto const numbers = waves_of(plan, blocks);
    BlockRows all;
    for (std::size_t next = 0; next < numbers.size(); next += together) {
        std::vector<PreparedWave> waves;
        auto const count = std::min(together, numbers.size() - next);
        waves.reserve(count);
        for (auto const wave : std::span(numbers).subspan(next, count)) {
            if (!keep_running()) {
                return std::nullopt;
            }
            waves.push_back(prepare_wave(spec, plan, wave, seconds));
            all.waves.push_back(waves.back().row);
            all.measures.insert(all.measures.end(), waves.back().measures.begin(), waves.back().measures.end());
        }
        if (!append_trials(spec, plan, waves, all.trials, seconds, keep_running, known)) {
            return std::nullopt;
        }
    }
    return parted(std::move(all), plan, blocks);
}

std::vector<std::byte> BlockRows::pack() const {
    std::vector<std::byte> bytes;
    put(bytes, waves);
    put(bytes, measures);
    put(bytes, trials.rows);
    put(bytes, trials.extra);
    return bytes;
}

std::size_t BlockRows::packed_size(Plan const& plan, std::int64_t block) {
    auto const rows = [&](std::int64_t per_wave) {
        return static_cast<std::size_t>(plan.waves_of_block(block).count * per_wave);
    };
    return rows(1) * sizeof(WaveRow) + rows(plan.bodies()) * sizeof(MeasureRow)
           + rows(plan.trials_per_wave()) * (sizeof(TrialRow) + static_cast<std::size_t>(plan.extra_bytes()));
}

BlockRows BlockRows::unpack(std::span<std::byte const> bytes, Plan const& plan, std::int64_t waves) {
    BlockRows rows;
    take(bytes, rows.waves, waves);
    take(bytes, rows.measures, waves * plan.bodies());
    take(bytes, rows.trials.rows, waves * plan.trials_per_wave());
    take(bytes, rows.trials.extra, waves * plan.trials_per_wave() * plan.extra_bytes());
    if (!bytes.empty()) {
        throw SystemError("a block of results is too long (written by another version?). Start anew with another -o");
    }
    return rows;
}

}  // namespace overturn
