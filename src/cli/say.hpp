/// Errors for the user: one line on stderr, from one rank.
#pragma once

#include <string>

namespace overturn::cli {

/// Prints `overturn: message` as exactly one line, whatever the message holds.
void say(std::string message);

/// As say, but silent on ranks above 0, known from what launchers put into the environment: for errors that every rank
/// meets, also before MPI is up.
void say_once(std::string message);

}  // namespace overturn::cli
