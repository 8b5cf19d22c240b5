#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "campaign/accepted_waves.hpp"
#include "campaign/plan.hpp"
#include "cli/json_values.hpp"
#include "cli/verbs.hpp"
#include "core/wrapped.hpp"
#include "output/failed_trials.hpp"
#include "output/status_text.hpp"
#include "output/unknown_names.hpp"
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

// What is report of a file or a run: lines for people, facts for scripts.
struct StatusReport {
    int code = done;
    std::string state;      ///< the line that says how far it is
    std::string more = {};  ///< lines behind it
    Json facts = Json::object();
};

Json counts_json(WaveCounts const& waves, std::int64_t planned) {
    return {{"done", waves.waves}, {"planned", planned}, {"refused", waves.refused}, {"failed", waves.failed}};
}

std::int64_t trials_of(CampaignSpec const& spec, std::int64_t waves) {
    return waves * std::ssize(spec.bodies) * Plan(spec).level_count();
}

bool any_failed(Statistics const& counted) {
    return std::ranges::any_of(counted.bodies(), [](BodyStatistics const& body) {
        return std::ranges::any_of(body.stripes, [](Stripe const& stripe) { return stripe.failed > 0; });
    });
}

StatusReport report_of_file(std::string const& path, Unverified const& unverified) {
    store::ResultsReader const file(path, unverified.trust());
    auto const spec = parse_campaign(input_of(file));
    bool const changed = unverified.warn_if_changed(file, path);
    auto const trials = file.length("trials/verdict");
    auto const counted = recount(file, spec, TrialsHeld::none);
    auto const waves = output::waves_text(counted.waves(), spec.source->about().acceptance, spec.confidence);
    auto const done_waves = counted.waves().waves;
    Plan const drawn(spec);
    auto const planned = spec.has_target() ? drawn.asked() : done_waves;
    StatusReport report;
    report.state = output::complete_text({.title = file.text("title"),
                                          .trials = trials,
                                          .waves = done_waves,
                                          .planned = planned,
                                          .waves_text = waves,
                                          .changed = changed});
    auto const digest = file.text("content_sha256");
    report.more = (digest.empty() ? std::string() : fmt::format("content_sha256 {}\n", digest))
                  + output::missed_clauses_text(counted.missed_clauses());
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
    std::int64_t failures = 0;
    if (any_failed(counted)) {
        each_failed(file, spec, [&](std::int64_t number, FailureReason reason) {
            TrialRow row;
            row.verdict = Verdict::failed;
            row.failure = reason;
            failed.add(number, failed.lists_more() ? read_trial(file, spec, number).rows.front() : row);
            ++failures;
        });
    }
    report.more += failed.text();
    if (auto const known = store::known_errors_of(file.integer("format_version")); !known.empty()) {
        report.more += known.substr(1) + '\n';
    }
    if (auto const unknown = output::unknown_columns_text(file, spec); !unknown.empty()) {
        report.more += wrapped(unknown);
    }
    report.facts = {{"complete", true},
                    {"edited", changed},
                    {"unknown_columns", unknown_columns(file, spec)},
                    {"content_sha256", digest},
                    {"title", file.text("title")},
                    {"waves", counts_json(counted.waves(), planned)},
                    {"trials", {{"done", trials}, {"planned", trials_of(spec, planned)}, {"failed", failures}}}};
    return report;
}

std::string so_far(CampaignSpec const& spec, Plan const& plan, store::ShardFolder const& shards,
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
    auto const text = output::waves_text(waves, acceptance, spec.confidence);
    return (text.empty() ? text : output::so_far_text(text) + '\n') + output::missed_clauses_text(missed)
           + failed.text();
}

// \param cheap blocks are known by the names of their files, unless a rule for waves asks for their rows, or all are
// there: what is damaged cannot be merged
struct Unfinished {
    Unfinished(std::string const& path, CampaignInput begun, bool cheap)
        : input(std::move(begun)),
          spec(parse_campaign(input)),
          plan(spec),
          shards(path, input.block_key()),
          waves(spec, plan),
          under_way(store::BlockLock::held(shards.folder())) {
        store::BlockRange const all{0, plan.blocks()};
        if (cheap && !waves.needs_rows()) {
            committed = shards.listed(all);
        }
        if (!cheap || waves.needs_rows() || (std::ssize(committed) == plan.blocks() && !under_way)) {
            committed = sound_blocks(shards, plan, all);
        }
    }

