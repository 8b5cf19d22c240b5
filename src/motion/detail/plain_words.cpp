#include "motion/detail/plain_words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/digit.hpp"
#include "motion/column_unit.hpp"
#include "motion/component_name.hpp"
#include "motion/detail/quantity_words.hpp"
#include "motion/detail/statement_words.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

using Text = std::string_view;

constexpr auto quantity_names = std::to_array<Text>({"a",
                                                     "acc",
                                                     "amplitude",
                                                     "amplitudes",
                                                     "ordinate",
                                                     "ordinates",
                                                     "sa",
                                                     "psa",
                                                     "se",
                                                     "pga",
                                                     "ag",
                                                     "im",
                                                     "iml",
                                                     "imls",
                                                     "intensity",
                                                     "intensities",
                                                     "level",
                                                     "levels",
                                                     "measure",
                                                     "spectral",
                                                     "response",
                                                     "spectrum",
                                                     "spectra",
                                                     "pseudo",
                                                     "absolute",
                                                     "elastic",
                                                     "design",
                                                     "target",
                                                     "uniform",
                                                     "hazard",
                                                     "curve",
                                                     "uhs",
                                                     "ground",
                                                     "motion",
                                                     "motions",
                                                     "vel",
                                                     "velocity",
                                                     "velocities",
                                                     "sv",
                                                     "psv",
                                                     "pgv",
                                                     "disp",
                                                     "displ",
                                                     "sd",
                                                     "displacement",
                                                     "displacements",
                                                     "energy",
                                                     "strong",
                                                     "rotd50",
                                                     "geomean",
                                                     "horizontal",
                                                     "annual",
                                                     "exceedance",
                                                     "frequency",
                                                     "exceedances",
                                                     "collapse",
                                                     "capacity",
                                                     "capacities",
                                                     "ive",
                                                     "damping",
                                                     "damped",
                                                     "ivme",
                                                     "aceleraci\xC3\xB3n",
                                                     "aceleracion",
                                                     "beschleunigung"});
constexpr auto filling_words = std::to_array<Text>(
    {"unit",          "units",     "in",       "of",        "the",        "are",         "is",
     "all",           "data",      "value",    "values",    "column",     "columns",     "component",
     "components",    "comp",      "channel",  "direction", "dir",        "history",     "histories",
     "series",        "record",    "records",  "recorded",  "corrected",  "uncorrected", "and",
     "below",         "following", "these",    "given",     "expressed",  "numbers",     "number",
     "with",          "at",        "for",      "time",      "timeseries", "as",          "accelerogram",
     "accelerograms", "si",        "here",     "einheit",   "einheiten",  "unidad",      "unidades",
     "samples",       "this",      "en",       "de",        "del",        "la",          "las",
     "les",           "des",       "der",      "die",       "und",        "valores",     "valeurs",
     "werte",         "sample",    "points",   "npts",      "equal",      "equally",     "spaced",
     "intervals",     "rows",      "row",      "period",    "periods",    "t",           "orientation",
     "waveform",      "s",         "sec",      "seconds",   "table",      "above",       "first",
     "second",        "type",      "quantity", "written",   "stated"});
/// Of a step or rate that the line states, or a damping.
constexpr auto of_steps = std::to_array<Text>(
    {"step", "steps", "dt",    "delta", "rate", "sampling", "increment", "hz",        "sps",       "interval",
     "per",  "fs",    "every", "ms",    "khz",  "sampled",  "deltat",    "digitized", "digitised", "timestep"});
/// These in any clause of a line, and its unit is none of the numbers.
constexpr auto denials =
    std::to_array<Text>({"not",        "never",    "convert",  "converted",  "conversion", "unless",    "except",
                         "instead",    "replaced", "previous", "previously", "formerly",   "companion", "multiply",
                         "multiplied", "divide",   "divided",  "resolution", "noise",      "accuracy",  "removed"});

template <class Words> bool is_among(Text word, Words const& words) {
    return std::ranges::find(words, word) != words.end();
}

std::vector<Text> plain_words_of(Text clause) {
    auto words = parted_at(clause, " \t:=()[]\"#!|,;");
    for (auto& word : words) {
        word.remove_suffix(word.ends_with('.') ? 1 : 0);
    }
    std::erase_if(words, [](Text word) { return word.find_first_not_of("-_.") == Text::npos; });
    if (!words.empty() && clause.starts_with("% ") && words.front() == "%") {
        words.erase(words.begin());
    }
    return words;
}

/// Parted at semicolons, at commas that no figure surrounds, and behind a sentence.
std::vector<Text> clauses_of(Text line) {
    std::vector<Text> found;
    auto const digit_at = [&](std::size_t at) { return at < line.size() && is_digit(line[at]); };
    std::size_t begin = 0;
    for (std::size_t i = 0; i <= line.size(); ++i) {
        bool const mark = i == line.size() || line[i] == ';' || line[i] == ','
                          || (line[i] == '.' && i + 1 < line.size() && line[i + 1] == ' ' && i > begin + 4);
        if (mark && !(i > 0 && digit_at(i - 1) && digit_at(i + 1))) {
            found.push_back(line.substr(begin, i - begin));
            begin = i + 1;
        }
    }
    return found;
}

/// The longest unit of several words that begins at `words[i]`; its length is how many it takes.
struct SpelledUnit {
    double si = 0;
    std::size_t length = 0;
    std::string text = {};
};
SpelledUnit unit_at(std::vector<Text> const& words, std::size_t i, Dimension dimension) {
    constexpr std::size_t most = 5;  // "metre per second per second"
    SpelledUnit found;
    std::string text;
    for (std::size_t n = 0; n < most && i + n < words.size(); ++n) {
        text += (n > 0 ? " " : "") + std::string(words[i + n]);
        if (auto const si = unit_spelled(text, dimension)) {
            found = {*si, n + 1, text};
        }
    }
    return found;
}

