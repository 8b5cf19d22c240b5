#include "cli/command_line.hpp"

#include <fmt/format.h>

#include "config/suggestion.hpp"

namespace overturn::cli {
namespace {

std::vector<std::string> verbs_of(CLI::App const& app) {
    std::vector<std::string> names;
    for (auto const* verb : app.get_subcommands([](CLI::App const*) { return true; })) {
        names.push_back(verb->get_name());
    }
    return names;
}

std::vector<std::string> options_of(CLI::App const& verb) {
    std::vector<std::string> names;
    for (auto const* option : verb.get_options()) {
        for (auto const& name : option->get_lnames()) {
            names.push_back("--" + name);
        }
        for (auto const& name : option->get_snames()) {
            names.push_back("-" + name);
        }
    }
    return names;
}

}  // namespace

std::string explain(CLI::App const& app, CLI::ParseError const& error, int argc, char const* const* arguments) {
    auto const verbs = verbs_of(app);
    if (argc < 2) {
        return fmt::format("no verb (what shall be done?). {}", config::suggestion("", verbs));
    }
    std::string const first = arguments[1];
    if (first.front() != '-' && std::find(verbs.begin(), verbs.end(), first) == verbs.end()) {
        return fmt::format("verb '{}' (unknown). {}", first, config::suggestion(first, verbs));
    }
    auto const chosen = app.get_subcommands();
    auto const& verb = chosen.empty() ? app : *chosen.front();
    auto const help = chosen.empty() ? std::string("overturn --help") : fmt::format("overturn {} --help", first);
    for (auto const& extra : app.remaining(true)) {
        if (extra.size() > 1 && extra.front() == '-') {
            auto const name = extra.substr(0, extra.find('='));
            return fmt::format("option '{}' (unknown). {}", name, config::suggestion(name, options_of(verb)));
        }
        return fmt::format("'{}' (one argument too many). See {}", extra, help);
    }
    return fmt::format("{} (the command line is not understood). See {}", error.what(), help);
}

}  // namespace overturn::cli
