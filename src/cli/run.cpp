#include "campaign/run.hpp"

#include <filesystem>
#include <memory>

#include "cli/say.hpp"
#include "cli/verbs.hpp"
#include "core/error.hpp"
#include "core/units.hpp"

namespace overturn::cli {
namespace {

struct Options {
    std::string campaign;
    std::string output;
    std::vector<std::string> settings;
    std::string max_walltime;
    bool resume = false;
};

double read_walltime(std::string const& text) {
    try {
        double const seconds = parse_quantity(text, Dimension::time);
        validate(seconds > 0, "{} s (must be above 0). State the time this run may take", seconds);
        return seconds;
    } catch (InputError const& error) {
        throw InputError(fmt::format("--max-walltime: {}", error.what()));
    }
}

int run(Options const& options) {
    parallel::Environment const environment;
    parallel::Communicator const comm;
    // Errors that every rank knows of are thrown by every rank and told by one; all others end the whole job.
    try {
        auto const input = load_campaign_everywhere(options.campaign, options.settings, comm);
        RunOptions run_options;
        run_options.output =
            options.output.empty() ? default_output(options.campaign) : std::filesystem::path(options.output);
        run_options.resume = options.resume;
        if (!options.max_walltime.empty()) {
            run_options.max_walltime_s = read_walltime(options.max_walltime);
        }
        stop_on_signals();
        return run_campaign(input, run_options, comm) == RunEnd::complete ? done : resumable;
    } catch (InputError const& error) {
        if (comm.is_root()) {
            say(error.what());
        }
        return bad_input;
    } catch (std::exception const& error) {
        say(error.what());
        if (comm.size() > 1) {
            comm.abort(other_failure);
        }
        return other_failure;
    }
}

}  // namespace

void add_run(CLI::App& app, Action& action) {
    auto* verb = app.add_subcommand("run", "run a campaign, alone or under mpirun");
    auto options = std::make_shared<Options>();
    verb->add_option("campaign", options->campaign, "campaign file (TOML)")->required();
    verb->add_option("-o,--output", options->output, "results file; default: the campaign's name with .h5, here");
    verb->add_flag("--resume", options->resume, "go on with what an earlier run left behind");
    verb->add_option("--set", options->settings, "override a key: waves.count=50, bodies.0.friction=0.4")
        ->allow_extra_args(false);
    verb->add_option("--max-walltime", options->max_walltime, "stop in time to be resumed, e.g. \"50 min\"");
    verb->callback([options, &action] { action = [options] { return run(*options); }; });
}

}  // namespace overturn::cli
