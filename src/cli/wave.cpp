#include <cstdio>
#include <filesystem>
#include <memory>
#include <utility>

#include "campaign/plan.hpp"
#include "campaign/warnings.hpp"
#include "cli/figures.hpp"
#include "cli/named_files.hpp"
#include "cli/velocity_unit.hpp"
#include "cli/verbs.hpp"
#include "core/print_note.hpp"
#include "motion/record_writer.hpp"
#include "motion/text_lines.hpp"
#include "output/wave_text.hpp"
#include "report/figure.hpp"

namespace overturn::cli {
namespace {

struct WaveOptions {
    std::string campaign, output, plot;
    std::vector<std::string> settings;
    std::int64_t wave = 0;
    VelocityUnit unit;
    bool json = false;
};

enum class OutputKind { csv, at2 };

OutputKind kind_of(std::string const& output) {
    auto const extension = lowered(std::filesystem::path(output).extension().string());
    validate(extension == ".csv" || extension == ".at2",
             "-o {}: not the name of a wave (its ending says the kind). End it in .csv or .at2", output);
    return extension == ".csv" ? OutputKind::csv : OutputKind::at2;
}

// One file per component; beside others each says which it is: wave-H1.at2, wave-UP.at2.
std::vector<std::string> write_at2(GroundMotion const& motion, std::string const& identity, std::string const& output) {
    std::vector<std::pair<char const*, std::vector<double> const*>> const components{
        {"H1", &motion.horizontal_mps2}, {"H2", &motion.transverse_mps2}, {"UP", &motion.vertical_mps2}};
    bool const single = motion.transverse_mps2.empty() && motion.vertical_mps2.empty();
    std::filesystem::path const path(output);
    std::vector<std::string> written;
    for (auto const& [name, values] : components) {
        if (values->empty()) {
            continue;
        }
        auto const file = fmt::format("{}-{}{}", path.stem().string(), name, path.extension().string());
        written.push_back(single ? output : (path.parent_path() / file).string());
        open_named(written.back()).print("{}", at2_text(*values, motion.time_step_s, identity, name));
    }
    return written;
}

void write_output(WaveOptions const& options, std::uint64_t seed, GeneratedWave const& made) {
    std::vector<std::string> written{options.output};
    if (kind_of(options.output) == OutputKind::csv) {
        open_named(options.output).print("{}", csv_text(made.motion));
    } else {
        written = write_at2(made.motion, fmt::format("{}, seed {}, wave {}", options.campaign, seed, options.wave),
                            options.output);
    }
    for (auto const& file : written) {
        print_note("{}: {} samples of {:.6g} s, {}\n", file, made.motion.samples(), made.motion.time_step_s,
                   made.label);
    }
}

int show_wave(WaveOptions const& options) {
    if (!options.output.empty()) {
        (void)kind_of(options.output);
    }
    options.unit.check();
    if (!options.plot.empty()) {
        report::check_figure_name(options.plot);
    }
    auto const input = load_campaign(options.campaign, options.settings);
    auto const spec = parse_campaign(input);
    Plan const plan(spec);
    validate(options.wave >= 0 && options.wave < plan.waves(),
             "--wave {} (the campaign has waves 0 to {}). Choose one of them", options.wave, plan.waves() - 1);
    auto const id = plan.wave_id(options.wave);
    auto const made = spec.source->make(spec.seed, id);
    auto const check = check_wave(made, spec.bodies, spec.measures.radius_unit);
    if (options.json) {
        fmt::print("{}", output::wave_json(spec, made, check));
    }
    if (options.output.empty() && options.plot.empty()) {
        fmt::print("{}", options.json ? "" : csv_text(made.motion));
        return done;
    }
    if (!options.output.empty()) {
        write_output(options, spec.seed, made);
    }
    if (!options.plot.empty()) {
        draw_campaign_wave(input, spec, made, options.unit.of_campaign(spec), options.plot);
        print_note("{}: {}\n", options.plot, made.label);
    }
    print_note("{}", output::wave_text(spec, made, check));
    note_warnings(warnings_of(spec));
    return done;
}

}  // namespace

void add_wave(CommandLine& line) {
    auto verb = line.verb("wave", "write or draw one wave of a campaign, unscaled");
    auto options = std::make_shared<WaveOptions>();
    verb.needs("campaign", options->campaign, "campaign file (TOML)");
    verb.needs("--wave", options->wave, "number of the wave, from 0");
    verb.takes("-o,--output", options->output,
               "out.csv, or out.at2 (one file per component); default: csv in the current folder");
    verb.takes("--plot", options->plot, "draw it: out.svg, .png or .pdf");
    options->unit.offered_by(verb);
    verb.takes("--json", options->json, "print as JSON how the wave meets each clause of its rule");
    verb.takes("--set", options->settings, "override keys: seed=2 waves.count=50", "KEY=VALUE ...");
    verb.does([options] { return show_wave(*options); });
}

}  // namespace overturn::cli
