#include "motion/detail/other_quantities.hpp"

#include <algorithm>
#include <array>

#include "core/digit.hpp"
#include "core/units.hpp"

namespace overturn {
namespace {

using Text = std::string_view;

// Beginnings of words, so that "constrained" and "reinforced" are none of them; some in German, French, Spanish,
// Italian and Turkish.
constexpr auto beginnings = std::to_array<Text>({"strain",
                                                 "microstrain",
                                                 "stress",
                                                 "pressure",
                                                 "force",
                                                 "moment",
                                                 "torque",
                                                 "temperat",
                                                 "rotation",
                                                 "tilt",
                                                 "inclin",
                                                 "deform",
                                                 "settlement",
                                                 "deflect",
                                                 "curvature",
                                                 "intensit",
                                                 "energy",
                                                 "humid",
                                                 "voltage",
                                                 "coheren",
                                                 "gyro",
                                                 "dehnung",
                                                 "druck",
                                                 "kraft",
                                                 "presi\xC3\xB3n",
                                                 "presion",
                                                 "pression",
                                                 "fuerza",
                                                 "forza",
                                                 "temp\xC3\xA9rat",
                                                 "gerinim",
                                                 "gerilme",
                                                 "bas\xC4\xB1n\xC3\xA7",
                                                 "kuvvet",
                                                 "s\xC4\xB1"
                                                 "cakl\xC4\xB1k"});
constexpr auto phrases = std::to_array<Text>({"load cell", "water level", "ground water", "groundwater", "wave height",
                                              "water height", "wind speed", "drift ratio", "story drift",
                                              "storey drift", "base shear", "transfer function", "rocking angle"});
// Strain (two ways), load, pressure, stress, temperature, seismic intensity, voltage, angle; pressure, stress, strain
// of China.
constexpr auto signs = std::to_array<Text>(
    {"\xE3\x81\xB2\xE3\x81\x9A\xE3\x81\xBF", "\xE6\xAD\xAA", "\xE8\x8D\xB7\xE9\x87\x8D", "\xE5\x9C\xA7",
     "\xE5\xBF\x9C\xE5\x8A\x9B", "\xE6\xB8\xA9\xE5\xBA\xA6", "\xE9\x9C\x87\xE5\xBA\xA6", "\xE9\x9B\xBB\xE5\x9C\xA7",
     "\xE8\xA7\x92\xE5\xBA\xA6", "\xE5\x8E\x8B", "\xE5\xBA\x94\xE5\x8A\x9B", "\xE5\xBA\x94\xE5\x8F\x98"});
// No letter that is a direction or an acceleration elsewhere.
constexpr auto units = std::to_array<Text>({"pa",
                                            "kpa",
                                            "mpa",
                                            "psi",
                                            "ksi",
                                            "kn",
                                            "kip",
                                            "kips",
                                            "knm",
                                            "kn-m",
                                            "kn.m",
                                            "kn*m",
                                            "mv",
                                            "volt",
                                            "volts",
                                            "rad",
                                            "mrad",
                                            "rad/s",
                                            "deg/s",
                                            "mrad/s",
                                            "deg/sec",
                                            "rad/sec",
                                            "microstrain",
                                            "degc",
                                            "\xC2\xB0"
                                            "c"});
// Before or behind such a word: an earthquake's size, an instrument, what was done to the record.
constexpr auto others = std::to_array<Text>(
    {"magnitude", "seismic moment", "scalar moment", "moment tensor", "stress drop", "air force",
     "gauge",     "gage",           "sensor",        "transducer",    "instrument",  "accelero",
     "station",   "location",       "site",          "event",         "filter",      "max",
     "peak",      "scale",          "epicent",       "recorder",      "forced",      "intensity measure",
     "model",     "structure",      "profile",       "correct",       "remov"});

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || static_cast<unsigned char>(c) >= 0x80; }

template <class Words> bool holds_any(Text line, Words const& words) {
    return std::ranges::any_of(words, [&](Text word) { return line.find(word) != Text::npos; });
}

template <class Words> std::size_t end_of_any(Text line, Words const& words) {
    for (Text const word : words) {
        if (auto const at = line.find(word); at != Text::npos) {
            return at + word.size();
        }
    }
    return Text::npos;
}

/// Where the first such word ends; npos if there is none.
std::size_t end_of_word(Text lower) {
    for (Text const word : beginnings) {
        for (auto at = lower.find(word); at != Text::npos; at = lower.find(word, at + 1)) {
            if (at == 0 || !is_letter(lower[at - 1])) {
                auto end = at + word.size();
                while (end < lower.size() && is_letter(lower[end])) {
                    ++end;
                }
                return end;
            }
        }
    }
    auto const phrase = end_of_any(lower, phrases);
    return phrase == Text::npos ? end_of_any(lower, signs) : phrase;
}

Text at_value(Text text) {
    auto const at = text.find_first_not_of(" \t:=+-<>~,;");
    return at == Text::npos ? Text{} : text.substr(at);
}

/// Behind it, brackets, a colon or an equals sign apart, a number: one value is meant.
bool gives_a_value(Text behind) {
    auto rest = trimmed(behind);
    if (rest.starts_with('(') || rest.starts_with('[')) {
        auto const close = rest.find_first_of(")]");
        auto const inside = close == Text::npos ? Text{} : trimmed(rest.substr(close + 1));
        rest = inside.starts_with(':') || inside.starts_with('=') ? inside : rest;
    }
    rest = at_value(rest);
    return !rest.empty() && is_digit(rest[0]);
}

/// "Seismic intensity (JMA): 5.3", "Housner intensity (cm) 120", "intensity = VII": a fact about the record.
bool gives_an_intensity(Text lower) {
    constexpr Text word = "intensit";
    auto const at = lower.find(word);
    if (at == Text::npos) {
        return false;
    }
    auto rest = lower.substr(std::min(lower.find_first_not_of("yies", at + word.size()), lower.size()));
    auto const mark = rest.find_first_of(":=");
    if (mark != Text::npos) {
        rest = rest.substr(mark);
    } else if (trimmed(rest).starts_with('(')) {
        rest = rest.substr(std::min(rest.find(')'), rest.size() - 1) + 1);
    }
    rest = at_value(rest);
    auto const value = rest.substr(0, rest.find_first_of(" \t,;()+-"));
    bool const roman = !value.empty() && value.find_first_not_of("ivx") == Text::npos;
    return !value.empty() && (is_digit(value[0]) || (roman && (mark != Text::npos || value.size() > 1)));
}

bool is_other_unit(Text text) { return std::ranges::find(units, trimmed(text)) != units.end(); }

/// "(kPa)" without a value behind it, or a line that is nothing else.
bool has_other_unit(Text lower) {
    if (is_other_unit(lower.substr(std::min(lower.find_first_not_of(" \t#%!;"), lower.size())))) {
        return true;
    }
    for (auto open = lower.find_first_of("(["); open != Text::npos; open = lower.find_first_of("([", open + 1)) {
        auto const close = lower.find_first_of(")]", open);
        if (close == Text::npos) {
            return false;
        }
        if (is_other_unit(lower.substr(open + 1, close - open - 1)) && !gives_a_value(lower.substr(close + 1))) {
            return true;
        }
    }
    return false;
}

std::size_t words_in(Text lower) {
    std::size_t words = 0;
    bool inside = false;
    for (char const c : lower) {
        bool const part = is_letter(c) || is_digit(c);
        words += part && !inside ? 1 : 0;
        inside = part;
    }
    return words;
}

}  // namespace

bool names_other_quantity(std::string_view lower) { return end_of_word(lower) != Text::npos || is_other_unit(lower); }

bool labels_other_quantity(std::string_view lower) {
    constexpr std::size_t label = 6;  // words; more are a sentence, in which such words are of anything
    if (words_in(lower) > label || holds_any(lower, others) || gives_an_intensity(lower)) {
        return false;
    }
    auto const end = end_of_word(lower);
    return has_other_unit(lower) || (end != Text::npos && !gives_a_value(lower.substr(end)));
}

}  // namespace overturn
