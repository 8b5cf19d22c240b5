#include "output/write_results.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include <fmt/ranges.h>

#include "campaign/accepted_waves.hpp"
#include "campaign/block_rows.hpp"
#include "campaign/version.hpp"
#include "campaign/withheld_inputs.hpp"
#include "output/campaign_tables.hpp"
#include "output/results_tables.hpp"
#include "results/rare_results.hpp"
#include "results/schema.hpp"

namespace overturn {
namespace {

void write_campaign(store::ResultsWriter& file, CampaignInput const& input, CampaignSpec const& spec) {
    write_provenance(file, store::format_name, store::format_version, input, spec.title);
    file.attribute("seed", spec.seed);
    file.attribute("level_measure", spec.levels.measure_name());
    file.attribute("level_units", spec.levels.units());
    file.attribute("wave_source", spec.source->text());
    file.attribute("variability", spec.source->about().variability);
    file.attribute("wave_acceptance", spec.source->about().acceptance.rule);
    auto const kept = kept_inputs(input);
    for (auto const& [name, content] : kept) {
        // Names hold '/', which HDF5 reads as a path; the number is the place, the attribute the name.
        auto const place = fmt::format("{:04}", std::distance(kept.begin(), kept.find(name)));
        file.bytes("inputs", place, name, content);
    }
}

// HDF5 lists groups by name, so each body's says which in the campaign's order it is of.
void number_bodies(store::ResultsWriter& file, CampaignSpec const& spec) {
    for (std::size_t b = 0; b < spec.bodies.size(); ++b) {
        for (auto const& group : file.groups()) {
            if (group.ends_with("/" + spec.bodies[b].name) && !group.starts_with("trials/")) {
                file.attribute(group, "index", static_cast<std::int64_t>(b));
            }
        }
    }
}

// The tables of rows, by their numbers in the file. They come first, in this order.
struct RowTables {
    std::size_t waves = 0, trials = 0;
    std::vector<std::size_t> measures, own;

    // \param add table and whether its rows are trials -> number
    template <class Add> RowTables(CampaignSpec const& spec, Add&& add) {
        waves = add(wave_table(spec), false);
        for (auto& table : measure_tables(spec)) {
            if (!table.columns.empty()) {
                measures.push_back(add(std::move(table), false));
            }
        }
        trials = add(trial_table(spec), true);
        for (auto& table : extra_tables(ModelSelector(spec.effects, spec.accuracy))) {
            own.push_back(add(std::move(table), true));
        }
    }

    // put(table, whether its rows are trials, bytes)
    template <class Put> void each(BlockRows const& rows, Put&& put) const {
        put(waves, false, std::as_bytes(std::span(rows.waves)));
        for (auto const table : measures) {
            put(table, false, std::as_bytes(std::span(rows.measures)));
        }
        put(trials, true, std::as_bytes(std::span(rows.trials.rows)));
        for (auto const table : own) {
            put(table, true, std::span<std::byte const>(rows.trials.extra));
        }
    }
};

// The first waves that hold the trials of curves, and some that pass by where there are more.
std::int64_t waves_to_hold(Plan const& plan) {
    return static_cast<std::int64_t>(most_trials_held) / plan.trials_per_wave() + 2;
}

}  // namespace

Statistics write_rows_in_place(CampaignSpec const& spec, Plan const& drawn, store::BlockRange blocks,
                               std::function<std::vector<std::byte>(std::int64_t)> const& block,
                               store::RowPlaces const& places) {
    std::size_t count = 0;
    RowTables const tables(spec, [&](store::TableSpec const& /*table*/, bool /*trials*/) { return count++; });
    store::PlacedRows file(places);
    Statistics held(spec), counted(spec, TrialsHeld::none);
    for (auto b = blocks.first; b < blocks.last; ++b) {
        auto const waves = drawn.waves_of_block(b);
        auto const rows = BlockRows::unpack(block(b), drawn, waves.count);
        tables.each(rows, [&](std::size_t table, bool trials, std::span<std::byte const> bytes) {
            file.write(table, trials ? waves.first * drawn.trials_per_wave() : waves.first, bytes);
        });
        (waves.first < waves_to_hold(drawn) ? held : counted).add(rows);
    }
    file.finish();
    held.add_counts(counted.counts());
    return held;
}

void write_provenance(store::ResultsWriter& file, std::string const& format, std::int64_t version,
                      CampaignInput const& input, std::string const& title) {
    file.attribute("format", format);
    file.attribute("format_version", version);
    file.attribute("program_version", program_version());
    file.attribute("git_revision", git_revision());
    file.attribute("sources_sha256", sources_sha256());
    file.attribute("library_versions", library_versions());
    file.attribute("title", title);
    file.attribute("campaign", input.text);
    file.attribute("campaign_name", std::filesystem::path(input.name).filename().string());
    file.attribute("settings", fmt::format("{}", fmt::join(input.settings, "\n")));
    file.attribute("input_sha256", input.sha256());
}

std::vector<BodyAnalysis> write_results(std::filesystem::path const& path, CampaignInput const& input,
                                        CampaignSpec const& spec, Plan const& drawn, Plan const& chosen,
                                        std::function<std::vector<std::byte>(std::int64_t)> const& block,
                                        Statistics& statistics, std::span<RareBody const> rare, store::Layout layout,
                                        WritingHelp const& help) {
    store::ResultsWriter file(path, layout);
    write_campaign(file, input, spec);
    RowTables const tables(spec, [&](store::TableSpec table, bool trials) {
        return file.table(std::move(table), trials ? chosen.trials() : chosen.waves());
    });
    std::vector<WaveRow> refused;
    if (help.rows) {
        help.rows(file.give_places(), chosen, statistics);
    } else {
        for (auto const b : blocks_of_chosen(drawn, chosen)) {
            auto all = BlockRows::unpack(block(b), drawn, drawn.waves_of_block(b).count);
            std::ranges::copy(refused_rows(all, drawn, b, chosen), std::back_inserter(refused));
            auto const rows = rows_of_chosen(std::move(all), drawn, b, chosen);
            tables.each(rows, [&](std::size_t table, bool /*trials*/, std::span<std::byte const> bytes) {
                file.append(table, bytes);
            });
            statistics.add(rows);
        }
    }
    if (spec.source->about().acceptance.refuses()) {
        file.append(file.table(refused_wave_table(spec), refused.size()), std::as_bytes(std::span(refused)));
    }
    for (auto const& row : refused) {
        statistics.add_refused(row);
    }
    if (spec.has_target()) {
        file.attribute("waves_planned", drawn.count());
        file.attribute("precise_enough", std::int64_t{chosen.chosen_per_group() < drawn.count() ? 1 : 0});
    }
    auto analysis = analyse(spec, statistics, {.confidence = spec.confidence}, help.curves);
    output::write_tables(file, output::campaign_tables(spec, statistics, analysis, spec.confidence));
    output::write_tables(file, output::rare_tables(spec, rare));
    write_rare_record(file, spec, rare);
    number_bodies(file, spec);
    file.attribute("complete", std::int64_t{1});
    file.finish(help.hash ? help.hash : store::hash_stretches);
    return analysis;
}

}  // namespace overturn
