#include "runner/detail/extension.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <vector>

#include <fmt/ranges.h>

#include "campaign/block_rows.hpp"
#include "campaign/version.hpp"
#include "core/error.hpp"
#include "results/recount.hpp"
#include "results/stored_rows.hpp"
#include "store/results_file.hpp"

namespace overturn {
namespace {

// The rows of waves that a finished file holds, by the waves' identity.
class FinishedRows {
  public:
    FinishedRows(store::ResultsReader const& file, CampaignSpec const& spec, Plan const& plan)
        : plan_(plan), rows_(file, spec) {
        auto const ids = file.integers("waves/id");
        for (std::size_t i = 0; i < ids.size(); ++i) {
            places_.emplace(ids[i], static_cast<std::int64_t>(i));
        }
    }

    // All of a block, or nothing if the file lacks one of its waves.
    [[nodiscard]] std::optional<BlockRows> block(std::int64_t number) const {
        auto const [first, count] = plan_.waves_of_block(number);
        std::vector<std::int64_t> rows;
        for (auto wave = first; wave < first + count; ++wave) {
            auto const found = places_.find(static_cast<std::int64_t>(plan_.wave_id(wave)));
            if (found == places_.end()) {
                return std::nullopt;
            }
            rows.push_back(found->second);
        }
        BlockRows block;
        for (std::size_t begin = 0; begin < rows.size();) {
            auto end = begin + 1;
            while (end < rows.size() && rows[end] == rows[end - 1] + 1) {
                ++end;
            }
            append(block, rows[begin], end - begin);
            begin = end;
        }
        return block;
    }

  private:
    // Of waves that follow each other in the file.
    void append(BlockRows& block, std::int64_t wave, std::int64_t count) const {
        auto const waves = rows_.waves(wave, count);
        auto const measures = rows_.measures(wave, count);
        auto const each = plan_.trials_per_wave();
        auto const trials = rows_.trials(wave * each, count * each);
        block.waves.insert(block.waves.end(), waves.begin(), waves.end());
        block.measures.insert(block.measures.end(), measures.begin(), measures.end());
        block.trials.rows.insert(block.trials.rows.end(), trials.rows.begin(), trials.rows.end());
        block.trials.own.insert(block.trials.own.end(), trials.own.begin(), trials.own.end());
    }

    Plan const& plan_;
    StoredRows rows_;
    std::map<std::int64_t, std::int64_t> places_;
};

// What a key decides that nobody thought of would show here.
void check_against(BlockRows const& stored, store::ResultsReader const& file, CampaignSpec const& spec,
                   Plan const& plan, std::int64_t block, std::string const& output) {
    PhaseSeconds seconds;
    auto const wave = prepare_wave(spec, plan, plan.waves_of_block(block).first, seconds);
    TrialRows trials;
    (void)append_trials(spec, plan, std::span(&wave, 1), trials, seconds);
    auto const own = trials.own.size() / trials.rows.size();
    auto const one = [&](TrialRows const& all, std::size_t t) {
        auto const part = std::span(all.own).subspan(t * own, own);
        return TrialRows{{all.rows[t]}, {part.begin(), part.end()}};
    };
    for (std::size_t t = 0; t < trials.rows.size(); ++t) {
        auto const columns = differing_columns(file, spec, one(stored.trials, t), one(trials, t));
        validate(
            columns.empty(),
            "{}: wave {} has other rows in this campaign, in {} (its bodies are drawn by the number of waves, or the "
            "file is another program's). Start anew with another -o",
            output, wave.row.id, fmt::join(columns, ", "));
    }
}

}  // namespace

bool can_be_extended(std::filesystem::path const& output, CampaignInput const& input) {
    if (!std::filesystem::exists(output)) {
        return false;
    }
    store::ResultsReader const file(output);
    validate(file.text("program_version") == program_version() && file.text("sources_sha256") == sources_sha256()
                 && file.text("library_versions") == library_versions(),
             "{}: made by overturn {} with {} (rows of another program are not mixed with this one's). Start anew with "
             "another -o",
             output.string(), file.text("program_version"), file.text("library_versions"));
    auto const bars = input_of(file).differences_of_rows(input);
    validate(bars.empty(), "{}: its rows are of another campaign ({}). Undo the change, or start anew with another -o",
             output.string(), fmt::join(bars, "; "));
    return true;
}

std::int64_t take_finished_rows(std::filesystem::path const& output, CampaignSpec const& spec, Plan const& plan,
                                store::ShardFolder const& shards) {
    validate(!spec.rare, "--extend of a campaign with [rare] (its stages need all waves). Start anew with another -o");
    store::ResultsReader const file(output, store::Trust::unverified);  // can_be_extended held it to its seal
    FinishedRows const rows(file, spec, plan);
    std::vector<std::string> notes;
    auto const there = shards.committed({0, plan.blocks()}, notes,
                                        [&](std::int64_t block) { return BlockRows::packed_size(plan, block); });
    std::int64_t taken = 0;
    std::vector<store::PackedBlock> fresh;
    for (std::int64_t block = 0; block < plan.blocks(); ++block) {
        auto const found = std::ranges::binary_search(there, block) ? std::nullopt : rows.block(block);
        if (!found) {
            continue;
        }
        if (taken == 0) {
            check_against(*found, file, spec, plan, block, output.string());
        }
        fresh.push_back({block, found->pack()});
        ++taken;
        constexpr std::size_t at_once = 64;
        if (fresh.size() == at_once) {
            shards.commit(fresh);
            fresh.clear();
        }
    }
    shards.commit(fresh);
    return taken;
}

}  // namespace overturn
