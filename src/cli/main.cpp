#include <csignal>
#include <exception>

#include <fmt/format.h>
#include <gsl/gsl_errno.h>

#include "campaign/version.hpp"
#include "cli/command_line.hpp"
#include "cli/say.hpp"
#include "cli/verbs.hpp"
#include "core/allocation.hpp"
#include "core/error.hpp"
#include "core/note.hpp"

namespace {

using namespace overturn;

int start(int argc, char** argv) {
    keep_standard_streams();
    keep_freed_memory();
    std::signal(SIGXFSZ, SIG_IGN);  // a file size limit is an error like a full disk, not a death
    gsl_set_error_handler_off();    // its own would abort; callers look at what came back
    CLI::App app("Overturning of free-standing bodies in earthquakes: fragility campaigns and single trials.",
                 "overturn");
    app.set_version_flag("--version", fmt::format("overturn {}; {}", program_identity(), library_versions()));
    app.require_subcommand(1);
    cli::Action action;
    cli::add_run(app, action);
    cli::add_plan(app, action);
    cli::add_merge(app, action);
    cli::add_status(app, action);
    cli::add_replay(app, action);
    cli::add_fit(app, action);
    cli::add_report(app, action);
    cli::add_cost(app, action);
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
    return action();
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return start(argc, argv);
    } catch (InputError const& error) {
        cli::say_once(error.what());
        return cli::bad_input;
    } catch (std::exception const& error) {
        cli::say_once(error.what());
    } catch (...) {
        return cli::other_failure;
    }
    return cli::other_failure;
}
