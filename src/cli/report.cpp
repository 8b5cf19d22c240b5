#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "campaign/warnings.hpp"
#include "campaign/withheld_inputs.hpp"
#include "cli/assumptions_text.hpp"
#include "cli/campaign_hazard.hpp"
#include "cli/figures.hpp"
#include "cli/fit_options.hpp"
#include "cli/json_values.hpp"
#include "cli/named_files.hpp"
#include "cli/outcome_report.hpp"
#include "cli/plan_bodies.hpp"
#include "cli/rare_waves_json.hpp"
#include "cli/report_checks.hpp"
#include "cli/report_cost.hpp"
#include "cli/shown_trials.hpp"
#include "cli/spectra_of_waves.hpp"
#include "cli/velocity_unit.hpp"
#include "cli/verbs.hpp"
#include "core/print_note.hpp"
#include "output/answer.hpp"
#include "output/campaign_tables.hpp"
#include "output/fit_json.hpp"
#include "output/package_text.hpp"
#include "output/page_facts.hpp"
#include "output/page_text.hpp"
#include "output/records_table.hpp"
#include "output/summary_tables.hpp"
#include "output/unknown_names.hpp"
#include "output/waves_text.hpp"
#include "report/figure.hpp"
#include "response/registry.hpp"
#include "results/analysis.hpp"
#include "results/few_waves.hpp"
#include "results/measured_trials.hpp"
#include "results/rare_results.hpp"
#include "results/recount.hpp"
#include "results/telling_trials.hpp"
#include "stats/quantile.hpp"
#include "store/durable.hpp"

