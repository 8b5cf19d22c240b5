/// One function per verb: declares its options and what it does.
#pragma once

#include "cli/command_line.hpp"

namespace overturn::cli {

void add_run(CommandLine& line);
void add_plan(CommandLine& line);
void add_merge(CommandLine& line);
void add_status(CommandLine& line);
void add_replay(CommandLine& line);
void add_fit(CommandLine& line);
void add_report(CommandLine& line);
void add_cost(CommandLine& line);
void add_rock(CommandLine& line);
void add_spectrum(CommandLine& line);
void add_wave(CommandLine& line);
void add_list(CommandLine& line);

}  // namespace overturn::cli
