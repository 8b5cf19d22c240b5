#include "motion/telling_words.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "core/units.hpp"
#include "motion/component_name.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

using Text = std::string_view;

std::vector<Text> split(Text text, Text separators) {
    std::vector<Text> parts;
    for (std::size_t at = 0; at < text.size();) {
        at = std::min(text.find_first_not_of(separators, at), text.size());
        auto const end = std::min(text.find_first_of(separators, at), text.size());
        if (end > at) {
            parts.push_back(text.substr(at, end - at));
        }
        at = end;
    }
    return parts;
}

std::vector<Text> words_of(Text lower) { return split(lower, " \t_./,:;()[]{}=\"'#%!*|"); }

bool holds_any(Text lower, std::span<Text const> parts) {
    return std::ranges::any_of(parts, [&](Text part) { return lower.find(part) != Text::npos; });
}

bool holds_word_of(Text lower, std::span<Text const> words) {
    auto const found = words_of(lower);
    return std::ranges::any_of(words, [&](Text word) { return std::ranges::find(found, word) != found.end(); });
}

/// "x100", "100*a"
bool is_factor_at_once(Text lower) {
    for (auto const word : words_of(lower)) {
        if (word.size() > 1 && word.front() == 'x' && word.find_first_not_of("0123456789.", 1) == Text::npos) {
            return true;
        }
    }
    auto const at = lower.find('*');
    return at != Text::npos && at > 0 && at + 1 < lower.size() && lower[at - 1] >= '0' && lower[at - 1] <= '9'
           && lower[at + 1] >= 'a' && lower[at + 1] <= 'z';
}

/// "x 100", "* 9.81", "\xC3\x97 2": a sign of multiplication before a figure, and none of a size before it.
bool is_multiplied(Text lower) {
    for (Text const sign : {" x ", "*", "\xC3\x97"}) {
        for (auto at = lower.find(sign); at != Text::npos; at = lower.find(sign, at + 1)) {
            auto const behind = trimmed(lower.substr(at + sign.size()));
            auto const before = trimmed(lower.substr(0, at));
            bool const power =
                sign == "*" && (lower.substr(at + 1).starts_with('*') || lower.substr(0, at).ends_with('*'));
            bool const size = sign == " x " && !before.empty() && before.back() >= '0' && before.back() <= '9';
            if (!power && !size && !behind.empty() && behind.front() >= '0' && behind.front() <= '9') {
                return true;
            }
        }
    }
    return false;
}

/// "50 % of the original"; a comment's own mark is none.
bool is_percent(Text lower) {
    for (auto at = lower.find('%'); at != Text::npos; at = lower.find('%', at + 1)) {
        auto const before = trimmed(lower.substr(0, at));
        if (!before.empty() && before.back() >= '0' && before.back() <= '9') {
            return true;
        }
    }
    return false;
}

bool names_vertical(Text word) { return word.size() > 1 && is_vertical(direction_of(word)); }

/// Without the words that say no direction: "up-down component" is "up-down".
std::string without_fillings(Text part) {
    constexpr std::array<Text, 12> fillings{"component", "comp",          "channel",      "direction",
                                            "dir",       "orientation",   "motion",       "recorded",
                                            "ground",    "accelerations", "acceleration", "acc"};
    std::string rest;
    for (auto const word : split(part, " \t:=#%!*.\"'()[]")) {
        if (std::ranges::find(fillings, word) == fillings.end()) {
            rest += (rest.empty() ? "" : " ") + std::string(word);
        }
    }
    return rest;
}

}  // namespace

bool tells_factor(Text lower) {
    constexpr auto parts = std::to_array<Text>(
        {"amplif", "reduced",   "compress",   "scaled",     "scaling",    "scale factor", "multipl", "divid", "divisor",
         "factor", "normali",   "relative",   "thousandth", "hundredth",  "twice",        "doubl",   "halv",  "half ",
         "gain",   "times the", "conversion", "unit =",     "units of 0", "units of 1",   "rel. "});
    return holds_any(lower, parts) || is_multiplied(lower) || is_factor_at_once(lower);
}

bool tells_share(Text lower) {
    constexpr std::array<Text, 2> parts{"percent", "per cent"};
    return holds_any(lower, parts) || is_percent(lower);
}

bool tells_other_quantity(Text lower) {
    constexpr std::array<Text, 3> parts{"veloc", "displac", "fourier"};
    constexpr std::array<Text, 6> words{"vel", "disp", "displ", "counts", "raw", "adc"};
    return holds_any(lower, parts) || holds_word_of(lower, words);
}

bool tells_statistic(Text lower) {
    constexpr std::array<Text, 8> parts{"percentile", "fractile",      "quantile",    "sigma",
                                        "median",     "best estimate", "upper bound", "lower bound"};
    constexpr std::array<Text, 5> words{"p05", "p16", "p50", "p84", "p95"};
    return holds_any(lower, parts) || holds_word_of(lower, words);
}

bool tells_other_span(Text lower) {
    constexpr std::array<Text, 7> parts{"month", "centur", "decade", "per day", "daily", "lifetime", "per 100"};
    return holds_any(lower, parts);
}

bool tells_rate(Text lower) {
    return std::ranges::any_of(words_of(lower), [](Text word) {
        bool const alone = word == "hz";
        return alone || (word.ends_with("hz") && word.front() >= '0' && word.front() <= '9');
    });
}

bool tells_vertical(Text lower) { return std::ranges::any_of(words_of(lower), names_vertical); }

std::string vertical_alone_in(Text lower) {
    std::vector<std::string> named;
    for (auto const part : split(lower, ",;|:=")) {
        auto rest = without_fillings(part);
        bool const letters = std::ranges::any_of(rest, [](char c) { return c < '0' || c > '9'; });
        if (letters && rest.size() > 1 && component_named(rest).direction != Direction::unknown) {
            named.push_back(std::move(rest));
        }
    }
    return named.size() == 1 && names_vertical(named.front()) ? named.front() : std::string();
}

}  // namespace overturn
