#include <algorithm>

#include <fmt/format.h>

#include "motion/claims.hpp"
#include "motion/detail/claim_words.hpp"
#include "motion/detail/vertical_token.hpp"
#include "motion/telling_words.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

/// The component names behind "comp", one each or one in two words ("N10E", "360 deg"); empty if any is none.
std::vector<std::string> components_behind(std::string_view text) {
    text = trimmed(text.substr(std::min(text.find_first_not_of(" \t:=."), text.size())));
    auto const known = [](std::string const& name) { return component_named(name).direction != Direction::unknown; };
    auto const parts = parted_at(text, " \t,;/");
    std::vector<std::string> words(parts.begin(), parts.end());
    constexpr std::size_t most = 3;
    if (!words.empty() && words.size() <= most && std::ranges::all_of(words, known)) {
        return words;
    }
    return !text.empty() && known(std::string(text)) ? std::vector{std::string(text)} : std::vector<std::string>{};
}

}  // namespace

bool Claims::take_components(std::string_view line, std::string const& lower, int number) {
    bool const earthscope = lower.starts_with("timeseries ")
                            && lower.find(" sps, ") != std::string::npos;  // whose reader knows its channel
    if (auto const token = vertical_token_in(lower); !token.empty() && vertical_line_ == 0 && !earthscope) {
        vertical_line_ = number;
        vertical_said_ =
            fmt::format("{} (it names '{}', so the accelerations may be vertical)", in_quotes(trimmed(line)), token);
    }
    for (std::string_view const key :
         {"components", "component", "comp", "direction", "dir", "channel", "orientation"}) {
        auto const at = lower.find(key);
        if (at == std::string::npos || !holds_word(lower, key)) {
            continue;
        }
        auto const found = components_behind(line.substr(at + key.size()));
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