    CampaignInput input;
    CampaignSpec spec;
    Plan plan;
    store::ShardFolder shards;
    AcceptedWaves waves;
    bool under_way;
    std::vector<std::int64_t> committed;
};

StatusReport report_of_run(Unfinished& run, std::string const& path, std::string_view flag) {
    auto& [input, spec, plan, shards, waves, under_way, committed] = run;
    take_rows(waves, plan, shards, committed);
    auto const left = waves.wanted(plan.count());
    bool const to_merge = left.empty() && !spec.rare && flag == "--resume";
    output::Progress const progress{.done = committed.size(),
                                    .left = left.size(),
                                    .all = waves.needs_rows() ? std::optional<std::int64_t>() : plan.blocks(),
                                    .waves_left = left.empty() ? "" : plan.waves_text(left),
                                    .rare = spec.rare.has_value(),
                                    .under_way = under_way,
                                    .next = to_merge ? "overturn merge " + path : resume_command(input, path, flag)};
    std::int64_t done_waves = 0;
    for (auto const block : committed) {
        done_waves += plan.waves_of_block(block).count;
    }
    std::int64_t waves_left = 0;
    for (auto const block : left) {
        waves_left += plan.waves_of_block(block).count;
    }
    StatusReport report{.code = resumable, .state = output::progress_text(progress)};
    report.facts = {
        {"complete", false},
        {"title", spec.title},
        {"under_way", under_way},
        {"waves", {{"done", done_waves}, {"planned", plan.asked()}}},
        {"trials", {{"done", done_waves * plan.trials_per_wave()}, {"planned", trials_of(spec, plan.asked())}}},
        {"blocks",
         {{"done", progress.done}, {"left", progress.left}, {"all", progress.all ? Json(*progress.all) : Json()}}},
        {"waves_left", waves_left},
        {"waves_left_numbers", or_null(!left.empty(), progress.waves_left)},
        {"rare_left", progress.rare},
        {"next", or_null(!under_way, progress.next)}};
    return report;
}

// A file of before stays until what extends it takes its place.
std::optional<StatusReport> report_of_extension(std::string const& path, bool cheap) {
    store::ShardFolder const unnamed(path, "");
    auto const record = unnamed.exists() ? unnamed.begun_with() : std::string();
    if (record.empty()) {
        return std::nullopt;
    }
    auto larger = CampaignInput::deserialise(record);
    if (larger.serialise() == input_of(store::ResultsReader(path, store::Trust::unverified)).serialise()) {
        return std::nullopt;
    }
    Unfinished run(path, std::move(larger), cheap);
    auto report = report_of_run(run, path, "--extend");
    report.state =
        output::extension_text(run.plan.count(), run.spec.bodies.size(), run.spec.levels.levels.size(), report.state);
    return report;
}

StatusReport report_of(std::string const& path, Unverified const& unverified, bool cheap) {
    if (std::filesystem::exists(path)) {
        auto file = report_of_file(path, unverified);
        auto extension = report_of_extension(path, cheap);
        if (!extension) {
            file.facts["extension"] = nullptr;
            return file;
        }
        file.code = extension->code;
        file.more = output::before_extension_text(file.state) + '\n' + file.more;
        file.state = extension->state;
        file.facts["extension"] = std::move(extension->facts);
        return file;
    }
    Unfinished run(path, begun_campaign(path), cheap);
    auto report = report_of_run(run, path, "--resume");
    report.more = cheap ? std::string() : so_far(run.spec, run.plan, run.shards, run.committed);
    return report;
}

int status(std::string const& path, Unverified const& unverified, bool json) {
    auto const report = report_of(path, unverified, json);
    if (json) {
        Json facts{{"file", path}, {"text", report.state}};
        facts.update(report.facts);
        fmt::print("{}\n", facts.dump(2, ' ', false, Json::error_handler_t::replace));
    } else {
        fmt::print("{}", narrowed(fmt::format("{}: {}\n{}", path, report.state, report.more)));
    }
    return report.code;
}

}  // namespace

void add_status(CommandLine& line) {
    auto verb = line.verb("status", "show whether a run is complete (exit 0) or can be resumed (exit 3)");
    auto path = std::make_shared<std::string>();
    auto unverified = std::make_shared<Unverified>();
    verb.needs("file", *path, "results file");
    auto json = std::make_shared<bool>(false);
    verb.takes("--json", *json, "as JSON; blocks of an unfinished run are counted, and read where all are there");
    unverified->offered_by(verb);
    verb.does([path, unverified, json] { return status(*path, *unverified, *json); });
}

}  // namespace overturn::cli
