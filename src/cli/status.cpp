#include <algorithm>
#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "campaign/accepted_waves.hpp"
#include "campaign/plan.hpp"
#include "cli/verbs.hpp"
#include "output/failed_trials.hpp"
#include "output/status_text.hpp"
#include "output/waves_text.hpp"
#include "results/missed_clauses.hpp"
#include "results/recount.hpp"
#include "results/statistics.hpp"
#include "results/stored_names.hpp"
#include "runner/merge.hpp"
#include "runner/output_place.hpp"
#include "store/format_versions.hpp"
#include "store/results_file.hpp"
#include "store/shards.hpp"

namespace overturn::cli {
namespace {

int status_of_file(std::string const& path, Unverified const& unverified) {
    store::ResultsReader const file(path, unverified.trust());
    auto const spec = parse_campaign(input_of(file));
    bool const changed = unverified.warn_if_changed(file, path);
    auto const verdicts = stored_verdicts(file);
    auto const counted = recount(file, spec);
    auto const waves = output::waves_text(counted.waves(), spec.source->about().acceptance, spec.confidence);
    auto const done_waves = counted.waves().waves;
    Plan const drawn(spec);
    auto const planned = spec.has_target() ? drawn.asked() : done_waves;
    fmt::print("{}: {}\n", path,
               output::complete_text({.title = file.text("title"),
                                      .trials = std::ssize(verdicts),
                                      .waves = done_waves,
                                      .planned = planned,
                                      .waves_text = waves,
                                      .changed = changed}));
    fmt::print("{}", output::missed_clauses_text(counted.missed_clauses()));
    auto const reasons =
        file.has("trials/failure")
            ? file.named("trials/failure", field_named(fields_of<TrialRow>(), "failure").categories)
            : std::vector<std::int64_t>(verdicts.size(), static_cast<std::int64_t>(FailureReason::none));
    output::FailedTrials failed(spec);
    auto const ids = file.integers("waves/id");
    bool const judged = spec.measures.wave_quality && file.has("waves/acceptance_failures");
    auto const clauses = judged ? file.integers("waves/acceptance_failures") : std::vector<std::int64_t>(ids.size());
    for (std::size_t i = 0; i < ids.size(); ++i) {
        WaveRow row;
        row.id = ids[i];
        row.acceptance_failures = clauses.at(i);
        failed.know(row);
    }
    for (std::size_t i = 0; i < verdicts.size(); ++i) {
        if (verdicts[i] == Verdict::failed) {
            TrialRow row;
            row.verdict = Verdict::failed;
            row.failure = static_cast<FailureReason>(reasons.at(i));
            std::int64_t const number = i;
            failed.add(number, failed.lists_more() ? read_trial(file, spec, number).rows.front() : row);
        }
    }
    fmt::print("{}", failed.text());
    if (auto const known = store::known_errors_of(file.integer("format_version")); !known.empty()) {
        fmt::print("{}\n", known.substr(1));
    }
    return done;
}

void print_so_far(CampaignSpec const& spec, Plan const& plan, store::ShardFolder const& shards,
                  std::vector<std::int64_t> const& committed) {
    WaveCounts waves;
    MissedClauses missed;
    output::FailedTrials failed(spec);
    auto const acceptance = spec.source->about().acceptance;
    auto const each = plan.trials_per_wave();
    for (auto const block : committed) {
        auto const [first, count] = plan.waves_of_block(block);
        auto const rows = BlockRows::unpack(shards.read(block), plan, count);
        for (std::int64_t w = 0; w < count; ++w) {
            auto const& row = rows.waves[w];
            if (!is_tried(acceptance, row)) {
                ++waves.refused;
                missed.add(row);
                continue;
            }
            waves.add(row);
            failed.know(row);
            for (auto t = w * each; t < (w + 1) * each; ++t) {
                failed.add(first * each + t, rows.trials.rows[t]);
            }
        }
    }
    if (auto const text = output::waves_text(waves, acceptance, spec.confidence); !text.empty()) {
        fmt::print("{}\n", output::so_far_text(text));
    }
    fmt::print("{}{}", output::missed_clauses_text(missed), failed.text());
}

// A file of before stays until what extends it takes its place.
int status_of_extension(std::string const& path) {
    store::ShardFolder const unnamed(path, "");
    auto const record = unnamed.exists() ? unnamed.begun_with() : std::string();
    if (record.empty()) {
        return done;
    }
    auto const larger = CampaignInput::deserialise(record);
    if (larger.serialise() == input_of(store::ResultsReader(path, store::Trust::unverified)).serialise()) {
        return done;
    }
    Plan const plan(parse_campaign(larger));
    store::ShardFolder const shards(path, larger.block_key());
    auto const committed = sound_blocks(shards, plan, {0, plan.blocks()});
    bool const under_way = store::Claim::held(shards.folder());
    if (committed.empty() && !under_way) {  // begun and refused, or killed before its first block
        return done;
    }
    fmt::print("{}\n", output::extension_text(plan.count(), committed.size(),
                                              under_way ? "" : resume_command(larger, path, "--extend")));
    return resumable;
}

int status(std::string const& path, Unverified const& unverified) {
    if (std::filesystem::exists(path)) {
        int const whole = status_of_file(path, unverified);
        return whole == done ? status_of_extension(path) : whole;
    }
    store::ShardFolder const unnamed(path, "");
    require_begun(unnamed, path);
    auto const input = CampaignInput::deserialise(unnamed.begun_with());
    auto const spec = parse_campaign(input);
    Plan const plan(spec);
    require_same_program(input, path);
    store::ShardFolder const shards(path, input.block_key());
    auto const committed = sound_blocks(shards, plan, {0, plan.blocks()});
    print_so_far(spec, plan, shards, committed);
    AcceptedWaves waves(spec, plan);
    take_rows(waves, plan, shards, committed);
    auto const left = waves.wanted(plan.count());
    bool const to_merge = left.empty() && !spec.rare;
    fmt::print("{}: {}\n", path,
               output::progress_text({.done = committed.size(),
                                      .left = left.size(),
                                      .all = waves.needs_rows() ? std::optional<std::int64_t>() : plan.blocks(),
                                      .waves_left = left.empty() ? "" : plan.waves_text(left),
                                      .rare = spec.rare.has_value(),
                                      .under_way = store::Claim::held(shards.folder()),
                                      .next = to_merge ? "overturn merge " + path : resume_command(input, path)}));
    return resumable;
}

}  // namespace

void add_status(CommandLine& line) {
    auto verb = line.verb("status", "is a run complete? exit 0: yes, 3: resumable");
    auto path = std::make_shared<std::string>();
    auto unverified = std::make_shared<Unverified>();
    verb.needs("file", *path, "results file");
    unverified->offered_by(verb);
    verb.does([path, unverified] { return status(*path, *unverified); });
}

}  // namespace overturn::cli
