#include <memory>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "campaign/limit_state.hpp"
#include "cli/assumptions_told.hpp"
#include "cli/verbs.hpp"
#include "generators/acceptance.hpp"
#include "generators/envelope.hpp"
#include "motion/record.hpp"
#include "response/effects.hpp"
#include "response/registry.hpp"
#include "results/results.hpp"
#include "spectra/named_targets.hpp"

namespace overturn::cli {
namespace {

template <class Value> void print_entries(char const* heading, std::span<config::Entry<Value> const> entries) {
    fmt::print("{}\n", heading);
    for (auto const& entry : entries) {
        fmt::print("  {:<22} {}\n", entry.name, entry.summary);
    }
}

struct ListOptions {
    std::string what;
    bool json = false;
};

int list(ListOptions const& options) {
    validate(options.what.empty() || options.what == "assumptions",
             "list '{}' (unknown). Say assumptions, or nothing: everything else", options.what);
    validate(!options.json || !options.what.empty(),
             "--json (of assumptions alone). Say overturn list assumptions "
             "--json");
    if (!options.what.empty()) {
        fmt::print("{}", options.json ? model_assumptions_json().dump(2) + "\n" : model_assumptions_text());
        return done;
    }
    print_entries("wave sources (waves.source)", wave_sources());
    print_entries("target spectra (waves.target.spectrum)", named_targets());
    print_entries("damping rules (waves.target.damping_rule)", damping_rules());
    print_entries("envelopes (waves.envelope.shape)", envelope_shapes());
    print_entries("acceptance rules (waves.acceptance)", acceptance_rules());
    print_entries("record formats", record_formats());
    print_entries("effects (effects.include)", effects());
    print_entries("level measures (levels.measure)", level_measures());
    fmt::print("limit states (limits.quantity)\n");
    for (auto const& quantity : limit_quantities()) {
        auto const units = quantity.units == "1" ? std::string() : fmt::format(" [{}]", quantity.units);
        auto const calls = quantity.of_every_model || quantity.needs == 0
                               ? std::string()
                               : fmt::format("; calls for {} in every trial", names_of_effects(quantity.needs));
        fmt::print("  {:<24} {}{}{}\n", quantity.name, quantity.description, units, calls);
    }
    fmt::print("measures stored per trial\n");
    for (auto const& column : fields_of<TrialRow>()) {
        fmt::print("  {:<22} {}\n", column.name, column.description);
    }
    for (auto const& model : models()) {
        for (auto const& column : model.traits().fields) {
            fmt::print("  {:<22} {}\n", fmt::format("{}/{}", model.traits().name, column.name), column.description);
        }
    }
    fmt::print("what the model assumes: overturn list assumptions\n");
    return done;
}

}  // namespace

void add_list(CommandLine& line) {
    auto verb = line.verb("list", "what can be asked for: sources, targets, formats, effects, measures");
    auto options = std::make_shared<ListOptions>();
    verb.takes("what", options->what, "assumptions: what the model takes for granted");
    verb.takes("--json", options->json, "assumptions as JSON");
    verb.does([options] { return list(*options); });
}

}  // namespace overturn::cli
