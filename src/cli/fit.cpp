#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "campaign/version.hpp"
#include "campaign/warnings.hpp"
#include "campaign/withheld_inputs.hpp"
#include "cli/fit_json.hpp"
#include "cli/frequency_json.hpp"
#include "cli/json_values.hpp"
#include "cli/other_bits.hpp"
#include "cli/rare_json.hpp"
#include "cli/stripe_csv.hpp"
#include "cli/together_json.hpp"
#include "cli/velocity_unit.hpp"
#include "cli/verbs.hpp"
#include "core/error.hpp"
#include "core/input_files.hpp"
#include "core/print_note.hpp"
#include "results/analysis.hpp"
#include "results/analysis_table.hpp"
#include "results/fragility_schema.hpp"
#include "results/hand_check.hpp"
#include "results/hazard_frequency.hpp"
#include "results/rare_results.hpp"
#include "results/recount.hpp"
#include "results/statistics.hpp"
#include "results/stripe_table.hpp"
#include "results/telling_trials.hpp"
#include "results/together.hpp"
#include "stats/rank.hpp"

namespace overturn::cli {
namespace {

struct FitOptions {
    std::string file;
    std::string stripes;
    bool json = false;
    double beta_u = 0;
    std::optional<double> confidence;  ///< none: the campaign's, or 0.95
    double design_basis = 0;
    VelocityUnit unit;
    std::string hazard;
    std::string measures;
    Unverified unverified;
};

void check(FitOptions const& options) {
    validate(options.file.empty() != options.stripes.empty(),
             "fit: {} (one thing is fitted at a time). Name a results file or --stripes TABLE.csv",
             options.file.empty() ? "nothing to fit" : "a results file and --stripes");
    check_fit_options(options.beta_u, options.confidence);
    validate(options.design_basis >= 0 && std::isfinite(options.design_basis),
             "--design-basis: {} (must be above 0). State it in the table's unit", options.design_basis);
    validate(options.design_basis == 0 || options.file.empty(),
             "--design-basis beside a results file (its campaign names the level). Leave it out");
    validate(options.hazard.empty() || options.stripes.empty(),
             "--hazard beside --stripes (a table states no measure and no unit). Fit a results file");
    validate(options.measures.empty() || options.stripes.empty(),
             "--measures beside --stripes (a table has one). Fit a results file");
}

// Curves are fitted by the program that runs; those that the file holds may be another's.
int print_refit(FitOptions const& options, store::ResultsReader const& file, CampaignSpec const& spec,
                Statistics const& statistics) {
    if (is_of_this_program(file) && file.text("library_versions") == library_versions()) {
        return done;
    }
    constexpr double same = 1e-9;
    RefitDifference largest;
    auto const analysis = analyse(spec, statistics, {.confidence = spec.confidence});
    for (std::size_t b = 0; b < spec.bodies.size(); ++b) {
        auto const& body = spec.bodies[b].name;
        auto const look = [&](std::string_view group, std::vector<MeasuredFragility> const& fits) {
            auto const one = refit_difference(file, fmt::format("{}fragility/{}", group, body), fits);
            largest = one.relative > largest.relative ? one : largest;
        };
        look("", analysis[b].fragility);
        for (std::size_t l = 1; l < spec.limits.size(); ++l) {
            look(fmt::format("limits/{}/", spec.limits[l].name), analysis[b].limits[l - 1].fragility);
        }
    }
    bool const differs = largest.relative > same;
    print_note("overturn: {}: refitted by overturn {} (the file holds the fit of {}, {}). {}\n", options.file,
               program_identity(), maker_of(file),
               differs ? fmt::format("another one: {} differs by {:.2g}", largest.column, largest.relative)
                       : std::string("all curves equal to 1e-9"),
               differs ? "Quote either with its program" : "Either may be quoted");
    return differs ? refitted_otherwise : done;
}

// All that is told of a file, whether as JSON or as tables.
struct Fitted {
    double confidence;
    std::vector<BodyAnalysis> analysis;
    std::vector<RareBody> rare;
    std::vector<TellingTrial> telling;
    std::optional<HazardCurve> hazard = {};
    std::vector<BodyFrequency> frequencies = {};
    std::vector<HandCheck> by_hand = {};
    std::vector<TwoMeasures> pairs = {};
};

Fitted fitted(FitOptions const& options, store::ResultsReader const& file, CampaignSpec const& spec,
              Statistics const& statistics) {
    double const confidence = options.confidence.value_or(spec.confidence);
    Fitted all{.confidence = confidence,
               .analysis = analyse(spec, statistics, {.confidence = confidence, .beta_u = options.beta_u}),
               .rare = read_rare_estimates(file, spec),
               .telling = telling_trials(spec, file)};
    tell_velocities(all.analysis, options.unit.measures());
    if (!options.hazard.empty()) {
        validate(!spec.is_grid(),
                 "--hazard for waves on a grid of frequencies (no random sample: nothing happens so often a year). "
                 "Leave it out");
        InputFiles files(std::filesystem::path("."));
        all.hazard = parse_hazard(files.read(options.hazard), options.hazard, spec.levels);
        all.frequencies = frequencies_of(spec, statistics, all.analysis, *all.hazard, confidence);
    }
    all.by_hand = hand_checks(spec);
    if (!options.measures.empty()) {
        all.pairs = over_two_measures(spec, statistics, parse_measures(options.measures, spec), confidence);
    }
    return all;
}

Json levels_json(LevelSpec const& levels) {
    Json json{{"measure", levels.measure_name()},
              {"units", levels.units()},
              {"stated_unit", levels.shown_units()},
              {"stated_unit_si", levels.stated_unit_si},
              {"stated", Json::array()}};
    for (auto const& level : levels.levels) {
        json["stated"].push_back(levels.shown(level.value));
    }
    return json;
}

void print_fitted_json(Fitted const& all, CampaignSpec const& spec, Statistics const& statistics, bool changed) {
    auto json = fit_json(spec, statistics, all.analysis, all.confidence);
    json["levels"] = levels_json(spec.levels);
    json["unverified"] = changed;
    json["telling_trials"] = telling_json(spec, all.telling);
    json["hand_check"] = hand_check_json(spec, all.by_hand);
    if (!all.pairs.empty()) {
        json["two_measures"] = two_measures_json(all.pairs, all.confidence);
    }
    if (all.hazard) {
        json["frequency"] = frequency_json(all.frequencies, *all.hazard);
    }
    if (spec.rare) {
        json["rare"] = rare_json(spec, all.rare);
    }
    fmt::print("{}\n", json.dump(2));
}

void print_fitted(Fitted const& all, CampaignSpec const& spec, Statistics const& statistics, bool withheld,
                  FitOptions const& options) {
    auto const alike = warning_of_alike_waves(spec);
    auto const shared = alike.empty() ? std::string() : "  note: " + alike + "\n";
    std::string const without_records =
        all.by_hand.empty() && withheld ? "\nby hand: nothing, without the records (inputs = \"hash-only\")\n" : "";
    fmt::print("{}{}{}{}{}{}{}{}", stripe_table(spec, statistics, options.unit.measures()) + shared,
               analysis_table(all.analysis, all.confidence),
               together_table(spec, bodies_together(spec, statistics), all.confidence),
               hand_check_text(spec, all.by_hand) + without_records,
               all.pairs.empty() ? std::string() : two_measures_text(all.pairs, all.confidence),
               all.hazard ? frequency_table(spec, all.frequencies, *all.hazard, all.confidence) : std::string(),
               rare_table(spec, all.rare), telling_table(spec, all.telling, options.file));
}

int fit_file(FitOptions const& options) {
    store::ResultsReader const file(options.file, options.unverified.trust());
    auto const input = input_of(file);
    auto const spec = parse_campaign(input);
    auto const statistics = recount(file, spec);
    bool const changed = options.unverified.warn_if_changed(file, options.file);
    auto const all = fitted(options, file, spec, statistics);
    if (options.json) {
        print_fitted_json(all, spec, statistics, changed);
    } else {
        print_fitted(all, spec, statistics, has_withheld(input), options);
    }
    return print_refit(options, file, spec, statistics);
}

std::string stripes_text(std::vector<Stripe> const& stripes, double confidence) {
    auto text = fmt::format("{:>10} {:>7} {:>11} {:>7}  {:>8}  {:>20}\n", "amplitude", "trials", "overturned", "failed",
                            "P", fmt::format("{:g} % interval", 100 * confidence));
    for (auto const& stripe : stripes) {
        auto const interval = stripe.interval(confidence);
        text += fmt::format("{:>10.4g} {:>7} {:>11} {:>7}  {:>8}  [{:.6f}, {:.6f}]\n", stripe.amplitude, stripe.trials,
                            stripe.overturned, stripe.failed,
                            stripe.decided() > 0 ? fmt::format("{:.4f}", stripe.probability()) : std::string("-"),
                            interval.lower, interval.upper);
    }
    return text;
}

int fit_stripes(FitOptions const& options) {
    InputFiles files(std::filesystem::path("."));
    auto const stripes = parse_stripes(files.read(options.stripes), options.stripes);
    constexpr double usual = 0.95;
    FragilityRequest request;
    request.confidence = options.confidence.value_or(usual);
    request.beta_u = options.beta_u;
    MeasuredFragility measured;
    measured.name = "amplitude";
    measured.label = measured.name;
    measured.units = "1";
    measured.told = {measured.units};
    if (options.design_basis > 0) {
        measured.quote_base = "design-basis";
        for (double const multiple : quoted_multiples) {
            request.quotes.push_back({multiple * options.design_basis, multiple});
        }
    }
    auto const data = FragilityData::of_stripes(stripes);
    measured.fit = fit_fragility(data, request);
    measured.rank_area = rank_area(data.points);
    if (!options.json) {
        fmt::print("{}\n{}", stripes_text(stripes, request.confidence),
                   fragility_table({measured}, request.confidence));
        return done;
    }
    Json json{{"stripes", Json::array()}, {"fragility", Json::array()}, {"criterion", Json::array()}};
    for (std::size_t l = 0; l < stripes.size(); ++l) {
        json["stripes"].push_back(stripe_json("", l, stripes[l], request.confidence));
    }
    json["fragility"].push_back(fragility_json("", measured, request.confidence));
    fmt::print("{}\n", json.dump(2));
    return done;
}

}  // namespace

void add_fit(CommandLine& line) {
    auto verb = line.verb("fit", "fragility curves and the criterion on trial, from a results file or a table");
    auto options = std::make_shared<FitOptions>();
    verb.takes("file", options->file, "results file");
    verb.takes("--stripes", options->stripes, "fit a table instead: amplitude,trials,overturned (csv)");
    verb.takes("--json", options->json, "as JSON");
    verb.takes("--beta-u", options->beta_u, "lognormal standard deviation of what is not known, for HCLPF");
    verb.takes("--confidence", options->confidence, "of all intervals; default: the campaign's, or 0.95");
    verb.takes("--design-basis", options->design_basis, "with --stripes: quote P at multiples of this amplitude");
    verb.takes("--hazard", options->hazard,
               "annual frequency by this hazard curve: '<measure> [unit], annual_exceedance' (csv)");
    verb.takes("--measures", options->measures, "also fit a curve over two measures: pga,v_wes");
    options->unit.offered_by(verb);
    options->unverified.offered_by(verb);
    verb.does([options] {
        check(*options);
        return options->stripes.empty() ? fit_file(*options) : fit_stripes(*options);
    });
}

}  // namespace overturn::cli
