#include "campaign/block_rows.hpp"

#include <algorithm>
#include <cstring>

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
        throw SystemError("a block of results is too short (written by another version?). Start anew without --resume");
    }
    if (size > 0) {
        std::memcpy(rows.data(), bytes.data(), size);
    }
    bytes = bytes.subspan(size);
}

}  // namespace

BlockRows run_block(CampaignSpec const& spec, Plan const& plan, std::int64_t block, PhaseSeconds& seconds) {
    return *run_block(spec, plan, block, seconds, [] { return true; });
}

std::optional<BlockRows> run_block(CampaignSpec const& spec, Plan const& plan, std::int64_t block,
                                   PhaseSeconds& seconds, std::function<bool()> const& goes_on) {
    auto const together = waves_together(plan);
    BlockRows rows;
    auto const [first, count] = plan.waves_of_block(block);
    for (auto next = first; next < first + count; next += together) {
        std::vector<PreparedWave> waves;
        auto const end = std::min(next + together, first + count);
        waves.reserve(end - next);
        for (auto wave = next; wave < end; ++wave) {
            if (!goes_on()) {
                return std::nullopt;
            }
            waves.push_back(prepare_wave(spec, plan, wave, seconds));
            rows.waves.push_back(waves.back().row);
            rows.measures.insert(rows.measures.end(), waves.back().measures.begin(), waves.back().measures.end());
        }
        if (!append_trials(spec, plan, waves, rows.trials, seconds, goes_on)) {
            return std::nullopt;
        }
    }
    return rows;
}

std::vector<std::byte> BlockRows::pack() const {
    std::vector<std::byte> bytes;
    put(bytes, waves);
    put(bytes, measures);
    put(bytes, trials.rows);
    put(bytes, trials.own);
    return bytes;
}

std::size_t BlockRows::packed_size(Plan const& plan, std::int64_t block) {
    auto const rows = [&](std::int64_t per_wave) {
        return static_cast<std::size_t>(plan.waves_of_block(block).count * per_wave);
    };
    return rows(1) * sizeof(WaveRow) + rows(plan.bodies()) * sizeof(MeasureRow)
           + rows(plan.trials_per_wave()) * (sizeof(TrialRow) + static_cast<std::size_t>(plan.own_bytes()));
}

BlockRows BlockRows::unpack(std::span<std::byte const> bytes, Plan const& plan, std::int64_t waves) {
    BlockRows rows;
    take(bytes, rows.waves, waves);
    take(bytes, rows.measures, waves * plan.bodies());
    take(bytes, rows.trials.rows, waves * plan.trials_per_wave());
    take(bytes, rows.trials.own, waves * plan.trials_per_wave() * plan.own_bytes());
    if (!bytes.empty()) {
        throw SystemError("a block of results is too long (written by another version?). Start anew without --resume");
    }
    return rows;
}

}  // namespace overturn
