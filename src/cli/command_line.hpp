/// The verbs and options of the command line. The parser behind them is seen by command_line.cpp only.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace CLI {
class App;
}

namespace overturn::cli {

/// Exit codes that scripts depend on.
enum ExitCode {
    done = 0,
    other_failure = 1,
    bad_input = 2,
    resumable = 3,
    refitted_otherwise = 4  ///< `fit` of another program's file, whose stored curves are others
};

/// Action of a verb once its options are read: throws on failure, returns the exit code.
using Action = std::function<int()>;

/// One verb. Values are those of std::string, std::int64_t, double, bool, an std::optional of the first three, or a
/// std::vector<std::string> for an option that may be repeated; what is not given stays as it is. A `bool` is a flag.
class Verb {
  public:
    Verb(CLI::App& parser, Action& chosen) : parser_(parser), chosen_(chosen) {}

    /// An argument ("campaign") or option ("-o,--output") that must be given.
    template <class Value> void needs(std::string const& names, Value& value, std::string const& help);
    /// One that may be given. \param placeholder what --help shows for its value; default: its type, and its default if
    /// it has one
    template <class Value>
    void takes(std::string const& names, Value& value, std::string const& help, std::string const& placeholder = "");
    void does(Action action);

  private:
    CLI::App& parser_;
    Action& chosen_;
};

class CommandLine {
  public:
    CommandLine(std::string const& description, std::string const& version);
    CommandLine(CommandLine const&) = delete;
    CommandLine& operator=(CommandLine const&) = delete;
    CommandLine(CommandLine&&) = delete;
    CommandLine& operator=(CommandLine&&) = delete;
    ~CommandLine();

    [[nodiscard]] Verb verb(std::string const& name, std::string const& help);

    /// Runs the verb of the arguments. \return the exit code; errors in the arguments are reported in one line, with
    /// what was probably meant
    int run(int argc, char const* const* arguments);

  private:
    std::unique_ptr<CLI::App> parser_;
    Action chosen_;
};

}  // namespace overturn::cli
