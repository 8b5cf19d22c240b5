#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "campaign/withheld_inputs.hpp"
#include "cli/history.hpp"
#include "cli/trial_history.hpp"
#include "cli/velocity_unit.hpp"
#include "cli/verbs.hpp"
#include "core/error.hpp"
#include "core/print_note.hpp"
#include "core/wrapped.hpp"
#include "output/json.hpp"
#include "output/made_by.hpp"
#include "output/rare_replay_text.hpp"
#include "output/row_json.hpp"
#include "output/trial_text.hpp"
#include "report/figure.hpp"
#include "results/rare_replay.hpp"
#include "results/recount.hpp"

namespace overturn::cli {
namespace {

struct ReplayOptions {
    std::string file;
    std::int64_t trial = 0;
    std::string history, plot;
    std::string rare;
    std::string limit = overturning_limit;
    VelocityUnit unit;
    Unverified unverified;
    bool json = false;
};

// \param text of what was computed, without whether it is bit-equal \param json the same, with it
int print_replay(ReplayOptions const& options, store::ResultsReader const& file,
                 std::vector<std::string> const& different, std::string const& what, std::string const& text,
                 output::Json const& json) {
    fmt::print("{}", options.json ? json.dump(2, ' ', false, output::Json::error_handler_t::replace) + "\n"
                                  : narrowed(text + output::difference_text(different)));
    if (different.empty()) {
        (void)options.unverified.warn_if_changed(file, options.file);  // the row is sound, the file is not
        return done;
    }
    print_note("overturn: {}: {} is not what this program computes {}\n", options.file, what,
               output::why_bits_differ(file));
    return other_failure;
}

int replay(ReplayOptions const& options) {
    options.unit.check();
    if (!options.plot.empty()) {
        report::check_figure_name(options.plot);
        validate(options.rare.empty(), "--plot beside --rare (only rows of /trials are drawn). Leave one of them out");
    }
    store::ResultsReader const file(options.file, options.unverified.trust());
    auto input = input_of(file);
    fetch_withheld(input, options.file);
    auto const spec = parse_campaign(input);
    if (!options.rare.empty()) {
        auto const again = replay_rare(file, spec, options.rare, options.limit, options.trial);
        return print_replay(options, file, again.different, fmt::format("row {}", options.trial),
                            output::rare_replay_text(again, options.trial, options.rare, options.limit),
                            output::rare_replay_json(again, options.trial, options.rare, options.limit));
    }
    auto const plan = plan_in(file, spec);
    auto const trials = file.length("trials/verdict");  // fewer than planned, maybe
    validate(options.trial >= 0 && options.trial < trials,
             "--trial {} (the file has trials 0 to {}). Choose one of them", options.trial, trials - 1);
    auto const stored = read_trial(file, spec, options.trial);
    auto const [wave, body, level] = plan.trial(options.trial);
    PhaseSeconds seconds;
    auto const prepared = prepare_wave(spec, plan, wave, seconds);
    std::optional<HistoryFile> history;
    if (!options.history.empty()) {
        history.emplace(options.history, spec);
    }
    Observer* const observer = history ? &*history : nullptr;
    KeptHistory kept(observer);
    auto const trial = run_trial(spec, prepared, body, level, options.plot.empty() ? observer : &kept);
    auto const& row = trial.rows.front();
    if (!options.plot.empty()) {
        auto const title = output::trial_title(spec, row, options.trial, plan.number(wave));
        MeasureSpec const* const measures = spec.measures.energy ? &spec.measures : nullptr;
        draw_history(kept, {title, spec.bodies[body], prepared.bodies[body].body, prepared.motion, row.scale, measures},
                     units_json(spec, options.unit), options.plot);
        if (measures == nullptr) {
            print_note("{}: without V_WES (the campaign states [measures] energy = false)\n", options.plot);
        }
    }
    auto const different = differing_columns(file, spec, stored, trial);
    return print_replay(options, file, different, fmt::format("trial {}", options.trial),
                        output::trial_text(spec, row, options.trial, plan.number(wave)),
                        output::replay_json({spec, trial, options.trial, plan.number(wave), different}));
}

}  // namespace

void add_replay(CommandLine& line) {
    auto verb = line.verb("replay", "recompute one trial of a results file and compare every bit");
    auto options = std::make_shared<ReplayOptions>();
    verb.needs("file", options->file, "results file");
    verb.needs("--trial", options->trial, "number of the row in /trials, from 0");
    verb.takes("--rare", options->rare, "name of a body: --trial is then a row of /rare/BODY/rows");
    verb.takes("--limit", options->limit, "with --rare: limit state");
    verb.takes("--history", options->history, "write the trial's history to this csv file");
    verb.takes("--plot", options->plot, "draw wave, rotation, energy and contact over time, .svg, .png or .pdf");
    options->unit.offered_by(verb);
    verb.takes("--json", options->json, "as JSON: all columns of the row, in SI and in the units of the campaign");
    options->unverified.offered_by(verb);
    verb.does([options] { return replay(*options); });
}

}  // namespace overturn::cli
