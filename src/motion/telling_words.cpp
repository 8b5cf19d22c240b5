#include "motion/telling_words.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "core/digit.hpp"
#include "core/units.hpp"
#include "motion/column_unit.hpp"
#include "motion/component_name.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

using Text = std::string_view;

std::vector<Text> words_of(Text lower) { return parted_at(lower, " \t_./,:;()[]{}=\"'#%!*|"); }

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
    return at != Text::npos && at > 0 && at + 1 < lower.size() && is_digit(lower[at - 1]) && lower[at + 1] >= 'a'
           && lower[at + 1] <= 'z';
}

/// "x 100", "* 9.81", "\xC3\x97 2": a sign of multiplication before a figure, and none of a size before it.
bool is_multiplied(Text lower) {
    for (Text const sign : {" x ", "*", "\xC3\x97"}) {
        for (auto at = lower.find(sign); at != Text::npos; at = lower.find(sign, at + 1)) {
            auto const behind = trimmed(lower.substr(at + sign.size()));
            auto const before = trimmed(lower.substr(0, at));
            bool const power =
                sign == "*" && (lower.substr(at + 1).starts_with('*') || lower.substr(0, at).ends_with('*'));
            bool const size = sign == " x " && !before.empty() && is_digit(before.back());
            if (!power && !size && !behind.empty() && is_digit(behind.front())) {
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
        if (!before.empty() && is_digit(before.back())) {
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
    for (auto const word : parted_at(part, " \t:=#%!*.\"'()[]")) {
        if (std::ranges::find(fillings, word) == fillings.end()) {
            rest += (rest.empty() ? "" : " ") + std::string(word);
        }
    }
    return rest;
}

/// Without the unit in it.
std::string without_unit(Text name) {
    constexpr std::array dimensions{Dimension::acceleration, Dimension::velocity, Dimension::length, Dimension::time,
                                    Dimension::frequency};
    auto const [text, bracketed] = unit_text_in_name(name);
    bool const unit = !text.empty() && std::ranges::any_of(dimensions, [&, unit = text](Dimension dimension) {
        return unit_spelled(unit, dimension).has_value();
    });
    std::string rest(name);
    return unit ? rest.erase(text.data() - name.data(), text.size()) : rest;
}

bool has_figure(Text word) { return word.find_first_of("0123456789") != Text::npos; }

/// "Sa_vertical" and "SaZ" in lower case, word by word; "S_v" is one.
std::vector<std::string> words_of_name(Text name) {
    std::vector<std::string> words;
    for (auto const part : parted_at(name, " \t_-./:,;()[]{}=\"'|")) {
        bool const of_letter =
            words.size() == 1 && (words[0] == "s" || words[0] == "ps") && part.size() <= 2 && !has_figure(part);
        std::size_t begin = 0;
        for (std::size_t i = 1; i <= part.size(); ++i) {
            bool const in_rotd = lowered(part.substr(begin, i - begin)).ends_with("rot");
            bool const rises = i < part.size() && part[i - 1] >= 'a' && part[i - 1] <= 'z' && part[i] >= 'A'
                               && part[i] <= 'Z' && !in_rotd;
            if (i == part.size() || rises) {
                words.push_back(lowered(part.substr(begin, i - begin)));
                begin = i;
            }
        }
        if (of_letter) {
            words[0] += words[1];
            words.pop_back();
        }
    }
    return words;
}

/// Of a word behind the first, or of what follows "sa" or "psv" in the first: "z", "84", "vert".
bool changes_values(Text word) {
    constexpr auto known = std::to_array<Text>(
        {"rotd00", "rotd50", "rotd100", "gmrotd50", "gmrotd100", "gmroti50", "t0", "t1", "h1", "h2"});
    constexpr auto statistics = std::to_array<Text>(
        {"avg",      "ave", "average", "eps", "epsilon", "upper", "lower", "max",  "min",        "plus", "minus",
         "envelope", "pc",  "ratio",   "res", "delta",   "error", "err",   "diff", "difference", "nep"});
    if (std::ranges::find(known, word) != known.end()) {
        return false;
    }
    return word == "z" || word == "v" || is_vertical(direction_of(word)) || has_figure(word) || tells_factor(word)
           || tells_statistic(word) || tells_other_spectrum(word)
           || std::ranges::find(statistics, word) != statistics.end();
}

}  // namespace

bool tells_no_response(Text lower) {
    constexpr auto parts = std::to_array<Text>({"fourier", "power spectr", "periodogram"});
    constexpr auto words = std::to_array<Text>({"fas", "hvsr"});
    return holds_any(lower, parts) || holds_word_of(lower, words);
}

bool tells_other_spectrum(Text lower) {
    constexpr auto parts =
        std::to_array<Text>({"floor", "in-structure", "in structure", "instructure", "inelastic", "ductility"});
    constexpr auto words = std::to_array<Text>({"frs", "isrs"});
    return tells_no_response(lower) || holds_any(lower, parts) || holds_word_of(lower, words);
}

bool tells_more_in_name(Text name) {
    constexpr auto vertical = std::to_array<Text>({"sve", "svd", "svert"});  // of Eurocode 8
    auto const words = words_of_name(without_unit(name));
    for (std::size_t i = 0; i < words.size(); ++i) {
        Text word = words[i];
        if (i > 0 ? changes_values(word) : tells_factor(word) || tells_statistic(word) || tells_other_spectrum(word)) {
            return true;
        }
        if (i == 0
            && (std::ranges::find(vertical, word) != vertical.end()
                || (words.size() > 1 && (word == "v" || word == "delta" || word == "z")))) {
            return true;
        }
        constexpr auto kinds = std::to_array<Text>({"psa", "psv", "sa", "sv", "sd", "se"});
        auto const* const kind =
            std::ranges::find_if(kinds, [&](Text each) { return i == 0 && word.starts_with(each); });
        if (kind != kinds.end() && word.size() > kind->size() && changes_values(word.substr(kind->size()))) {
            return true;
        }
    }
    return !words.empty() && words[0].size() > 1 && is_vertical(direction_of(words[0]));
}

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

bool tells_change(Text lower) {
    constexpr auto parts =
        std::to_array<Text>({"invert", "revers", "polarity", "negative", "decimat", "differentiat", "derivative",
                             "every second", "every other", "every third", "resultant", "tenth"});
    constexpr auto seconds = std::to_array<Text>({"s", "sec", "secs", "second", "seconds"});
    auto const time = lower.find("time in ");
    auto const unit = time == Text::npos ? std::vector<Text>{} : words_of(lower.substr(time + Text("time in ").size()));
    bool const scaled = !unit.empty() && std::ranges::find(seconds, unit.front()) == seconds.end();
    bool const pseudo = lower.find("pseudo") != Text::npos && lower.find("spectr") == Text::npos;
    bool const gravity = lower.find("gravity") != Text::npos && lower.find("unit") == Text::npos;
    return scaled || pseudo || gravity || holds_any(lower, parts);
}

bool tells_other_values(Text name) {
    constexpr auto others = std::to_array<Text>(
        {"inverted",   "reversed", "flipped",  "neg",   "negative",   "floor", "roof",  "error",      "err",
         "std",        "sigma",    "residual", "noise", "envelope",   "env",   "abs",   "sum",        "diff",
         "difference", "delta",    "norm",     "int",   "integrated", "cum",   "cumul", "cumulative", "vel",
         "disp",       "angular",  "pga",      "peak",  "max",        "min",   "mean",  "avg",        "ratio"});
    return trimmed(name).starts_with('-') || std::ranges::any_of(words_of_name(name), [&](Text word) {
               return std::ranges::find(others, word) != others.end();
           });
}

bool holds_open_figure(Text lower) {
    constexpr auto sizes = std::to_array<Text>({"m", "mw", "ms", "ml", "mb", "magnitude"});
    auto const words = parted_at(lower, " \t()[]=#");
    for (std::size_t i = 0; i < words.size(); ++i) {
        auto const word = words[i];
        constexpr std::size_t digits_of_a_year = 4;
        bool const figures = word.find_first_not_of("0123456789") == Text::npos;
        bool const year =
            figures && word.size() == digits_of_a_year && (word.starts_with("19") || word.starts_with("20"));
        bool const name = !is_digit(word.front()) && Text("+-.").find(word.front()) == Text::npos;
        bool const date =
            std::ranges::count(word, '-') + std::ranges::count(word, '/') >= 2 || word.find(':') < word.size();
        bool const size = i > 0 && std::ranges::find(sizes, words[i - 1]) != sizes.end();
        bool const away = i + 1 < words.size() && words[i + 1] == "km";
        bool const place = Text("new").find(word.back()) != Text::npos
                           && word.substr(0, word.size() - 1).find_first_not_of("0123456789.") == Text::npos;
        if (has_figure(word) && !(place || year || name || date || size || away)) {
            return true;
        }
    }
    return false;
}

bool tells_rate(Text lower) {
    return std::ranges::any_of(words_of(lower), [](Text word) {
        bool const alone = word == "hz";
        return alone || (word.ends_with("hz") && is_digit(word.front()));
    });
}

bool tells_vertical(Text lower) { return std::ranges::any_of(words_of(lower), names_vertical); }

std::string vertical_alone_in(Text lower) {
    std::vector<std::string> named;
    auto const is_unit = [](Text part) { return unit_spelled(part, Dimension::acceleration).has_value(); };
    auto const parts = parted_at(lower, ",;|#%!");
    bool const beside_unit = std::ranges::any_of(parts, [&](Text part) { return is_unit(trimmed(part)); });
    for (auto const part : parted_at(lower, ",;|:=")) {
        auto rest = without_fillings(part);
        bool const letters = std::ranges::any_of(rest, [](char c) { return c < '0' || c > '9'; });
        bool const letter = beside_unit && rest.size() == 1 && Text("zvunehxy").find(rest) != Text::npos;
        if (letters && (rest.size() > 1 || letter) && component_named(rest).direction != Direction::unknown) {
            named.push_back(std::move(rest));
        }
    }
    return named.size() == 1 && is_vertical(direction_of(named.front())) ? named.front() : std::string();
}

}  // namespace overturn
