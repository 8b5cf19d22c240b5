#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <optional>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "campaign/typed_units.hpp"
#include "campaign/version.hpp"
#include "campaign/warnings.hpp"
#include "campaign/withheld_inputs.hpp"
#include "cli/assumptions_text.hpp"
#include "cli/campaign_hazard.hpp"
#include "cli/fit_options.hpp"
#include "cli/fit_tables.hpp"
#include "cli/text_choice.hpp"
#include "cli/verbs.hpp"
#include "core/error.hpp"
#include "core/print_note.hpp"
#include "core/wrapped.hpp"
#include "output/campaign_tables.hpp"
#include "output/curve_tables.hpp"
#include "output/fit_json.hpp"
#include "output/made_by.hpp"
#include "output/results_tables.hpp"
#include "output/sections.hpp"
#include "output/status_text.hpp"
#include "output/typed_columns.hpp"
#include "output/unknown_names.hpp"
#include "results/analysis.hpp"
#include "results/few_waves.hpp"
#include "results/hand_check.hpp"
#include "results/hazard_frequency.hpp"
#include "results/rare_results.hpp"
#include "results/recount.hpp"
#include "results/statistics.hpp"
#include "results/stored_names.hpp"
#include "results/telling_trials.hpp"
#include "results/together.hpp"
#include "runner/interim.hpp"

