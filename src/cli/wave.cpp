#include <cstdio>
#include <memory>
#include <system_error>

#include <fmt/os.h>

#include "campaign/plan.hpp"
#include "cli/verbs.hpp"
#include "cli/wave_report.hpp"

namespace overturn::cli {
namespace {

struct Options {
    std::string campaign, output;
    std::vector<std::string> settings;
    std::int64_t wave = 0;
    bool json = false;
};

std::string csv_of(GroundMotion const& motion) {
    std::string text = "time_s,ax_mps2";
    text += motion.transverse_mps2.empty() ? "" : ",ay_mps2";
    text += motion.vertical_mps2.empty() ? "\n" : ",az_mps2\n";
    for (std::size_t i = 0; i < motion.samples(); ++i) {
        text += fmt::format("{},{}", static_cast<double>(i) * motion.time_step_s, motion.horizontal_mps2[i]);
        if (!motion.transverse_mps2.empty()) {
            text += fmt::format(",{}", motion.transverse_mps2[i]);
        }
        if (!motion.vertical_mps2.empty()) {
            text += fmt::format(",{}", motion.vertical_mps2[i]);
        }
        text += '\n';
    }
    return text;
}

int write_wave(Options const& options) {
    auto const spec = parse_campaign(load_campaign(options.campaign, options.settings));
    Plan const plan(spec);
    validate(options.wave >= 0 && options.wave < plan.waves(),
             "--wave {} (the campaign has waves 0 to {}). Choose one of them", options.wave, plan.waves() - 1);
    auto const made = spec.source->make(spec.seed, plan.wave_id(options.wave));
    auto const check = check_wave(made, spec.bodies, spec.measures.radius_unit);
    if (options.json) {
        fmt::print("{}", wave_json(spec, made, check));
    }
    if (options.output.empty()) {
        fmt::print("{}", options.json ? "" : csv_of(made.motion));
        return done;
    }
    try {
        fmt::output_file(options.output).print("{}", csv_of(made.motion));
    } catch (std::system_error const& error) {
        throw InputError(
            fmt::format("{}: cannot be written ({}). Choose another place", options.output, error.code().message()));
    }
    fmt::print(stderr, "{}: {} samples of {} s, {}\n{}", options.output, made.motion.samples(), made.motion.time_step_s,
               made.label, wave_report(spec, made, check));
    return done;
}

}  // namespace

void add_wave(CLI::App& app, Action& action) {
    auto* verb = app.add_subcommand("wave", "write one wave of a campaign, unscaled, as csv");
    auto options = std::make_shared<Options>();
    verb->add_option("campaign", options->campaign, "campaign file (TOML)")->required();
    verb->add_option("--wave", options->wave, "number of the wave, from 0")->required();
    verb->add_option("-o,--output", options->output, "csv file; default: standard output");
    verb->add_flag("--json", options->json, "how right the wave is, clause by clause, on standard output");
    verb->add_option("--set", options->settings, "override a key: seed=2")->allow_extra_args(false);
    verb->callback([options, &action] { action = [options] { return write_wave(*options); }; });
}

}  // namespace overturn::cli
