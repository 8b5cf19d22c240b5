#include <algorithm>

#include <fmt/format.h>

#include "motion/detail/statement_words.hpp"
#include "motion/detail/vertical_token.hpp"
#include "motion/telling_words.hpp"
#include "motion/text_lines.hpp"
#include "motion/text_statements.hpp"

namespace overturn {
namespace {

/// The component names behind "comp", one each or one in two words ("N10E", "360 deg"); empty if any is none.
std::vector<std::string> components_behind(std::string_view text) {
    text = trimmed(text.substr(std::min(text.find_first_not_of(" \t:=."), text.size())));
    auto const known = [](std::string const& name) {
        bool const number = name.size() == 1 && name[0] >= '1' && name[0] <= '9';  // of a channel
        return !number && component_named(name).direction != Direction::unknown;
    };
    auto const parts = parted_at(text, " \t,;/");
    std::vector<std::string> words(parts.begin(), parts.end());
    constexpr std::size_t most = 3;
    constexpr std::size_t azimuth_digits = 3;  // fewer before a word number a channel
    bool const numbered = words.size() > 1 && words[0].size() < azimuth_digits
                          && words[0].find_first_not_of("0123456789") == std::string::npos;
    if (!words.empty() && words.size() <= most && !numbered && std::ranges::all_of(words, known)) {
        return words;
    }
    return !text.empty() && known(std::string(text)) ? std::vector{std::string(text)} : std::vector<std::string>{};
}

/// Without that of a channel: " 3: UD" is " UD".
std::string_view without_number(std::string_view text) {
    constexpr std::size_t most = 2;  // digits; an azimuth has three
    auto const rest = text.substr(std::min(text.find_first_not_of(" \t:=.#"), text.size()));
    auto const end = std::min(rest.find_first_not_of("0123456789"), rest.size());
    return end > 0 && end <= most ? rest.substr(end) : std::string_view{};
}

}  // namespace

bool TextStatements::take_components(std::string_view line, std::string const& lower, int number) {
    for (auto const& name : compass_words_in(line)) {
        all_components_.emplace_back(name, number);
    }
    bool const earthscope = lower.starts_with("timeseries ")
                            && lower.find(" sps, ") != std::string::npos;  // whose reader knows its channel
    if (auto const token = vertical_token_in(lower); !token.empty() && vertical_line_ == 0 && !earthscope) {
        vertical_line_ = number;
        vertical_text_ =
            fmt::format("{} (it names '{}', so the accelerations may be vertical)", in_quotes(trimmed(line)), token);
    }
    for (std::string_view const key :
         {"components", "component", "comp", "direction", "dir", "channel", "orientation", "componente", "composante",
          "komponente", "canal", "richtung", "direccion", "bile\u015Fen"}) {
        auto const at = lower.find(key);
        if (at == std::string::npos || !holds_word(lower, key)) {
            continue;
        }
        auto const behind = line.substr(at + key.size());
        auto const found = components_behind(behind);
        for (auto const& name : found.empty() ? components_behind(without_number(behind)) : found) {
            all_components_.emplace_back(name, number);
        }
        if (!found.empty() && components_.empty()) {
            components_ = found;
            components_line_ = number;
        }
        if (!found.empty()) {
            return true;
        }
    }
    auto const vertical = vertical_alone_in(lower);
    if (!vertical.empty() && components_.empty()) {
        components_ = {vertical};
        components_line_ = number;
    }
    return !vertical.empty();
}

}  // namespace overturn
