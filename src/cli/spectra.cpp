#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "campaign/warnings.hpp"
#include "cli/scene_files.hpp"
#include "cli/spectra_of_waves.hpp"
#include "cli/velocity_unit.hpp"
#include "cli/verbs.hpp"
#include "core/error.hpp"
#include "core/print_note.hpp"
#include "output/spectra_text.hpp"
#include "report/figure.hpp"

namespace overturn::cli {
namespace {

struct SpectraOptions {
    std::string campaign, plot;
    std::vector<std::string> settings;
    VelocityUnit unit;
    std::int64_t waves = 100;
    double damping = 0.1;
    bool json = false;
};

int show_spectra(SpectraOptions const& options) {
    validate(options.damping >= 0 && options.damping < 1,
             "--damping {} (a ratio, 0 to below 1: {} would be {:g} %). Write 0.1 for 10 %", options.damping,
             options.damping, 100 * options.damping);
    validate(options.waves >= 1, "--waves {} (at least one). Leave it out for the first 100", options.waves);
    options.unit.check();
    if (!options.plot.empty()) {
        report::check_figure_name(options.plot);
    }
    auto const input = load_campaign(options.campaign, options.settings);
    auto const spec = parse_campaign(input);
    note_warnings(warnings_of(spec));
    auto const spectra = spectra_of_waves(input, spec, options.waves, options.damping);
    auto json = spectra_json(spec, spectra);
    if (!options.plot.empty()) {
        auto data = json;
        data["units"] = units_json(spec, options.unit);
        report::draw_figure("spectra_figure.py", data, options.plot);
        print_note("{}: {} waves\n", options.plot, spectra.waves.size());
    }
    if (options.json) {
        fmt::print("{}\n", json.dump(2));
    } else {
        fmt::print("{}", output::spectra_text(spec, spectra, options.unit.of_campaign(spec)));
    }
    return done;
}

}  // namespace

void add_spectra(CommandLine& line) {
    auto verb = line.verb("spectra", "response and energy spectra of a campaign's waves, and the targets");
    auto options = std::make_shared<SpectraOptions>();
    verb.needs("campaign", options->campaign, "campaign file (TOML)");
    verb.takes("--waves", options->waves, "number of waves, from the first");
    verb.takes("--damping", options->damping, "damping ratio of V_E");
    options->unit.offered_by(verb);
    verb.takes("--plot", options->plot, "draw them: out.svg, .png or .pdf");
    verb.takes("--json", options->json, "as JSON");
    verb.takes("--set", options->settings, "override keys: seed=2 waves.count=50", "KEY=VALUE ...");
    verb.does([options] { return show_spectra(*options); });
}

}  // namespace overturn::cli
