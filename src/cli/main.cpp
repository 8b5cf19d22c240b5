#include <exception>

#include <fmt/format.h>

#include "campaign/version.hpp"
#include "cli/command_line.hpp"
#include "cli/say.hpp"
#include "cli/verbs.hpp"
#include "core/error.hpp"

namespace {

using namespace overturn;

int perform(cli::Action const& action) {
    try {
        return action();
    } catch (InputError const& error) {
        cli::say_once(error.what());
        return cli::bad_input;
    } catch (std::exception const& error) {
        cli::say_once(error.what());
        return cli::other_failure;
    }
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Overturning of free-standing bodies in earthquakes: fragility campaigns and single trials.",
                 "overturn");
    app.set_version_flag("--version",
                         fmt::format("overturn {} ({}); {}", program_version(), git_revision(), library_versions()));
    app.require_subcommand(1);
    cli::Action action;
    cli::add_run(app, action);
    cli::add_plan(app, action);
    cli::add_status(app, action);
    cli::add_replay(app, action);
    cli::add_fit(app, action);
    cli::add_rock(app, action);
    cli::add_spectrum(app, action);
    cli::add_wave(app, action);
    cli::add_list(app, action);
    try {
        app.parse(argc, argv);
    } catch (CLI::Success const& help) {
        return app.exit(help);
    } catch (CLI::ParseError const& error) {
        cli::say_once(cli::explain(app, error, argc, argv));
        return cli::bad_input;
    }
    return perform(action);
}
