#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/digit.hpp"
#include "core/units.hpp"
#include "motion/component_name.hpp"
#include "motion/percent_in_name.hpp"
#include "motion/telling_words.hpp"
#include "motion/text_lines.hpp"
#include "motion/text_statements.hpp"
#include "spectra/detail/target_names.hpp"

namespace overturn {
namespace {

using Text = std::string_view;

bool speaks_of(Text text, std::initializer_list<Text> words) {
    return std::ranges::any_of(words, [&](Text word) { return text.find(word) != Text::npos; });
}

bool is_lower_case(char c) { return c >= 'a' && c <= 'z'; }

/// What a line calls the spectrum's ordinates, "Pseudo-velocity response spectrum"; nothing if it names several, or
/// none.
std::optional<TargetKind> kind_of_spectrum(Text lower) {
    std::optional<TargetKind> found;
    for (auto const& [text, kind] : {std::pair{Text("accel"), TargetKind::acceleration},
                                     {Text("veloc"), TargetKind::pseudo_velocity},
                                     {Text("displ"), TargetKind::displacement}}) {
        if (lower.find(text) != Text::npos) {
            if (found) {
                return std::nullopt;
            }
            found = kind;
        }
    }
    return found;
}

/// "type: PSV", "PSV": what the only word behind a colon, or of a line, calls the ordinates; "psa" and "psv" wherever
/// they stand.
std::optional<TargetKind> kind_of_word(Text lower) {
    auto const mark = lower.find_last_of(":=#");
    auto const behind = trimmed(lower.substr(mark + 1));
    auto const key = mark == Text::npos || lower[mark] == '#' ? Text{} : lower.substr(0, mark);
    bool const of_kind = speaks_of(key, {"type", "quantity", "kind", "measure", "ordinate", "imt"});
    if ((key.empty() || of_kind) && !behind.empty() && behind.find_first_of(" \t,;") == Text::npos
        && behind.size() > 1) {
        return kind_named(behind);
    }
    for (auto const& [word, kind] :
         {std::pair{Text("psa"), TargetKind::acceleration}, {Text("psv"), TargetKind::pseudo_velocity}}) {
        auto const at = lower.find(word);
        auto const end = at + word.size();
        if (at != Text::npos && (at == 0 || !is_lower_case(lower[at - 1]))
            && (end == lower.size() || !is_lower_case(lower[end]))) {
            return kind;
        }
    }
    return std::nullopt;
}

[[noreturn]] void contradict(std::string const& what, std::string const& kind, Location const& where) {
    throw InputError(
        where,
        fmt::format("{} where kind says {} (they contradict each other). Mend the kind, or the text", what, kind));
}

/// \throws InputError if the line calls the ordinates something else
void check_line(TextLine const& line, TargetKind kind, TextStatements const& statements, std::string const& file) {
    Location const where{file, line.number};
    auto const lower = lowered(line.text);
    auto const own = dimension_of(kind);
    auto const& other = statements.other();
    if (!other.empty() && other != "a spectrum") {
        contradict(other + ", says the text,", std::string(name_of(own)), where);
    }
    auto const kind_stated = other == "a spectrum" ? kind_of_spectrum(lower) : std::nullopt;
    auto const of_spectrum = kind_stated ? kind_stated : kind_of_word(lower);
    if (of_spectrum && dimension_of(*of_spectrum) != own) {
        contradict(fmt::format("a spectrum of {}, says the text,", name_of(dimension_of(*of_spectrum))),
                   std::string(name_of(own)), where);
    }
    if (tells_no_response(lower)) {
        throw InputError(where, fmt::format("{} (no response spectrum). Give Sa, Sv or Sd, or mend the text",
                                            in_quotes(trimmed(line.text))));
    }
    if (lower.find("energy") != std::string::npos && kind != TargetKind::energy_velocity) {
        contradict(in_quotes(trimmed(line.text)), "another spectrum", where);
    }
}

/// Does the text state a damping? \throws InputError if it is another one
bool check_damping(Text lower, double damping, Location const& where) {
    constexpr double printed = 1e-3;
    auto const stated = damping_in(lower);
    if (stated && std::abs(*stated - damping) > printed) {
        throw InputError(where, fmt::format("damping {} in the text, {} in the campaign (they contradict each other). "
                                            "State stated_damping = {}",
                                            *stated, damping, *stated));
    }
    return stated.has_value();
}

/// Does the name of the ordinates say more of them than is understood? \throws InputError at another damping
bool name_tells_more(Text name, double damping, Location const& where) {
    auto const without = without_hazard_levels(name);
    bool const level = without != name;  // "10 % in 50 years": no damping
    auto const rest = with_percent_signs(without);
    auto const named = lowered(rest);
    auto const percent = named.find('%');  // of a column's name nothing else, but of a fractile
    auto const before = percent == std::string::npos ? std::nullopt : number_at_end(Text(named).substr(0, percent));
    constexpr double highest = 30;
    bool const share = before && *before <= highest;
    bool const damped = check_damping(share ? fmt::format("{} % damped", *before) : named, damping, where);
    if (level || !damped) {
        return level || tells_more_in_name(rest);
    }
    auto const begin =
        share ? rest.find_last_not_of("0123456789. ", percent - 1) + 1 : rest.find_first_of("0123456789");
    auto const end = std::min(share ? percent + 1 : rest.find_first_not_of("0123456789.", begin), rest.size());
    return tells_more_in_name(rest.substr(0, begin) + rest.substr(end));
}

/// Beside the damping: nothing but words of a response spectrum and "10 % in 50 years"?
bool is_plain(Text lower, double damping) {
    constexpr auto words = std::to_array<Text>({"response",
                                                "spectrum",
                                                "spectra",
                                                "spectral",
                                                "acceleration",
                                                "accelerations",
                                                "accel",
                                                "pseudo",
                                                "velocity",
                                                "displacement",
                                                "energy",
                                                "elastic",
                                                "absolute",
                                                "design",
                                                "target",
                                                "uhs",
                                                "uniform",
                                                "hazard",
                                                "horizontal",
                                                "damping",
                                                "damped",
                                                "ratio",
                                                "critical",
                                                "viscous",
                                                "of",
                                                "for",
                                                "the",
                                                "with",
                                                "a",
                                                "an",
                                                "in",
                                                "and",
                                                "at",
                                                "is",
                                                "percent",
                                                "per",
                                                "cent",
                                                "pct",
                                                "sa",
                                                "psa",
                                                "psv",
                                                "sv",
                                                "sd",
                                                "h",
                                                "zeta",
                                                "xi",
                                                "\xCE\xB6",
                                                "\xCE\xBE",
                                                "return",
                                                "period",
                                                "years",
                                                "year",
                                                "yr",
                                                "yrs",
                                                "unit",
                                                "units",
                                                "g",
                                                "gal",
                                                "cm",
                                                "m",
                                                "s",
                                                "s2",
                                                "sec",
                                                "kine",
                                                "sdof",
                                                "oscillator",
                                                "oscillators",
                                                "rotd50",
                                                "geometric",
                                                "mean",
                                                "ground",
                                                "motion",
                                                "factor"});
    constexpr Text separators = " \t_-.,:;()[]{}=\"'#%!*|/^";
    constexpr double printed = 1e-3;
    for (std::size_t at = 0; at < lower.size();) {
        at = std::min(lower.find_first_not_of(separators, at), lower.size());
        bool const figure = at < lower.size() && is_digit(lower[at]);
        auto const end = std::min(
            figure ? lower.find_first_not_of("0123456789.", at) : lower.find_first_of(separators, at), lower.size());
        auto const word = lower.substr(at, end - at);
        at = end;
        if (word.empty() || std::ranges::find(words, word) != words.end()) {
            continue;
        }
        double value = 0;
        bool const number = parse_number(word, value);
        bool const own = std::abs(value - damping) <= printed || std::abs(value / 100 - damping) <= printed;
        auto const behind = lower.substr(std::min(lower.find_first_not_of(" %-", end), lower.size()));
        bool const of_years = behind.starts_with("in ") || behind.starts_with('y') || behind == "a";
        if (!number || !(own || of_years)) {
            return false;
        }
    }
    return true;
}

}  // namespace

std::vector<std::string> check_text(PairTable const& table, TargetKind kind, double damping, std::string const& name) {
    std::vector<std::string> unread;
    auto const quoted = [](Text text, int line) { return fmt::format("line {}: {}", line, in_quotes(trimmed(text))); };
    if (name_tells_more(table.second_name, damping, {name, table.names_line})) {
        unread.push_back(quoted(table.second_name, table.names_line));
    }
    for (auto const& line : table.text) {
        TextStatements statements(dimension_of(kind));
        statements.take(line.text, line.number);
        check_line(line, kind, statements, name);
        auto const lower = lowered(line.text);
        bool const damped = check_damping(lower, damping, {name, line.number});
        bool const vertical = std::ranges::any_of(
            statements.components(), [](auto const& component) { return is_vertical(direction_of(component)); });
        bool const telling = vertical || statements.states_peak() || tells_vertical(lower)
                             || tells_other_spectrum(lower) || (!damped && speaks_of(lower, {"damp", "critical"}));
        bool const more = telling || tells_factor(lower) || !is_plain(lower, damping);
        auto const remarks = !damped ? statements.unread() : std::vector<std::string>();
        if (remarks.empty() && (damped ? more : telling)) {
            unread.push_back(quoted(line.text, line.number));
        }
        std::ranges::copy(remarks, std::back_inserter(unread));
    }
    return unread;
}

}  // namespace overturn