namespace overturn::cli {
namespace {

namespace fs = std::filesystem;

struct ReportOptions {
    std::string file, page, figures, outcomes, hazard, date;
    std::vector<std::string> records;
    std::optional<double> beta_u;  ///< none: the campaign's
    VelocityUnit unit;
    std::optional<double> confidence;  ///< none: the campaign's
    Unverified unverified;
};

// The first wave, and the one that overturned anything at the lowest level: usually the ones to look at.
std::vector<std::int64_t> telling_waves(store::ResultsReader const& file, CampaignSpec const& spec, Plan const& plan) {
    constexpr std::array<std::string_view, 1> columns{"verdict"};
    std::vector<std::int64_t> waves{0};
    std::int64_t lowest = 0;
    std::optional<std::int64_t> worst;
    each_trial(file, spec, columns, {}, [&](std::int64_t number, TrialRow const& row) {
        auto const trial = plan.trial(number);
        if (entry_of(row.verdict).fell && (!worst || trial.level < lowest)) {
            worst = trial.wave;
            lowest = trial.level;
        }
    });
    if (worst && *worst != 0) {
        waves.push_back(*worst);
    }
    return waves;
}

Json waves_of(CampaignInput const& input, CampaignSpec const& spec, Plan const& plan,
              store::ResultsReader const& file) {
    auto figures = Json::array();
    for (auto const wave : telling_waves(file, spec, plan)) {
        try {
            auto const made = spec.source->make(spec.seed, plan.wave_id(wave));
            auto figure = campaign_wave_figure(input, spec, made);
            figure.title = output::wave_title(plan.number(wave), wave != 0);
            figures.push_back(report::wave_data(figure));
        } catch (InputError const&) {
            continue;  // a wave that cannot be made is a failed row, and counted as such
        }
    }
    return figures;
}

// Enough of them for their 16 % and 84 % to be seen, few enough not to be waited for.
Json spectra_of(CampaignInput const& input, CampaignSpec const& spec) {
    constexpr std::int64_t most = 50;
    constexpr double paper_damping = 0.1;
    if (spec.wave_count < 2) {
        return nullptr;
    }
    try {
        return spectra_json(spec, spectra_of_waves(input, spec, most, paper_damping));
    } catch (InputError const&) {
        return nullptr;  // none of them can be made: failed rows
    }
}

// JSON is UTF-8, names of files are any bytes.
std::string hexadecimal(std::string_view bytes) {
    std::string text;
    for (char const c : bytes) {
        text += fmt::format("{:02x}", static_cast<unsigned char>(c));
    }
    return text;
}

// Before any work: is there a place for page and figures?
void check_places(ReportOptions const& options) {
    require_page(options.page);
    if (!options.figures.empty()) {
        std::error_code error;
        fs::create_directories(options.figures, error);
        validate(fs::is_directory(options.figures), "--figures {} (is no folder and cannot be one). Name another",
                 options.figures);
        store::require_writable(fs::path(options.figures) / "fragility.svg");
    }
}

// What the page says of the waves in words.
Json notes_of(CampaignSpec const& spec, Statistics const& statistics, store::ResultsReader const& file) {
    auto notes = Json::array();
    if (auto const unknown = output::unknown_columns_text(file, spec); !unknown.empty()) {
        notes.push_back("Warning: " + unknown + ".");
    }
    if (auto const note = output::waves_text(statistics.waves(), spec.source->about().acceptance, spec.confidence);
        !note.empty()) {
        notes.push_back(note);
    }
    for (auto const& line : ends_of_records(spec)) {
        notes.push_back("Record " + line + ".");
    }
    for (auto const& line : warnings_of(spec)) {
        notes.push_back("Warning: " + line + ".");
    }
    return notes;
}

// Of more trials than are held for curves, figures show those of the first waves, where each wave meets all levels.
std::optional<std::int64_t> waves_shown(CampaignSpec const& spec, Plan const& plan) {
    std::int64_t const held = most_trials_held;
    if (plan.trials() <= held || spec.levels.independent_waves || spec.is_grid()) {
        return std::nullopt;
    }
    return std::max<std::int64_t>(1, held / plan.trials_per_wave());
}

// Every sentence of it.
void add_words(output::Answered const& of, Json& data) {
    data["headlines"] = output::headlines(of);
    data["quote_remarks"] = output::quote_remarks(of);
    data["low_points"] = output::low_points(of);
    data["cut_short"] = output::cut_short_lines(of);
    data["notes"] = output::page_notes(of);
    data["fewest_values"] = {
        {"median", fewest_for_quantile(0.5)}, {"p84", fewest_for_quantile(0.84)}, {"p95", fewest_for_quantile(0.95)}};
    auto const& levels = of.spec.levels;
    data["levels_unit"] = {{"symbol", levels.shown_units()}, {"si", 1 / levels.shown(1)}};
}

Json answer_of(output::Answered const& of) {
    constexpr std::size_t most_rows = 60;
    auto const sheet = output::answer_sheet(of, most_rows);
    return {{"title", sheet.title},
            {"head", sheet.head},
            {"rows", sheet.rows},
            {"left_out", sheet.left_out},
            {"depends", sheet.dependence}};
}

void add_rare(store::ResultsReader const& file, CampaignSpec const& spec, std::span<RareBody const> rare, Json& data) {
    data["rare"] = Json::object();
    if (spec.rare) {
        data["fit"].update(output::json_of(output::rare_tables(spec, rare)));
        for (std::size_t b = 0; b < spec.bodies.size(); ++b) {
            data["rare"][spec.bodies[b].name] = rare_waves_json(rare_waves(file, spec, b));
        }
    }
}

// What holds of the page whatever the trials did.
Json begun(ReportOptions const& options, CampaignSpec const& spec) {
    Json data;
    data["file"] = hexadecimal(fs::absolute(options.file).string());
    data["figures"] = options.figures.empty() ? "" : hexadecimal(fs::absolute(options.figures).string());
    data["parts"] = output::outlines_of(spec);
    data["placements"] = output::placements_of(spec);
    data["supports"] = supports_of(spec);
    data["units"] = units_json(spec, options.unit);
    return data;
}

void add_stated_facts(ReportOptions const& options, CampaignSpec const& spec, double confidence, Json& data) {
    data["confidence"] = confidence;
    data["method"].push_back({"confidence", fmt::format("{:g} %", 100 * confidence)});
    if (double const beta_u = options.beta_u.value_or(spec.beta_u); beta_u > 0) {
        data["facts"].push_back({"beta_U as stated", fmt::format("{:g}", beta_u)});
    }
}

void add_cover(ReportOptions const& options, CampaignSpec const& spec, Json& data) {
    data["cover"] = {{"question", output::question_text(spec)},
                     {"date", options.date},
                     {"revision", spec.cover.revision},
                     {"signatures", output::signatures(spec.cover)}};
    data["method_lines"] = output::method_lines(spec);
}

int write_report(ReportOptions const& options) {
    check_places(options);
    check_fit_options(options.beta_u, options.confidence);
    auto const checks = read_check_records(options.records);
    options.unit.check();
    store::ResultsReader const file(options.file, options.unverified.trust());
    auto input = input_of(file);
    fetch_withheld(input, options.file);
    auto const spec = parse_campaign(input);
    bool const changed = options.unverified.warn_if_changed(file, options.file);
    auto const plan = plan_in(file, spec);
    auto const statistics = recount(file, spec);
    auto data = begun(options, spec);
    double const confidence = options.confidence.value_or(spec.confidence);
    auto analysis = analyse(spec, statistics, {.confidence = confidence, .beta_u = options.beta_u, .band_points = 61});
    tell_velocities(analysis, options.unit.requested ? options.unit.measures() : typed_unit(spec, Dimension::velocity));
    data["fit"] = output::fit_json(spec, statistics, analysis, confidence, output::WarningUnits::as_written);
    data["fit"]["assumptions"] = assumptions_json(spec);
    auto const telling = telling_trials(spec, file);
    data["fit"]["telling_trials"] = output::json_of(output::telling_trial_table(spec, telling));
    add_checks(checks, options.file, file, data);
    add_hand_checks(spec, statistics, analysis, data);
    auto const rare = read_rare_estimates(file, spec);
    add_rare(file, spec, rare, data);
    data["changed"] = changed ? output::changed_file_text() : "";
    data["facts"] = output::facts_of(spec, plan, statistics);
    data["method"] = output::method_of(spec);
    add_stated_facts(options, spec, confidence, data);
    add_cover(options, spec, data);
    auto const frequencies = add_frequencies(options.hazard, input, spec, statistics, analysis, confidence, data);
    output::Answered const answered{.spec = spec,
                                    .statistics = statistics,
                                    .analysis = analysis,
                                    .confidence = confidence,
                                    .frequencies = frequencies,
                                    .beta_u_of_campaign = !options.beta_u,
                                    .numerical = numerical_error_of(checks),
                                    .rare = rare};
    data["answer"] = answer_of(answered);
    auto const records = output::record_sheet(spec, trials_of_few_waves(spec, file));
    data["records"] = {{"head", records.head}, {"rows", records.rows}, {"note", records.note}};
    add_words(answered, data);
    data["waves"] = waves_of(input, spec, plan, file);
    data["spectra"] = spectra_of(input, spec);
    data["wave_notes"] = notes_of(spec, statistics, file);
    auto const shown = waves_shown(spec, plan);
    data["waves_shown"] = shown ? Json(*shown) : Json();
    if (shown) {
        data["wave_notes"].push_back(output::shown_waves_text(*shown, plan.waves()));
    }
    auto const histories = shown_trials(spec, plan, telling, file);
    data["histories"] = histories.drawn;
    data["histories_of"] =
        output::histories_text(histories.bodies, spec.bodies.size(), histories.at_rest_at_design_basis);
    data["outcomes"] = outcomes_data(options.outcomes, spec, plan, file);
    data["cost"] = cost_of(options.file);
    store::write_durably(options.page, report::figure_text("campaign_page.py", data, ".html"));
    print_note("page: {}{}\n", options.page,
               options.figures.empty() ? "" : fmt::format(", figures and tables: {}", options.figures));
    return done;
}

}  // namespace

void add_report(CommandLine& line) {
    auto verb = line.verb("report", "write a results file as one page with figures and tables");
    auto options = std::make_shared<ReportOptions>();
    verb.needs("file", options->file, "results file");
    verb.needs("-o,--output", options->page, "page to write, .html");
    verb.takes("--figures", options->figures, "also write figures (svg, png) and tables (csv) into this folder", "DIR");
    options->unit.offered_by(verb);
    verb.takes("--outcomes", options->outcomes,
               "observed outcomes of real bodies under these motions: columns wave, motion, and 0 or 1 for each body",
               "TABLE.csv");
    verb.takes("--hazard", options->hazard,
               "hazard curve for annual frequencies: '<measure> [unit], annual_exceedance' (csv); default: that of the "
               "campaign");
    verb.takes("--record", options->records,
               "list this check on the page: a record of verify, qualify or cost (--json); may be repeated",
               "CHECK.json");
    verb.takes("--date", options->date, "date printed on the cover, exactly as given; default: none");
    verb.takes(
        "--beta-u", options->beta_u,
        "beta_U for HCLPF: lognormal standard deviation of the median from uncertain properties of the body; default: "
        "that of the campaign");
    verb.takes("--confidence", options->confidence, "confidence level of all intervals; default: that of the campaign");
    options->unverified.offered_by(verb);
    verb.does([options] { return write_report(*options); });
}

}  // namespace overturn::cli
