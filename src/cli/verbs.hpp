/// One function per verb: declares its options and, when chosen, sets what is to be done.
#pragma once

#include <functional>

#include <CLI/CLI.hpp>

namespace overturn::cli {

/// Exit codes that scripts depend on.
enum ExitCode { done = 0, other_failure = 1, bad_input = 2, resumable = 3 };

/// What the command line asks for; runs after parsing, throws on failure, returns the exit code.
using Action = std::function<int()>;

void add_run(CLI::App& app, Action& action);
void add_plan(CLI::App& app, Action& action);
void add_merge(CLI::App& app, Action& action);
void add_status(CLI::App& app, Action& action);
void add_replay(CLI::App& app, Action& action);
void add_fit(CLI::App& app, Action& action);
void add_report(CLI::App& app, Action& action);
void add_cost(CLI::App& app, Action& action);
void add_rock(CLI::App& app, Action& action);
void add_spectrum(CLI::App& app, Action& action);
void add_wave(CLI::App& app, Action& action);
void add_list(CLI::App& app, Action& action);

}  // namespace overturn::cli
