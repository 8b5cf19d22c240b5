#include "motion/detail/time_words.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "core/digit.hpp"
#include "core/units.hpp"
#include "motion/column_unit.hpp"
#include "motion/operators_in_name.hpp"
#include "motion/telling_words.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

using Text = std::string_view;

bool is_time_word(Text word) {
    constexpr auto words =
        std::to_array<Text>({"t", "time", "times", "tiempo", "temps", "zeit", "zaman", "\xE6\x99\x82\xE9\x96\x93",
                             "\xE6\x99\x82\xE5\x88\xBB", "\xE6\x97\xB6\xE9\x97\xB4", "\xEC\x8B\x9C\xEA\xB0\x84"});
    return std::ranges::find(words, word) != words.end();
}

bool is_filling(Text word) {
    constexpr auto fillings =
        std::to_array<Text>({"in", "unit", "units", "of", "is", "are", "the", "axis", "column", "first", "values",
                             "vector", "data", "given", "expressed", "all", "stamps", "as"});
    return std::ranges::find(fillings, word) != fillings.end();
}

/// "time (s) x 10" is "time   x 10".
std::string without_brackets(Text text) {
    std::string rest;
    int depth = 0;
    for (char const c : text) {
        depth += Text("([{").find(c) != Text::npos ? 1 : 0;
        rest += depth > 0 ? ' ' : c;
        depth -= depth > 0 && Text(")]}").find(c) != Text::npos ? 1 : 0;
    }
    return rest;
}

/// "10", "0.01", "x10": but for a word with a number at its end, a date or a time of day.
bool is_open_figure(Text token) {
    bool const word = !is_digit(token.front()) && token.front() != '.'
                      && !(token.front() == 'x' && token.size() > 1 && is_digit(token[1]));
    bool const moment = std::ranges::count(token, ':') > 0 || std::ranges::count(token, '-') > 1;
    return token.find_first_of("0123456789") != Text::npos && !word && !moment;
}

}  // namespace

std::optional<double> unit_in_time_name(std::string_view name) {
    auto const lower = lowered(trimmed(name));
    auto const parts = parted_at(lower, " \t_-./:,;|");
    if (parts.empty() || parts.size() > 2 || (parts.size() == 2 && !is_time_word(parts[0]))) {
        return std::nullopt;
    }
    constexpr auto written_together = std::to_array<Text>({"tsec", "tms", "tmsec"});
    bool const together = parts.size() == 1 && std::ranges::find(written_together, parts[0]) != written_together.end();
    return unit_spelled(parts.back().substr(together ? 1 : 0), Dimension::time);
}

bool tells_factor_of_time(std::string_view name) {
    auto lower = without_brackets(lowered(trimmed(name)));
    if (auto const at = lower.find("relative"); at != std::string::npos) {
        lower.erase(at, Text("relative").size());
    }
    auto const tokens = parted_at(lower, " \t_,;");
    bool const figure = std::ranges::any_of(tokens, is_open_figure);
    return figure || tells_factor(lower) || (!unit_in_time_name(lower) && tells_operation_in_name(lower));
}

std::optional<double> unit_of_times_in(std::string_view lower) {
    std::optional<double> found;
    for (auto const clause : parted_at(lower, ",;|")) {
        std::optional<double> unit;
        bool times = false;
        bool known = true;
        for (auto const word : parted_at(clause, " \t:=()[]{}\"#!*/.")) {
            bool const letter = word == "h";  // horizontal
            auto const si =
                is_time_word(word) || is_filling(word) || letter ? std::nullopt : unit_spelled(word, Dimension::time);
            known = known && (is_time_word(word) || is_filling(word) || (si && (!unit || *unit == *si)));
            times = times || is_time_word(word);
            unit = si ? si : unit;
        }
        found = known && times && unit && !found ? unit : found;
    }
    return found;
}

std::string name_of_time_unit(double si) {
    constexpr double millisecond = 1e-3;
    return si == millisecond ? "ms" : name_of_unit(si, Dimension::time);
}

}  // namespace overturn
