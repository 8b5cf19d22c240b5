#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "core/digit.hpp"
#include "motion/column_unit.hpp"
#include "motion/component_name.hpp"
#include "motion/detail/statement_words.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

using Text = std::string_view;

struct PeakKey {
    Text text;
    bool with_unit = false;  ///< of anything, unless a unit of the numbers stands behind the value
};
// The longer ones first.
constexpr auto keys_of_peaks = std::to_array<PeakKey>({{"peak ground acceleration"},
                                                       {"maximum ground acceleration"},
                                                       {"peak ground acc"},
                                                       {"peak acceleration"},
                                                       {"peak accel"},
                                                       {"peak acc"},
                                                       {"maximum acceleration"},
                                                       {"maximum accel"},
                                                       {"maximum acc"},
                                                       {"max. acceleration"},
                                                       {"max acceleration"},
                                                       {"max. accel"},
                                                       {"max accel"},
                                                       {"max. acc"},
                                                       {"max acc"},
                                                       {"pga"},
                                                       {"pha"},
                                                       {"peak value"},
                                                       {"maximum value", true},
                                                       {"peak", true},
                                                       {"maximum", true},
                                                       {"max", true},
                                                       {"amax", true},
                                                       {"largest", true}});

/// "(n-s) 13.2", "ns 13.2": from the value on; one component each, of which the first is read.
Text behind_component(Text text) {
    bool const bracket = text.starts_with('(') || text.starts_with('[');
    auto const end = bracket ? text.find_first_of(")]") : text.find_first_of(" \t:=");
    if (end == Text::npos) {
        return text;
    }
    auto const name = trimmed(text.substr(bracket ? 1 : 0, end - (bracket ? 1 : 0)));
    bool const letters = name.find_first_not_of("0123456789.+-") != Text::npos;
    return letters && direction_of(name) != Direction::unknown ? trimmed(text.substr(end + 1)) : text;
}

/// Is it the key's own colon: do neither figures outside of brackets nor commas stand before it?
bool is_own(Text before) {
    auto const bracket = before.find_first_of("([");
    auto const close = bracket == Text::npos ? bracket : before.find_first_of(")]", bracket);
    constexpr Text others = "0123456789,;";
    return before.substr(0, bracket).find_first_of(others) == Text::npos
           && (close == Text::npos || before.substr(close).find_first_of(others) == Text::npos);
}

/// Without words that name the peak further: "horizontal acceleration of 0.5 g".
Text without_fillings(Text text) {
    constexpr auto fillings = std::to_array<Text>(
        {"of",    "is",         "was",       "equals", "about",    "approx.",      "approx", "~",
         "circa", "horizontal", "absolute",  "ground", "recorded", "acceleration", "accel.", "accel",
         "acc.",  "acc",        "amplitude", "value",  "values",   "the",          "motion"});
    for (bool again = true; again;) {
        auto const word = text.substr(0, text.find_first_of(" \t"));
        again = std::ranges::find(fillings, word) != fillings.end() || (word.size() > 1 && word.starts_with('~'));
        text = again ? trimmed(text.substr(word.starts_with('~') ? 1 : word.size())) : text;
    }
    return text;
}

/// Behind the key's colon, or the blanks, brackets and words between it and a figure.
Text at_figure(Text behind) {
    auto const colon = behind.find_first_of(":=");
    if (colon != Text::npos && is_own(behind.substr(0, colon))) {
        return without_fillings(behind_component(trimmed(behind.substr(colon + 1))));
    }
    behind = without_fillings(trimmed(behind.substr(behind.starts_with('.') ? 1 : 0)));
    if (behind.starts_with('(') || behind.starts_with('[')) {
        behind = trimmed(behind.substr(std::min(behind.find_first_of(")]"), behind.size() - 1) + 1));
    }
    return without_fillings(behind_component(behind));
}

/// What stands behind a value, without the brackets around it.
Text unit_behind(Text text) {
    text = trimmed(text);
    text = text.substr(text.starts_with('(') || text.starts_with('[') ? 1 : 0);
    auto unit = text.substr(0, text.find_first_of(" \t,;)]"));
    while (unit.ends_with('.')) {
        unit.remove_suffix(1);
    }
    return unit;
}

