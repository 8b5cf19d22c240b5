/// Errors for the user: a line each on stderr, from one rank.
#pragma once

#include <string>

namespace overturn::cli {

/// Prints `overturn: message` as exactly one line, whatever the message holds; of one that quotes kilobytes, both ends.
/// A message of several faults (config::joined_faults) is a line for each of the first 30.
void print_error(std::string const& message);

/// The same, silent on ranks above 0, which are known from the launcher's environment variables: for errors that every
/// rank meets, also before MPI is up.
void print_error_once(std::string const& message);

/// By the launcher's environment variables, before MPI is up.
[[nodiscard]] bool is_first_rank();

struct Failure {
    std::string message;
    int code;  ///< to exit with
};
/// The exception being handled, as a message for the user; one without a message of its own gets it here.
/// \pre called in a catch block
[[nodiscard]] Failure current_failure();

}  // namespace overturn::cli