namespace overturn::cli {
namespace {

void check(FitOptions const& options) {
    auto const things = (options.file.empty() ? 0 : 1) + (options.stripes.empty() ? 0 : 1)
                        + (options.capacities.empty() ? 0 : 1) + (options.median.empty() ? 0 : 1);
    validate(things == 1,
             "fit: {} (one thing is fitted at a time). Name a results file, --stripes TABLE.csv, --capacities "
             "TABLE.csv, or --median and --beta",
             things == 0 ? "nothing to fit" : "several of a results file, --stripes, --capacities and --median");
    check_fit_options(options.beta_u, options.confidence);
    validate(options.design_basis.empty() || options.file.empty(),
             "--design-basis beside a results file (its campaign names the level). Leave it out");
    validate(options.design_basis.empty() || !options.stripes.empty(),
             "--design-basis without --stripes (used with --stripes only). Leave it out");
    validate(!options.waves || !options.stripes.empty(),
             "--waves without --stripes (used with --stripes only). Leave it out");
    validate(options.measures.empty() || !options.file.empty(),
             "--measures without a results file (a table or a given curve has one measure). Fit a results file");
    validate(!options.interim || !options.file.empty(),
             "--interim without a results file (it is of an unfinished run). Name the file that the run is to write");
    validate(options.beta.has_value() == !options.median.empty(),
             "--{} without --{} (a curve is both). State it, for example --median '0.9 g' --beta 0.4",
             options.beta ? "beta" : "median", options.beta ? "median" : "beta");
}

// Curves are fitted by the program that runs; those that the file holds may be another's.
// \param fitted with the campaign's own settings, or null
int print_refit(FitOptions const& options, store::ResultsReader const& file, CampaignSpec const& spec,
                Statistics const& statistics, std::vector<BodyAnalysis> const* fitted) {
    if (output::is_of_this_program(file) && file.text("library_versions") == library_versions()) {
        return done;
    }
    constexpr double same = 1e-9;
    output::Difference largest;
    auto const anew =
        fitted == nullptr ? analyse(spec, statistics, {.confidence = spec.confidence}) : std::vector<BodyAnalysis>{};
    auto const& analysis = fitted == nullptr ? anew : *fitted;
    for (std::size_t b = 0; b < spec.bodies.size(); ++b) {
        auto const& body = spec.bodies[b].name;
        for (std::size_t l = 0; l < spec.limits.size(); ++l) {
            auto const table =
                output::curve_table({body, spec.limits[l].name, spec.confidence}, analysis[b].curves_of(l));
            auto const one = output::difference(file, table, "measure");
            largest = one.relative > largest.relative ? one : largest;
        }
    }
    bool const differs = largest.relative > same;
    print_note("overturn: {}: refitted by overturn {} (the file holds the fit of {}, {}). {}\n", options.file,
               program_identity(), output::maker_of(file),
               differs ? fmt::format("another one: {} differs by {:.2g}", largest.column, largest.relative)
                       : std::string("all curves equal to 1e-9"),
               differs ? "Quote either with its program" : "Either may be quoted");
    return differs ? refitted_otherwise : done;
}

// All output on a file, as JSON or as tables.
struct Fitted {
    double confidence;
    bool beta_u_of_campaign;
    std::vector<BodyAnalysis> analysis;
    std::vector<RareBody> rare;
    std::vector<TellingTrial> telling = {};
    std::optional<HazardCurve> hazard = {};
    std::vector<BodyFrequency> frequencies = {};
    std::vector<HandCheck> by_hand = {};
    std::vector<TwoMeasures> pairs = {};
    std::vector<TrialRow> few = {};
};

// \param file null: there is none yet, and what needs its rows is left out
Fitted fitted(FitOptions const& options, output::TextOptions const& text, store::ResultsReader const* file,
              CampaignInput const& input, CampaignSpec const& spec, Statistics const& statistics) {
    double const confidence = options.confidence.value_or(spec.confidence);
    Fitted all{.confidence = confidence,
               .beta_u_of_campaign = !options.beta_u,
               .analysis = analyse(spec, statistics, {.confidence = confidence, .beta_u = options.beta_u}),
               .rare = file == nullptr ? std::vector<RareBody>{} : read_rare_estimates(*file, spec)};
    tell_velocities(all.analysis, text.velocities ? text.velocities : typed_unit(spec, Dimension::velocity));
    all.hazard = hazard_of_campaign(options.hazard, input, spec);
    if (all.hazard) {
        all.frequencies = frequencies_of(spec, statistics, all.analysis, *all.hazard, confidence);
    }
    if (file != nullptr) {
        all.few = trials_of_few_waves(spec, *file);
        if (options.json || text.wants("trials")) {
            all.telling = telling_trials(spec, *file);
        }
    }
    if (options.json || text.wants("hand") || has_withheld(input)) {  // it makes waves
        all.by_hand = hand_checks(spec);
        compare(all.by_hand, statistics, all.analysis);
    }
    if (!options.measures.empty()) {
        all.pairs = over_two_measures(spec, statistics, parse_measures(options.measures, spec), confidence);
    }
    return all;
}

output::Printed printed_of(Fitted const& all, CampaignSpec const& spec, Statistics const& statistics) {
    return {.answered = {.spec = spec,
                         .statistics = statistics,
                         .analysis = all.analysis,
                         .confidence = all.confidence,
                         .frequencies = all.frequencies,
                         .beta_u_of_campaign = all.beta_u_of_campaign,
                         .rare = all.rare},
            .few = all.few,
            .telling = all.telling,
            .by_hand = all.by_hand,
            .pairs = all.pairs,
            .hazard = all.hazard ? &*all.hazard : nullptr};
}

output::Json levels_json(LevelSpec const& levels) {
    output::Json json{{"measure", levels.measure_name()},
                      {"units", levels.units()},
                      {"stated_unit", levels.shown_units()},
                      {"stated_unit_si", levels.stated_unit_si},
                      {"stated", output::Json::array()}};
    for (auto const& level : levels.levels) {
        json["stated"].push_back(levels.shown(level.value));
    }
    return json;
}

// \param interim how far the run is; null: it is complete
void print_fitted_json(Fitted const& all, CampaignSpec const& spec, Statistics const& statistics, bool changed,
                       std::vector<std::string> const& unknown, output::Json const& interim = nullptr) {
    auto json = output::fit_json(spec, statistics, all.analysis, all.confidence);
    json["assumptions"] = assumptions_json(spec);
    json["levels"] = levels_json(spec.levels);
    json["unverified"] = changed;
    json["unknown_columns"] = unknown;
    json["interim"] = interim;
    auto tables = output::json_tables(printed_of(all, spec, statistics));
    if (all.hazard) {
        json["hazard_notes"] = all.hazard->remarks();
    }
    if (spec.rare && interim.is_null()) {
        std::ranges::move(output::rare_tables(spec, all.rare), std::back_inserter(tables));
    }
    output::give_typed_units(tables, spec);
    json.update(output::json_of(tables));
    fmt::print("{}\n", json.dump(2));
}

void print_fitted(Fitted const& all, CampaignSpec const& spec, Statistics const& statistics, bool withheld,
                  std::string const& file, output::TextOptions const& text) {
    auto printed = printed_of(all, spec, statistics);
    auto const shared = warning_of_shared_draws(spec);
    printed.notes = shared.empty() ? std::string() : wrapped("note: " + shared, 4);
    if (all.by_hand.empty() && withheld) {
        printed.notes += "note: no hand calculation without the records (inputs = \"hash-only\")\n";
    }
    printed.file = file;
    fmt::print("{}", output::results_text(printed, text));
}

int fit_file(FitOptions const& options) {
    auto const text = options.text.options();
    store::ResultsReader const file(options.file, options.unverified.trust());
    auto const input = input_of(file);
    auto const spec = parse_campaign(input);
    auto const statistics = recount(file, spec);
    bool const changed = options.unverified.warn_if_changed(file, options.file);
    bool const withheld = has_withheld(input);
    auto const all = fitted(options, text, &file, input, spec, statistics);
    if (options.json) {
        print_fitted_json(all, spec, statistics, changed, unknown_columns(file, spec));
    } else {
        print_fitted(all, spec, statistics, withheld, options.file, text);
        if (auto const unknown = output::unknown_columns_text(file, spec); !unknown.empty()) {
            print_note("overturn: {}: {} (another program wrote them)\n", options.file, unknown);
        }
    }
    bool const own = all.confidence == spec.confidence && !options.beta_u;
    return print_refit(options, file, spec, statistics, own ? &all.analysis : nullptr);
}

// Nothing where the run has finished, before or while its blocks were read.
std::optional<Interim> unfinished(std::string const& file) {
    if (is_finished(file)) {
        return std::nullopt;
    }
    try {
        return interim_results(file);
    } catch (std::runtime_error const&) {
        if (is_finished(file)) {
            return std::nullopt;
        }
        throw;
    }
}

// Of what an unfinished run has committed: marked as such, whatever is printed.
int fit_interim(FitOptions const& options) {
    auto const found = unfinished(options.file);
    if (!found) {
        return fit_file(options);
    }
    auto const& now = *found;
    auto const text = options.text.options();
    validate(!text.names("trials"), "--section trials of an unfinished run (its rows lie in blocks). Leave it out");
    auto const& spec = *now.spec;
    auto const all = fitted(options, text, nullptr, now.input, spec, now.statistics);
    if (options.json) {
        print_fitted_json(all, spec, now.statistics, false, {},
                          {{"waves", now.waves},
                           {"planned", now.planned},
                           {"blocks", now.blocks},
                           {"all_blocks", now.all_blocks ? output::Json(*now.all_blocks) : output::Json()}});
        return done;
    }
    auto const line = output::interim_text(now.waves, now.planned);
    fmt::print("{}", line);
    print_fitted(all, spec, now.statistics, has_withheld(now.input), options.file + " --interim", text);
    fmt::print("{}", line);
    return done;
}

}  // namespace

void add_fit(CommandLine& line) {
    auto verb = line.verb("fit", "answer of a results file or table: P, curves, HCLPF, criterion");
    auto options = std::make_shared<FitOptions>();
    verb.takes("file", options->file, "results file");
    verb.takes("--stripes", options->stripes, "fit a table of counts instead: amplitude,trials,overturned (csv)");
    verb.takes(
        "--capacities", options->capacities,
        "fit capacities from incremental dynamic analysis instead, one row per wave: 'pga [g], collapsed' (csv)");
    verb.takes("--median", options->median, "use a given curve instead: its median with unit, '0.9 g'");
    verb.takes("--beta", options->beta, "lognormal standard deviation of the given curve; with --beta-u: its beta_R");
    verb.takes("--json", options->json, "as JSON");
    verb.takes("--interim", options->interim,
               "fit an unfinished run: the waves that are done so far; the file once it is there");
    verb.takes(
        "--beta-u", options->beta_u,
        "beta_U for HCLPF: lognormal standard deviation of the median from uncertain properties of the body; default: "
        "that of the campaign");
    verb.takes("--confidence", options->confidence,
               "confidence level of all intervals; default: that of the campaign, or 0.95");
    verb.takes("--design-basis", options->design_basis,
               "with --stripes: show P at multiples of this amplitude, '0.3 g'");
    verb.takes("--waves", options->waves,
               "with --stripes, where no column names the waves: how many different ones the table has in all");
    verb.takes("--hazard", options->hazard,
               "hazard curve for annual frequencies: '<measure> [unit], annual_exceedance' (csv); default: that of the "
               "campaign");
    verb.takes("--measures", options->measures, "also fit a curve over two measures: pga,v_wes");
    options->text.offered_by(verb);
    options->unverified.offered_by(verb);
    verb.does([options] {
        check(*options);
        return !options->median.empty()       ? fit_stated(*options)
               : !options->capacities.empty() ? fit_capacities(*options)
               : !options->stripes.empty()    ? fit_stripes(*options)
               : options->interim             ? fit_interim(*options)
                                              : fit_file(*options);
    });
}

}  // namespace overturn::cli
