#include <csignal>
#include <exception>
#include <string_view>

#include <fmt/format.h>
#include <gsl/gsl_errno.h>

#include "campaign/version.hpp"
#include "cli/command_line.hpp"
#include "cli/print_error.hpp"
#include "cli/verbs.hpp"
#include "core/allocation.hpp"
#include "core/error.hpp"
#include "core/print_note.hpp"
#include "runner/stop_policy.hpp"

namespace {

using namespace overturn;

// Before any library is set up, let alone MPI: a signal to leave that comes then must not kill a run.
void hear_signals(int /*argc*/, char** /*argv*/, char** /*environment*/) { stop_on_signals(); }
[[gnu::section(".preinit_array"), gnu::used]] void (*const first_of_all)(int, char**, char**) = &hear_signals;

int start(int argc, char** argv) {
    if (argc < 2 || std::string_view(argv[1]) != "run") {
        restore_signals();
    }
    keep_standard_streams();
    keep_freed_memory();
    std::signal(SIGXFSZ, SIG_IGN);  // a file size limit is an error like a full disk, not a death
    gsl_set_error_handler_off();    // its own would abort; callers look at what came back
    cli::CommandLine line("Overturning of free-standing bodies in earthquakes: fragility campaigns and single trials.",
                          fmt::format("overturn {}; {}", program_identity(), library_versions()));
    cli::add_new(line);
    cli::add_run(line);
    cli::add_plan(line);
    cli::add_merge(line);
    cli::add_status(line);
    cli::add_replay(line);
    cli::add_verify(line);
    cli::add_qualify(line);
    cli::add_fit(line);
    cli::add_report(line);
    cli::add_export(line);
    cli::add_cost(line);
    cli::add_rock(line);
    cli::add_spectrum(line);
    cli::add_wave(line);
    cli::add_spectra(line);
    cli::add_list(line);
    return line.run(argc, argv);
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return start(argc, argv);
    } catch (std::exception const&) {
        auto const [message, code] = cli::current_failure();
        cli::print_error_once(message);
        return code;
    } catch (...) {
        return cli::other_failure;
    }
    return cli::other_failure;
}
