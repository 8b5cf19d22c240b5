/// Times as batch systems spell them.
#pragma once

#include <chrono>
#include <string>

#include "parallel/communicator.hpp"

namespace overturn::cli {

/// "50 min", "1h", "90" (s), and Slurm's MM:SS, HH:MM:SS, D-HH, D-HH:MM, D-HH:MM:SS. [s]
/// \throws InputError if it is none of these or not above 0
[[nodiscard]] double parse_walltime(std::string const& text);

/// What --max-walltime says. [s] \throws InputError that names the option
[[nodiscard]] double stated_walltime(std::string const& text);

/// From `now` until a job ends that a batch system ends at the UNIX time `end`, less what leaving takes: a tenth of it,
/// 30 s at most. 0 where it has just passed, as where a busy node starts the program late. Infinite where there is no
/// such time, or it passed more than an hour ago, so that it is another job's. [s]
[[nodiscard]] double seconds_until(std::string const& end, std::chrono::system_clock::time_point now);

/// The same of the job that this process belongs to. [s]
[[nodiscard]] double seconds_of_job();
/// As rank 0 hears of it: other nodes may not have its environment. Collective. [s]
[[nodiscard]] double seconds_of_job(parallel::Communicator const& comm);

}  // namespace overturn::cli