/// A figure of the step, the rate, the count or the damping that the line states?
bool is_accounted(Text word, Text clause) {
    double value = 0;
    auto const end = std::min(word.find_first_not_of("0123456789.e-+"), word.size());
    if (!parse_number(word.substr(0, end), value)) {
        return false;
    }
    auto const behind = word.substr(end);
    bool const plain =
        behind.empty() || is_among(behind, of_steps) || behind == "s" || behind == "sec" || behind == "%";
    auto const step = step_in(std::string(clause));
    bool const of_step =
        step
        && (same_as_printed(value, *step) || same_as_printed(1 / value, *step) || same_as_printed(value / 1e3, *step));
    auto const count = count_in(std::string(clause));
    bool const of_count = count && value == static_cast<double>(*count);
    constexpr double highest = 30;
    bool const damped = clause.find("damp") != Text::npos && value <= highest;
    return plain && (of_step || of_count || damped);
}

/// In any language; "accelerometer" is none, and "accelaration" is meant for one.
bool is_acceleration(Text word) {
    bool const instrument = word.starts_with("accelero") && !word.starts_with("accelerogram");
    return !instrument && quantity_in_name(word) == Quantity::acceleration;
}

/// "8f10.3", "5e14.7"
bool is_number_format(Text word) {
    auto const letter = word.find_first_of("fe");
    return letter != Text::npos && word.find('.', letter) != Text::npos
           && word.substr(0, letter).find_first_not_of("0123456789") == Text::npos
           && word.substr(letter + 1).find_first_not_of("0123456789.") == Text::npos;
}

bool is_known_word(Text word, Text clause) {
    auto const known = [&](Text part) {
        return is_among(part, quantity_names) || is_among(part, filling_words) || is_acceleration(part)
               || (part.size() < word.size() ? false : is_accounted(part, clause))
               || (step_in(std::string(clause)) && is_among(part, of_steps))
               || (clause.find("damp") != Text::npos && (part == "%" || part == "percent"))
               || (part.find_first_of("0123456789") == Text::npos
                   && component_named(part).direction != Direction::unknown);
    };
    auto const parts = parted_at(word, "-_");
    return known(word) || is_number_format(word) || (parts.size() > 1 && std::ranges::all_of(parts, known))
           || (!is_digit(word.front()) && component_named(word).direction != Direction::unknown);
}

/// "9.81 m/s2": says nothing of other numbers.
bool is_quantity_at(Text word, Text clause) {
    auto const before = trimmed(clause.substr(0, word.data() - clause.data()));
    return !before.empty() && is_digit(before.back());
}

struct PlainClause {
    bool any = false;
    bool known = true;
};

PlainClause read_clause(Text clause, Dimension dimension, UnitClauses& found) {
    auto const words = plain_words_of(clause);
    PlainClause read;
    for (std::size_t i = 0; i < words.size();) {
        auto const unit = unit_at(words, i, dimension);
        bool const word_alone = unit.length == 1 && is_among(words[i], filling_words);  // "in" of inches
        if (unit.length == 0 || word_alone) {
            read.known = read.known && is_known_word(words[i], clause);
            ++i;
            continue;
        }
        if (is_quantity_at(words[i], clause)) {
            read.known = false;
            i += unit.length;
            continue;
        }
        read.any = true;
        found.name = found.name.empty() ? unit.text : found.name;
        if (std::ranges::none_of(found.units, [&](double si) { return same_as_printed(si, unit.si); })) {
            found.units.push_back(unit.si);
        }
        i += unit.length;
    }
    return read;
}

}  // namespace

UnitClauses unit_clauses(std::string_view lower, Dimension dimension) {
    UnitClauses found;
    auto line = trimmed(lower);
    line = line.substr(std::min(line.find_first_not_of("#!*"), line.size()));
    bool denied = false;
    for (auto const clause : clauses_of(line)) {
        auto const read = read_clause(trimmed(clause), dimension, found);
        found.any = found.any || read.any;
        found.plain = found.plain && (!read.any || read.known);
        denied =
            denied || std::ranges::any_of(plain_words_of(clause), [](Text word) { return is_among(word, denials); });
    }
    found.denied = found.units.size() > 1 || denied;
    found.plain = found.plain && found.units.size() < 2 && !(found.any && denied);
    return found;
}

bool is_title_of_unit(std::string_view lower, Dimension dimension) {
    constexpr auto others = std::to_array<Text>({"range", "drift", "offset", "error", "times", "use", "to", "from", "x",
                                                 "by", "other", "was", "or", "no", "gravity", "dc", "column", "file"});
    auto const clauses = unit_clauses(lower, dimension);
    auto const words = plain_words_of(lower);
    return clauses.any && !clauses.denied && !words.empty()
           && std::ranges::none_of(words,
                                   [&](Text word) {
                                       auto const parts = parted_at(word, "-_.");
                                       return is_among(word, others) || std::ranges::any_of(parts, [&](Text part) {
                                                  return is_among(part, others);
                                              });
                                   })
           && lower.find_first_of("*=<>") == Text::npos;
}

bool is_of_known_words(std::string_view lower) {
    return std::ranges::all_of(plain_words_of(lower), [&](Text word) {
        return is_known_word(word, lower) || unit_spelled(word, Dimension::acceleration)
               || unit_spelled(word, Dimension::velocity) || unit_spelled(word, Dimension::length);
    });
}

}  // namespace overturn
