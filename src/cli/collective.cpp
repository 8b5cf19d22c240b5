#include "cli/collective.hpp"

#include <cstdlib>
#include <exception>

#include <fmt/format.h>

#include "cli/command_line.hpp"
#include "cli/print_error.hpp"
#include "core/error.hpp"
#include "runner/progress.hpp"
#include "runner/root_broadcast.hpp"

namespace overturn::cli {

namespace {

// "PMI_SIZE says 4 ranks": a launcher that our MPI does not understand starts every rank as a world of its own, and all
// would write the same output. Not SLURM_NTASKS, which a batch script has too.
std::string other_launcher() {
    for (char const* const name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "SLURM_STEP_NUM_TASKS"}) {
        char const* const size = std::getenv(name);
        if (size != nullptr && std::atoi(size) > 1) {
            return fmt::format("{} states {} ranks", name, std::atoi(size));
        }
    }
    return {};
}

// srun starts processes that Open MPI cannot join where it was built without Slurm's PMI, and MPI_Init then ends each
// of them with a page of its own.
bool is_cut_off() {
    char const* const tasks = std::getenv("SLURM_STEP_NUM_TASKS");
    return tasks != nullptr && std::atoi(tasks) > 1 && parallel::Communicator::library().starts_with("Open MPI")
           && !parallel::is_launched();
}

}  // namespace

int on_all_ranks(std::function<int(parallel::Communicator const&)> const& action) {
    auto const refuse = [](std::string const& message) {
        print_error_once(message);
        if (is_first_rank()) {
            tell_end(bad_input);
        }
        return bad_input;
    };
    if (is_cut_off()) {
        return refuse(
            fmt::format("SLURM_STEP_NUM_TASKS states {} ranks (srun did not pass them to {}). Start it with mpirun, or "
                        "srun --mpi=pmix",
                        std::getenv("SLURM_STEP_NUM_TASKS"), parallel::Communicator::library()));
    }
    parallel::Environment const environment;
    parallel::Communicator const comm;
    if (auto const other = other_launcher(); comm.size() == 1 && !other.empty()) {
        return refuse(
            fmt::format("this process is alone, but {} (the launcher of another MPI?). Start it with the mpirun of "
                        "{}",
                        other, parallel::Communicator::library()));
    }
    // While MPI lives: mpirun may end this process within its last call.
    auto const end = [&](int code, std::string const& error = {}) {
        if (comm.is_root()) {
            if (!error.empty()) {
                print_error(error);
            }
            tell_end(code);
        }
        return code;
    };
    try {
        return end(action(comm));
    } catch (InputError const& error) {
        return end(bad_input, error.what());
    } catch (CollectiveError const& error) {
        return end(other_failure, error.what());
    } catch (std::exception const&) {
        auto const [message, code] = current_failure();
        print_error(message);
        tell_end(code);
        if (comm.size() > 1) {
            comm.abort(code);
        }
        return code;
    }
}

}  // namespace overturn::cli
