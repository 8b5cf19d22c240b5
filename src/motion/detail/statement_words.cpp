#include "motion/detail/statement_words.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/digit.hpp"
#include "motion/column_unit.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

using Text = std::string_view;

constexpr Text number_letters = "0123456789.+-";

}  // namespace

std::optional<double> cut_number(std::string_view& text) {
    auto end = std::min(text.find_first_not_of(number_letters), text.size());
    if (end + 1 < text.size() && text[end] == 'e' && number_letters.find(text[end + 1]) != Text::npos) {
        end = std::min(text.find_first_not_of(number_letters, end + 1), text.size());
    }
    double value = 0;
    if (!parse_number(text.substr(0, end), value) || !(value > 0)) {
        return std::nullopt;
    }
    text = text.substr(end);
    if (!text.starts_with('/')) {
        return value;
    }
    auto divisor = text.substr(1);
    auto const parts = cut_number(divisor);
    if (parts) {
        text = divisor;
    }
    return parts ? value / *parts : value;
}

namespace {

/// The step that `text` says behind a key, with or without a unit in brackets, an equals sign or a colon: "(s): 0.005",
/// "= 5 ms", "of 200 Hz". [s]
/// \param strict no other unit may stand behind the number, and a colon or an equals sign must before it
std::optional<double> step_behind(Text text, bool is_rate, bool strict) {
    auto const step_of = [](double value, Text unit) -> std::optional<double> {
        auto const hertz = unit_spelled(unit, Dimension::frequency);
        auto const seconds = unit_spelled(unit, Dimension::time);
        return hertz ? std::optional(1 / (value * *hertz)) : seconds ? std::optional(value * *seconds) : std::nullopt;
    };
    std::string before;
    text = trimmed(text);
    if (strict && !text.starts_with('=') && !text.starts_with(':')) {
        return std::nullopt;
    }
    if (text.starts_with('(') || text.starts_with('[')) {
        auto const close = text.find_first_of(")]");
        before = text.substr(1, close == Text::npos ? close : close - 1);
        text = close == Text::npos ? Text{} : trimmed(text.substr(close + 1));
    } else if (auto const end = text.find_first_of(" \t:="); end != Text::npos && step_of(1, text.substr(0, end))) {
        before = text.substr(0, end);
        text = trimmed(text.substr(end));
    }
    for (Text const filling : {"of", "is", "=", ":", ",", ";"}) {
        text = trimmed(text.substr(text.starts_with(filling) ? filling.size() : 0));
    }
    auto const value = cut_number(text);
    if (!value) {
        return std::nullopt;
    }
    auto behind = trimmed(text);
    behind = behind.substr(0, behind.find_first_of(" \t,;)]."));
    if (!before.empty()) {
        return step_of(*value, before);
    }
    auto const stated = step_of(*value, behind);
    constexpr double longest_s = 1;
    if (strict && !stated && (!behind.empty() || (is_rate ? 1 / *value : *value) > longest_s)) {
        return std::nullopt;
    }
    return stated ? stated : is_rate ? 1 / *value : *value;
}

/// "200 samples per second", "200 sps". [s]
std::optional<double> step_before(Text line, std::size_t at) {
    auto const end = line.find_last_not_of(" \t", at == 0 ? 0 : at - 1);
    if (at == 0 || end == Text::npos) {
        return std::nullopt;
    }
    auto const begin = line.find_last_not_of(number_letters, end);
    auto number = line.substr(begin == Text::npos ? 0 : begin + 1, end - (begin == Text::npos ? 0 : begin + 1) + 1);
    auto const value = cut_number(number);
    return value && number.empty() ? std::optional(1 / *value) : std::nullopt;
}

struct Key {
    Text text;
    bool is_rate = false;
    bool may_be_other = false;  ///< "delta" is a distance, too
};
// The more telling ones first.
constexpr std::array keys{Key{"time increment"},
                          Key{"time step"},
                          Key{"timestep"},
                          Key{"time steps"},
                          Key{"time interval"},
                          Key{"sampling interval"},
                          Key{"sample interval"},
                          Key{"sampling period"},
                          Key{"sampling step"},
                          Key{"equally spaced at"},
                          Key{"intervals of"},
                          Key{"points at"},
                          Key{"delta t"},
                          Key{"deltat"},
                          Key{"dt"},
                          Key{"time delta"},
                          Key{"delta", false, true},
                          Key{"fs", true, true},
                          Key{"sps", true, true},
                          Key{"abtastrate", true},
                          Key{"abtastfrequenz", true},
                          Key{"zeitschritt"},
                          Key{"pas de temps"},
                          Key{"paso de tiempo"},
                          Key{"intervalo de tiempo"},
                          Key{"intervallo di campionamento"},
                          Key{"passo di campionamento"},
                          Key{"passo temporale"},
                          Key{"frequenza di campionamento", true},
                          Key{"fr\xC3\xA9quence d'\xC3\xA9"
                              "chantillonnage",
                              true},
                          Key{"\xC3\xB6rnekleme aral\xC4\xB1\xC4\x9F\xC4\xB1"},
                          Key{"\xC3\xB6rnekleme frekans\xC4\xB1", true},
                          Key{"\xE3\x82\xB5\xE3\x83\xB3\xE3\x83\x97\xE3\x83\xAA\xE3\x83\xB3\xE3\x82\xB0"
                              "\xE5\x91\xA8\xE6\xB3\xA2\xE6\x95\xB0",
                              true},
                          Key{"\xE3\x82\xB5\xE3\x83\xB3\xE3\x83\x97\xE3\x83\xAA\xE3\x83\xB3\xE3\x82\xB0"
                              "\xE9\x96\x93\xE9\x9A\x94"},
                          Key{"\xE9\x87\x87\xE6\xA0\xB7\xE9\xA2\x91\xE7\x8E\x87", true},
                          Key{"\xE9\x87\x87\xE6\xA0\xB7\xE7\x8E\x87", true},
                          Key{"\xE9\x87\x87\xE6\xA0\xB7\xE9\x97\xB4\xE9\x9A\x94"},
                          Key{"\xE6\x97\xB6\xE9\x97\xB4\xE9\x97\xB4\xE9\x9A\x94"},
                          Key{"sampling rate", true},
                          Key{"sample rate", true},
                          Key{"samplerate", true},
                          Key{"sampling frequency", true},
                          Key{"samples per second", true},
                          Key{"digitized at", true},
                          Key{"digitised at", true},
                          Key{"sampled at", true},
                          Key{"sampling:", true},
                          Key{"interval:"},
                          Key{"intervalo:"},
                          Key{"intervallo:"},
                          Key{"intervalo de muestreo"},
                          Key{"frecuencia de muestreo", true},
                          Key{"tasa de muestreo", true}};
constexpr std::array rates{"hz sampling",        "hz sample",  "pts/s",       "pts/sec",
                           "points/s",           "points/sec", "values/s",    "sps",
                           "samples per second", "samples/s",  "samples/sec", "samples/second"};

/// Behind these a rate or a step has its unit, "@200Hz", "every 5 ms"; a filter's has it too.
constexpr auto marks = std::to_array<Text>(
    {"@", "every", "fs", "sampling", "sampled", "recorded at", "steps of", "step of", "step", "interval"});

std::optional<double> step_with_unit(Text line) {
    constexpr auto others =
        std::to_array<Text>({"filter", "pass", "corner", "cut", "band", "natural", "reson", "full"});
    if (std::ranges::any_of(others, [&](Text word) { return line.find(word) != Text::npos; })) {
        return std::nullopt;
    }
    for (auto const mark : marks) {
        auto const at = line.find(mark);
        bool const inside = mark != "@" && at != Text::npos && at > 0 && is_small_letter(line[at - 1]);
        if (at == Text::npos || inside) {
            continue;
        }
        auto rest = line.substr(at + mark.size());
        rest = rest.substr(std::min(rest.find_first_not_of(" \t:="), rest.size()));
        auto const value = cut_number(rest);
        rest = trimmed(rest);
        auto const unit = rest.substr(0, rest.find_first_of(" \t,;)]."));
        auto const hertz = unit_spelled(unit, Dimension::frequency);
        auto const seconds = unit_spelled(unit, Dimension::time);
        if (value && (hertz || seconds)) {
            return hertz ? 1 / (*value * *hertz) : *value * *seconds;
        }
    }
    return std::nullopt;
}

/// Where `text` stands as words of their own.
std::size_t find_words(Text line, Text text) {
    for (auto at = line.find(text); at != Text::npos; at = line.find(text, at + 1)) {
        auto const end = at + text.size();
        if ((at == 0 || !is_small_letter(line[at - 1])) && (end == line.size() || !is_small_letter(line[end]))) {
            return at;
        }
    }
    return Text::npos;
}

}  // namespace

