#include "cli/command_line.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <system_error>
#include <type_traits>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/print_error.hpp"
#include "config/suggestion.hpp"
#include "core/error.hpp"
#include "core/units.hpp"
#include "core/wrapped.hpp"

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

// What is wrong with a command line, in our own words.
std::string explain(CLI::App const& app, CLI::ParseError const& error, int argc, char const* const* arguments) {
    auto const verbs = verbs_of(app);
    if (argc < 2) {
        return fmt::format("no verb (nothing to do). {}", config::suggestion("", verbs));
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

// "--set a=1 b=2" as "--set a=1 --set b=2". What is no more than a name, an option, or the name of a file ends it.
std::vector<std::string> with_each_setting(int argc, char const* const* arguments) {
    std::vector<std::string> words(arguments, arguments + argc);
    bool among = false;
    for (std::size_t i = 1; i < words.size(); ++i) {
        std::string const word = words[i];
        std::error_code ignored;
        bool const more = among && !word.starts_with('-') && word.find('=') != std::string::npos
                          && !std::filesystem::exists(word, ignored);
        if (more) {
            words.insert(words.begin() + static_cast<std::ptrdiff_t>(i), "--set");
        }
        bool const named = word == "--set";
        among = more || named || word.starts_with("--set=");
        i += more || named ? 1 : 0;  // its value, whatever that is
    }
    return words;
}

// A variable of the shell that is not set: the parser takes an option of it as one that was not given.
std::string empty_argument(std::vector<std::string> const& words) {
    for (std::size_t i = 1; i < words.size(); ++i) {
        auto const& word = words[i];
        bool const option_of_none = word.starts_with("--") && word.find('=') == word.size() - 1;
        if (word.empty() || option_of_none) {
            auto const name = option_of_none ? word.substr(0, word.size() - 1) : words[i - 1];
            bool const of_option = name.starts_with('-');
            return fmt::format("{}'' (empty: a shell variable that is not set?). State a value, or leave {} out",
                               of_option ? name + " " : "", of_option ? "the option" : "it");
        }
    }
    return {};
}

// Help whose lines fit a terminal.
class NarrowHelp : public CLI::Formatter {
    [[nodiscard]] std::string make_option_desc(CLI::Option const* option) const override {
        auto text = wrapped(option->get_description(), 0, line_width - column_width_);
        text.pop_back();  // the end of the last line, which the caller adds
        return text;
    }
};

// "30 %" as 0.3, where that is what a number was meant to be; empty: it is not.
std::string without_percent(std::string const& text) {
    auto const number = text.substr(0, text.find_last_not_of(" %") + 1);
    double percent = 0;
    constexpr double whole = 100;
    return text.ends_with('%') && parse_number(number, percent) ? fmt::format("{}", percent / whole) : std::string();
}

// Refuses a text that is no number, in our own words.
template <class Number> void check_number(CLI::Option& option, std::string const& names) {
    option.check([name = names.substr(0, names.find(','))](std::string const& text) {
        Number value{};
        if (!CLI::detail::lexical_cast(text, value)) {
            bool const whole = std::is_same_v<Number, std::int64_t>;
            auto const share = whole ? std::string() : without_percent(text);
            throw InputError(share.empty() ? fmt::format("{} '{}' (must be a {}number). Write one, for example {}",
                                                         name, text, whole ? "whole " : "", whole ? "10" : "0.3")
                                           : fmt::format("{} '{}' (must be a number). Write {}", name, text, share));
        }
        return std::string();
    });
}

template <class Value> struct Plain { using type = Value; };
template <class Value> struct Plain<std::optional<Value>> { using type = Value; };

template <class Value>
CLI::Option& declare(CLI::App& parser, std::string const& names, Value& value, std::string const& help) {
    if constexpr (std::is_same_v<Value, bool>) {
        return *parser.add_flag(names, value, help);
    } else {
        auto& option = *parser.add_option(names, value, help);
        if constexpr (std::is_arithmetic_v<typename Plain<Value>::type>) {
            check_number<typename Plain<Value>::type>(option, names);
        } else if constexpr (std::is_same_v<Value, std::vector<std::string>>) {
            option.allow_extra_args(option.get_positional());  // of an option one value each time it is given
        }
        return option;
    }
}

}  // namespace

template <class Value> void Verb::needs(std::string const& names, Value& value, std::string const& help) {
    declare(parser_, names, value, help).required();
}

template <class Value>
void Verb::takes(std::string const& names, Value& value, std::string const& help, std::string const& placeholder) {
    auto& option = declare(parser_, names, value, help);
    if (!placeholder.empty()) {
        option.option_text(placeholder);
    } else if constexpr (std::is_same_v<Value, std::string> || std::is_same_v<Value, double>) {
        if (value != Value{}) {
            option.capture_default_str();
        }
    }
}

void Verb::does(Action action) {
    parser_.callback([&chosen = chosen_, action = std::move(action)] { chosen = action; });
}

template void Verb::needs(std::string const&, std::string&, std::string const&);
template void Verb::needs(std::string const&, std::int64_t&, std::string const&);
template void Verb::takes(std::string const&, std::string&, std::string const&, std::string const&);
template void Verb::takes(std::string const&, std::int64_t&, std::string const&, std::string const&);
template void Verb::takes(std::string const&, double&, std::string const&, std::string const&);
template void Verb::takes(std::string const&, bool&, std::string const&, std::string const&);
template void Verb::takes(std::string const&, std::optional<std::string>&, std::string const&, std::string const&);
template void Verb::takes(std::string const&, std::optional<std::int64_t>&, std::string const&, std::string const&);
template void Verb::takes(std::string const&, std::optional<double>&, std::string const&, std::string const&);
template void Verb::takes(std::string const&, std::vector<std::string>&, std::string const&, std::string const&);

CommandLine::CommandLine(std::string const& description, std::string const& version)
    : parser_(std::make_unique<CLI::App>(description, "overturn")) {
    parser_->formatter(std::make_shared<NarrowHelp>());  // of every verb, too
    parser_->set_version_flag("--version", version);
    parser_->require_subcommand(1);
}

CommandLine::~CommandLine() = default;

Verb CommandLine::verb(std::string const& name, std::string const& help) {
    return {*parser_->add_subcommand(name, help), chosen_};
}

int CommandLine::run(int argc, char const* const* arguments) {
    try {
        auto words = with_each_setting(argc, arguments);
        if (auto const empty = empty_argument(words); !empty.empty()) {
            print_error_once(empty);
            return bad_input;
        }
        words.erase(words.begin(), words.begin() + std::min(argc, 1));
        std::ranges::reverse(words);  // as the parser takes them
        parser_->parse(words);
    } catch (CLI::Success const& help) {
        return parser_->exit(help);
    } catch (InputError const& error) {  // of a check of ours
        print_error_once(error.what());
        return bad_input;
    } catch (CLI::ParseError const& error) {
        print_error_once(explain(*parser_, error, argc, arguments));
        return bad_input;
    }
    return chosen_();
}

}  // namespace overturn::cli
