#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "campaign/campaign_spec.hpp"
#include "campaign/limit_state.hpp"
#include "campaign/verdict_text.hpp"
#include "cli/assumptions_text.hpp"
#include "cli/column_list.hpp"
#include "cli/key_list.hpp"
#include "cli/verbs.hpp"
#include "config/key_reference.hpp"
#include "config/suggestion.hpp"
#include "core/wrapped.hpp"
#include "generators/acceptance.hpp"
#include "generators/envelope.hpp"
#include "motion/record.hpp"
#include "output/fit_json.hpp"
#include "response/effects.hpp"
#include "response/registry.hpp"
#include "results/recount.hpp"
#include "results/schema.hpp"
#include "results/stored_names.hpp"
#include "spectra/named_targets.hpp"

namespace overturn::cli {
namespace {

constexpr std::size_t entry_width = 25;  // of the longest name, with two blanks before it and one behind

void print_entry(std::string_view name, std::string_view text, std::size_t width = entry_width) {
    fmt::print("{}", labelled(fmt::format("  {}", name), text, width));
}

template <class Value> void print_entries(char const* heading, std::span<config::Entry<Value> const> entries) {
    fmt::print("{}\n", heading);
    for (auto const& entry : entries) {
        print_entry(entry.name, entry.summary);
    }
}

void print_column(std::string const& name, Field const& column) {
    print_entry(name,
                fmt::format("{}{}", column.description, column.units == "1" ? "" : fmt::format(" [{}]", column.units)),
                35);
}

struct ListOptions {
    std::string what;
    std::vector<std::string> named;  // tables of keys, or files of columns
    bool json = false, schema = false, markdown = false;
    Unverified unverified;
};

// The tables that stand at `path` and within, or all.
std::vector<config::PlacedTable> chosen_tables(std::string const& path) {
    auto all = tables_within(campaign_table);
    if (path.empty()) {
        return all;
    }
    std::vector<config::PlacedTable> chosen;
    std::vector<std::string> known;
    for (auto const& placed : all) {
        for (auto const& place : placed.places) {
            if (std::ranges::find(known, place.path) == known.end() && !place.path.empty()) {
                known.push_back(place.path);
            }
        }
        if (std::ranges::any_of(placed.places, [&](config::TablePlace const& place) {
                return place.path == path || place.path.starts_with(path + ".");
            })) {
            chosen.push_back(placed);
        }
    }
    validate(!chosen.empty(), "list keys '{}' (no table of a campaign). {}", path, config::suggestion(path, known));
    return chosen;
}

int list_keys(ListOptions const& options) {
    validate(options.named.size() < 2, "'{}' (one argument too many). Name one table",
             options.named.empty() ? "" : options.named.back());
    auto const tables = chosen_tables(options.named.empty() ? "" : options.named.front());
    validate(std::ranges::count(std::array{options.json, options.schema, options.markdown}, true) <= 1,
             "--json, --schema and --markdown (one page has one form). Keep one of them");
    fmt::print("{}", options.json       ? keys_json(tables).dump(2) + "\n"
                     : options.schema   ? schema_text(keys_schema(*tables.front().table))
                     : options.markdown ? keys_markdown(tables)
                                        : keys_text(tables));
    return done;
}

// Of a campaign that this program cannot read it knows no columns of rows, so none of these can be called unknown.
void add_columns(store::ResultsReader const& file, ListedColumns& listed) {
    auto unknown = unknown_columns_of_results(file);
    try {
        auto const spec = parse_campaign(input_of(file));
        unknown = unknown_columns(file, spec);
        add_groups(output::empty_json_tables(spec), listed.json);
    } catch (InputError const&) {  // NOLINT(bugprone-empty-catch)
    }
    add_groups(file, unknown, listed.file);
}

int list_columns(ListOptions const& options) {
    validate(!options.named.empty(), "list columns (of which file?). Name a results file");
    validate(!options.json && !options.schema,
             "--json and --schema (columns are listed as text or with --markdown). Leave them out");
    ListedColumns listed;
    for (auto const& path : options.named) {
        store::ResultsReader const file(path, options.unverified.trust());
        (void)options.unverified.warn_if_edited(file, path);
        add_columns(file, listed);
    }
    fmt::print("{}", options.markdown ? columns_markdown(listed) : columns_text(listed));
    return done;
}

void print_measures() {
    print_entries("level measures (levels.measure)", level_measures());
    fmt::print("further curve measures (measures.curves); curves over the other measures are always fitted\n");
    for (auto const& measure : intensity_measures) {
        if (measure.curves == Curves::asked) {
            print_entry(measure.name, measure.meaning);
        }
    }
}

void print_limits() {
    fmt::print("limit states (limits.quantity)\n");
    for (auto const& quantity : limit_quantities()) {
        auto const units = quantity.units == "1" ? std::string() : fmt::format(" [{}]", quantity.units);
        auto const calls = quantity.of_every_model || quantity.needs == 0
                               ? std::string()
                               : fmt::format("; requires {} in every trial", names_of_effects(quantity.needs));
        print_entry(quantity.name, fmt::format("{}{}{}", quantity.description, units, calls), 27);
    }
}

void print_quantities() {
    fmt::print("measures stored per trial\n");
    for (auto const& column : fields_of<TrialRow>()) {
        print_column(column.name, column);
    }
    for (auto const& model : models()) {
        for (auto const& column : model.traits().fields) {
            print_column(fmt::format("{}/{}", model.traits().name, column.name), column);
        }
    }
}

void print_verdicts() {
    constexpr MovementSpec usual;
    IntensityUnit const millimetre{"mm", 1e-3};
    fmt::print("verdicts of trials (thresholds: measures.slid_from, measures.rocked_from)\n");
    for (auto const& entry : verdicts()) {
        print_entry(entry.name, verdict_text(entry, usual, millimetre));
    }
}

// What `list` prints, in this order; each can be asked for by its name.
struct Section {
    std::string_view name;
    void (*print)();
};

constexpr auto sections = std::to_array<Section>(
    {{"sources", [] { print_entries("wave sources (waves.source)", wave_sources()); }},
     {"targets", [] { print_entries("target spectra (waves.target.spectrum)", named_targets()); }},
     {"damping-rules", [] { print_entries("damping rules (waves.target.damping_rule)", damping_rules()); }},
     {"envelopes", [] { print_entries("envelopes (waves.envelope.shape)", envelope_shapes()); }},
     {"acceptance", [] { print_entries("acceptance rules (waves.acceptance)", acceptance_rules()); }},
     {"formats", [] { print_entries("record formats", record_formats()); }},
     {"effects", [] { print_entries("effects (effects.include)", effects()); }},
     {"verdicts", &print_verdicts},
     {"measures", &print_measures},
     {"limits", &print_limits},
     {"trial", &print_quantities}});

std::string section_names() {
    std::string names;
    for (auto const& section : sections) {
        names += fmt::format("{}{}", names.empty() ? "" : ", ", section.name);
    }
    return names;
}

// All sections, or the one that is named.
void print_sections(std::string_view what) {
    for (auto const& section : sections) {
        if (what.empty() || what == section.name) {
            section.print();
        }
    }
    if (what.empty()) {
        fmt::print("further lists\n");
        print_entry("keys", "keys of a campaign");
        print_entry("assumptions", "assumptions of the model");
        print_entry("columns FILE.h5", "columns of a results file");
        fmt::print("{}",
                   wrapped(fmt::format("one list alone: overturn list NAME, with NAME one of {}", section_names())));
    }
}

int list(ListOptions const& options) {
    if (options.what == "columns") {
        return list_columns(options);
    }
    validate(!options.unverified.read_changed, "--unverified (used with list columns only). Leave it out");
    if (options.what == "keys") {
        return list_keys(options);
    }
    bool const assumptions = options.what == "assumptions";
    validate(assumptions || options.what.empty() || std::ranges::count(sections, options.what, &Section::name) == 1,
             "list '{}' (unknown). Choose keys, columns FILE.h5, assumptions, {}, or nothing: all but the first three",
             options.what, section_names());
    validate(options.named.empty(), "'{}' (one argument too many). See overturn list --help",
             options.named.empty() ? "" : options.named.front());
    validate(!options.schema && !options.markdown,
             "--schema and --markdown (used with keys or columns only). Use overturn list keys");
    validate(!options.json || assumptions,
             "--json (used with keys or assumptions only). Use overturn list assumptions --json");
    if (assumptions) {
        fmt::print("{}", options.json ? model_assumptions_json().dump(2) + "\n" : model_assumptions_text());
    } else {
        print_sections(options.what);
    }
    return done;
}

}  // namespace

void add_list(CommandLine& line) {
    auto verb = line.verb("list", "list keys, columns, spectra, record formats, measures, assumptions");
    auto options = std::make_shared<ListOptions>();
    verb.takes(
        "what", options->what,
        fmt::format("keys: keys of a campaign; columns: columns of a results file; assumptions: assumptions of the "
                    "model; or one of {}; default: all of these",
                    section_names()));
    verb.takes("named", options->named, "with keys: a table (waves, bodies.pad, ...); with columns: results files");
    verb.takes("--json", options->json, "keys or assumptions as JSON");
    verb.takes("--schema", options->schema, "keys as a JSON schema, for editors of TOML");
    verb.takes("--markdown", options->markdown, "keys or columns as a page");
    options->unverified.offered_by(verb);
    verb.does([options] { return list(*options); });
}

}  // namespace overturn::cli
