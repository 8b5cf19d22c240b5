/// What is wrong with a command line, in our own words: with what was probably meant.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace overturn::cli {

/// \param error what parsing `arguments` with `app` threw; the message says what to do
[[nodiscard]] std::string explain(CLI::App const& app, CLI::ParseError const& error, int argc,
                                  char const* const* arguments);

}  // namespace overturn::cli