/// Of the last digit in "13.20", "1.5e-2", ".028".
double digit_of(Text number) {
    auto const exponent_at = std::min(number.find('e'), number.size());
    auto const mantissa = number.substr(0, exponent_at);
    auto const point = mantissa.find('.');
    double exponent = 0;
    (void)parse_number(number.substr(std::min(exponent_at + 1, number.size())), exponent);
    auto const decimals = point == Text::npos ? 0.0 : static_cast<double>(mantissa.size() - point - 1);
    constexpr double most = 300;
    return std::pow(10.0, std::clamp(exponent - decimals, -most, most));
}

/// "(e-w) 12.163827 (u-d) 9.177727": what further components have.
std::vector<double> values_beside(Text text) {
    std::vector<double> found;
    for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
        text.remove_prefix(std::min(text.find_first_not_of(" ,;/"), text.size()));
        auto rest = behind_component(text);
        bool const named = rest.size() < text.size();
        rest.remove_prefix(rest.starts_with('-') || rest.starts_with('+') ? 1 : 0);
        auto const value = cut_number(rest);
        auto const word = text.substr(0, text.find_first_of(" ,;/"));
        if (named && value) {
            found.push_back(*value);
        }
        text = named && value ? rest : text.substr(word.size());
    }
    return found;
}

bool holds_any(Text line, std::span<Text const> words) {
    return std::ranges::any_of(words, [&](Text word) { return line.find(word) != Text::npos; });
}

bool is_rough(Text line) {
    constexpr auto words = std::to_array<Text>(
        {"raw", "uncorr", "unfiltered", "resultant", "vector", "about", "approx", "~", "circa", "nearly", "3d"});
    return holds_any(line, words);
}

bool is_of_others(Text line) {
    constexpr auto words = std::to_array<Text>(
        {"spectr",  "response", "scale",    "range",     "trigger",   "threshold", "sensor",  "sensitiv",
         "target",  "design",   "capacity", "clip",      "full",      "event",     "network", "rotd",
         "geomean", "psa",      "noise",    "sustained", "effective", "estimat",   "to-peak", "rank",
         "before",  "original", "scal",     "pre-",      "predicted", "expected",  "median",  "other"});
    return holds_any(line, words);
}

bool is_of_another(Text unit) {
    return unit_spelled(unit, Dimension::time) || unit_spelled(unit, Dimension::length)
           || unit_spelled(unit, Dimension::velocity) || unit_spelled(unit, Dimension::frequency);
}

}  // namespace

std::optional<PeakInText> peak_in(std::string_view line, Dimension dimension) {
    for (auto const& key : keys_of_peaks) {
        if (!holds_word(line, key.text)) {
            continue;
        }
        auto behind = at_figure(line.substr(line.find(key.text) + key.text.size()));
        behind = behind.substr(behind.starts_with('-') || behind.starts_with('+') ? 1 : 0);
        auto const printed = behind;
        auto const value = cut_number(behind);
        auto const text = unit_behind(behind);
        auto const unit = unit_spelled(text, dimension);
        if (value && (unit || (!key.with_unit && !is_of_another(text)))) {
            auto const number = printed.substr(0, printed.size() - behind.size());
            return PeakInText{
                *value, unit, digit_of(number), values_beside(behind), is_rough(line), is_of_others(line)};
        }
    }
    return std::nullopt;
}

bool states_value(std::string_view line, Dimension dimension) {
    for (std::size_t at = 0; at < line.size();) {
        bool const begins = is_digit(line[at]) && (at == 0 || Text(" \t(=:~").find(line[at - 1]) != Text::npos);
        auto rest = line.substr(at);
        auto const value = begins ? cut_number(rest) : std::nullopt;
        if (value && unit_spelled(unit_behind(rest), dimension)) {
            return true;
        }
        at += 1;
    }
    return false;
}

bool tells_peak(std::string_view line) {
    return std::ranges::any_of(keys_of_peaks, [&](PeakKey const& key) {
        auto const at = line.find(key.text);
        return !key.with_unit && holds_word(line, key.text)
               && line.find_first_of("0123456789", at + key.text.size()) != Text::npos;
    });
}

}  // namespace overturn