std::optional<double> step_in(std::string line) {
    std::ranges::replace(line, '_', ' ');
    for (auto const& key : keys) {
        if (auto const at = find_words(line, key.text); at != Text::npos) {
            if (auto const step = step_behind(Text(line).substr(at + key.text.size()), key.is_rate, key.may_be_other)) {
                return step;
            }
        }
    }
    for (Text const rate : rates) {
        if (auto const at = find_words(line, rate); at != Text::npos) {
            if (auto const step = step_before(line, at)) {
                return step;
            }
        }
    }
    return step_with_unit(line);
}

namespace {

constexpr std::array count_keys{"npts",
                                "number of points",
                                "number of data",
                                "number of samples",
                                "number of values",
                                "no. of points",
                                "no of points",
                                "no. of data",
                                "no. of samples",
                                "no. of values",
                                "num. of points",
                                "nsamples",
                                "num points",
                                "sample count",
                                "data points",
                                "number of acceleration data",
                                "numero de muestras",
                                "n\xC3\xBAmero de muestras",
                                "ndata"};
constexpr std::array counted{"samples", "points", "pts", "values", "data points"};

std::optional<std::size_t> whole(Text digits) {
    constexpr double most = 1e12;
    double value = 0;
    bool const read = parse_number(digits, value) && value >= 1 && value <= most && value == std::floor(value);
    return read ? std::optional(static_cast<std::size_t>(value)) : std::nullopt;
}

/// "200 samples per second" counts nothing.
bool is_rate(Text behind) {
    behind = trimmed(behind);
    return behind.starts_with("per") || behind.starts_with("/");
}

}  // namespace

std::optional<std::size_t> count_in(std::string line) {
    std::ranges::replace(line, '_', ' ');
    for (Text const key : count_keys) {
        if (auto const at = find_words(line, key); at != Text::npos) {
            auto behind = Text(line).substr(at + key.size());
            behind = behind.substr(std::min(behind.find_first_not_of(" \t:=()"), behind.size()));
            if (auto const count = whole(behind.substr(0, behind.find_first_of(" \t,;")))) {
                return count;
            }
        }
    }
    for (Text const word : counted) {
        auto const at = find_words(line, word);
        if (at == Text::npos || at == 0 || is_rate(Text(line).substr(at + word.size()))) {
            continue;
        }
        auto const before = trimmed(Text(line).substr(0, at));
        auto const begin = before.find_last_not_of("0123456789");
        auto const digits = begin == Text::npos ? before : before.substr(begin + 1);
        bool const alone = begin == Text::npos || Text(" \t,(=:").find(before[begin]) != Text::npos;
        if (auto const count = whole(digits); count && alone) {
            return count;
        }
    }
    return std::nullopt;
}

bool holds_word(Text line, Text word) { return find_words(line, word) != Text::npos; }

}  // namespace overturn
