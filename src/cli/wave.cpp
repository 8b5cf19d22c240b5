#include <cstdio>
#include <memory>
#include <system_error>

#include <fmt/os.h>

#include "campaign/plan.hpp"
#include "cli/verbs.hpp"

namespace overturn::cli {
namespace {

struct Options {
    std::string campaign, output;
    std::vector<std::string> settings;
    std::int64_t wave = 0;
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
    auto const text = csv_of(made.motion);
    if (options.output.empty()) {
        fmt::print("{}", text);
        return done;
    }
    try {
        fmt::output_file(options.output).print("{}", text);
    } catch (std::system_error const& error) {
        throw InputError(
            fmt::format("{}: cannot be written ({}). Choose another place", options.output, error.code().message()));
    }
    fmt::print(stderr, "{}: {} samples of {} s, {}\n", options.output, made.motion.samples(), made.motion.time_step_s,
               made.label);
    if (made.match.matched || made.match.iterations > 0) {
        fmt::print(
            stderr, "match: mean misfit {:.2f} %, largest {:.2f} % at {:.3f} s; from 1 s up {:.2f} % and {:.2f} %\n",
            100 * made.match.all.mean_misfit, 100 * made.match.all.max_misfit, made.match.all.max_misfit_period_s,
            100 * made.match.long_period.mean_misfit, 100 * made.match.long_period.max_misfit);
    }
    return done;
}

}  // namespace

void add_wave(CLI::App& app, Action& action) {
    auto* verb = app.add_subcommand("wave", "write one wave of a campaign, unscaled, as csv");
    auto options = std::make_shared<Options>();
    verb->add_option("campaign", options->campaign, "campaign file (TOML)")->required();
    verb->add_option("--wave", options->wave, "number of the wave, from 0")->required();
    verb->add_option("-o,--output", options->output, "csv file; default: standard output");
    verb->add_option("--set", options->settings, "override a key: seed=2")->allow_extra_args(false);
    verb->callback([options, &action] { action = [options] { return write_wave(*options); }; });
}

}  // namespace overturn::cli
