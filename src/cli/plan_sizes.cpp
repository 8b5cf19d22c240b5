#include "cli/plan_sizes.hpp"

#include <optional>

#include <fmt/format.h>

#include "campaign/block_rows.hpp"
#include "core/wrapped.hpp"
#include "results/measured_trials.hpp"
#include "results/schema.hpp"
#include "results/statistics.hpp"
#include "store/results_file.hpp"
#include "store/shards.hpp"

namespace overturn::cli {
namespace {

std::string count_of_folders(std::int64_t blocks) {
    auto const folders = (blocks + store::blocks_in_a_folder - 1) / store::blocks_in_a_folder;
    return folders == 1 ? std::string("one folder") : fmt::format("{} folders", folders);
}

// Of the rows of quickstart 6.3, of others 5.6: src/store/README.md.
constexpr double times_smaller = 6;

std::string bytes_text(double bytes) {
    constexpr double giga = 1e9, mega = 1e6;
    return bytes < giga ? fmt::format("{:.2f} MB", bytes / mega) : fmt::format("{:.2f} GB", bytes / giga);
}

std::optional<double> packed_bytes(CampaignInput const& input, CampaignSpec const& spec, Plan const& plan) {
    auto const all = static_cast<double>(file_bytes(input, spec, plan));
    return plan.trials() > store::rows_of_a_chunk ? std::optional(all / times_smaller) : std::nullopt;
}

std::int64_t waves_of_curves(Plan const& plan) {
    std::int64_t const held = most_trials_held;
    return plan.trials() <= held ? plan.waves() : (held + plan.trials_per_wave() - 1) / plan.trials_per_wave();
}

// Of more trials than are held one by one, curves see the first waves only. Empty where all are seen.
std::string thinned_line(Plan const& plan) {
    auto const waves = waves_of_curves(plan);
    if (waves == plan.waves()) {
        return {};
    }
    return labelled("thinned",
                    fmt::format("intervals by waves, and curves over other measures than the levels', see the "
                                "first {} waves of {} (2 million trials); stripes see all",
                                waves, plan.waves()));
}

}  // namespace

std::int64_t file_bytes(CampaignInput const& input, CampaignSpec const& spec, Plan const& plan) {
    auto const width = [](store::TableSpec const& table) {
        std::int64_t bytes = table.numbers_rows() ? 8 : 0;
        for (auto const& column : table.columns) {
            bytes += column.type == FieldType::category ? 1 : 8;
        }
        return bytes;
    };
    constexpr std::int64_t overhead = 400'000;  // groups, attributes and statistics of a small campaign
    auto bytes = overhead + plan.trials() * width(trial_table(spec)) + plan.waves() * width(wave_table(spec));
    for (auto const& table : measure_tables(spec)) {
        bytes += plan.waves() * width(table);
    }
    for (auto const& table : extra_tables(ModelSelector(spec.effects, spec.accuracy))) {
        bytes += plan.trials() * width(table);
    }
    for (auto const& [name, content] : input.files) {
        bytes += std::ssize(content);
    }
    return bytes;
}

std::string file_text(CampaignInput const& input, CampaignSpec const& spec, Plan const& plan) {
    auto const plain = bytes_text(static_cast<double>(file_bytes(input, spec, plan)));
    auto const packed = packed_bytes(input, spec, plan);
    return packed ? fmt::format("{} (with --packed {})", plain, bytes_text(*packed)) : plain;
}

std::string scratch_line(Plan const& plan) {
    auto const bytes = static_cast<double>(BlockRows::packed_size(plan, 0));
    return labelled("scratch", fmt::format("{} block files of {} waves, {:.1f} kB each, {} in {}, deleted "
                                           "after merging",
                                           plan.blocks(), plan.block_size(), bytes / 1e3,
                                           bytes_text(bytes * static_cast<double>(plan.blocks())),
                                           count_of_folders(plan.blocks())));
}

std::string memory_lines(CampaignSpec const& spec, Plan const& plan) {
    constexpr double much = 100e6;
    double const bytes = memory_of_trials(spec, plan.trials());
    auto const memory = bytes < much ? std::string()
                                     : fmt::format(
                                         "memory    about {:.2g} GB on each rank that fits curves, and as much again "
                                         "meanwhile\n",
                                         bytes / 1e9);
    return memory + thinned_line(plan);
}

Json sizes_json(CampaignInput const& input, CampaignSpec const& spec, Plan const& plan) {
    std::size_t scratch = 0;
    for (std::int64_t block = 0; block < plan.blocks(); ++block) {
        scratch += BlockRows::packed_size(plan, block);
    }
    auto const waves = waves_of_curves(plan);
    auto const packed = packed_bytes(input, spec, plan);
    return {{"file_bytes", file_bytes(input, spec, plan)},
            {"file_bytes_packed", or_null(packed.has_value(), packed.value_or(0))},
            {"scratch_bytes", scratch},
            {"memory_bytes", memory_of_trials(spec, plan.trials())},
            {"waves_of_curves", or_null(waves < plan.waves(), waves)}};
}

}  // namespace overturn::cli
