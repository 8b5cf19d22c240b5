#include "spectra/detail/target_names.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/units.hpp"
#include "motion/claims.hpp"
#include "motion/column_role.hpp"
#include "motion/column_unit.hpp"
#include "motion/telling_words.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

using Text = std::string_view;

bool holds_any(Text text, std::initializer_list<Text> words) {
    return std::ranges::any_of(words, [&](Text word) { return text.find(word) != Text::npos; });
}

/// Before its brackets, in lower case.
std::string stem_of(Text name) { return lowered(trimmed(name.substr(0, name.find_first_of("([")))); }

bool is_letter(char c) { return c >= 'a' && c <= 'z'; }

/// "V_E", "Ve (m/s)", "energy velocity", "Veq", "sqrt(2E/m)"; "vel" is none.
bool names_energy(Text lower) {
    constexpr auto begins = std::to_array<Text>({"veq", "v-e", "sv_e", "psv_e", "e_i"});
    auto const alone = [&](Text word) {
        return lower.starts_with(word) && (lower.size() == word.size() || !is_letter(lower[word.size()]));
    };
    return alone("ve") || alone("v_e") || holds_any(lower, {"energy", "equivalent vel", "velocity_eq", "sqrt(2e"})
           || std::ranges::any_of(begins, [&](Text begin) { return lower.starts_with(begin); });
}

/// What a name calls the ordinates, where it says so.
std::optional<TargetKind> kind_named(Text name) {
    auto const lower = lowered(trimmed(name));
    struct Word {
        Text text;
        TargetKind kind;
    };
    constexpr auto parts = std::to_array<Word>({{"accel", TargetKind::acceleration},
                                                {"\xE5\x8A\xA0\xE9\x80\x9F\xE5\xBA\xA6", TargetKind::acceleration},
                                                {"veloc", TargetKind::pseudo_velocity},
                                                {"\xE9\x80\x9F\xE5\xBA\xA6", TargetKind::pseudo_velocity},
                                                {"displ", TargetKind::displacement},
                                                {"\xE5\xA4\x89\xE4\xBD\x8D", TargetKind::displacement}});
    constexpr auto words = std::to_array<Word>({{"sa", TargetKind::acceleration},
                                                {"psa", TargetKind::acceleration},
                                                {"sv", TargetKind::pseudo_velocity},
                                                {"psv", TargetKind::pseudo_velocity},
                                                {"v", TargetKind::pseudo_velocity},
                                                {"sd", TargetKind::displacement},
                                                {"d", TargetKind::displacement}});
    if (names_energy(lower)) {
        return TargetKind::energy_velocity;
    }
    for (auto const& [text, kind] : parts) {
        if (lower.find(text) != std::string::npos) {
            return kind;
        }
    }
    auto const word = Text(lower).substr(0, lower.find_first_of(" ([_,/"));
    auto const* const found = std::ranges::find(words, word, &Word::text);
    return found == words.end() ? std::nullopt : std::optional(found->kind);
}

/// Of no response spectrum, whatever its kind.
bool is_something_else(Text name) {
    auto const lower = lowered(trimmed(name));
    auto const quantity = column_role(ordinate_name(name)).quantity;
    return quantity == Quantity::hazard || quantity == Quantity::counts || quantity == Quantity::index
           || quantity == Quantity::frequency || quantity == Quantity::other || lower == "t" || lower == "pga"
           || lower.starts_with("ratio") || lower.starts_with("pga ") || lower.starts_with("pga(")
           || lower.starts_with("pgv") || lower.starts_with("pgd")
           || holds_any(lower, {"sigma", "std", " ratio", "norm", "/pga", "/ pga", "amplif", "fourier", "fas", "time",
                                "rate", "\xCF\x83"});
}

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

std::optional<double> number_before(Text text) {
    text = trimmed(text);
    auto const begin = text.find_last_not_of("0123456789.");
    double value = 0;
    return parse_number(text.substr(begin == Text::npos ? 0 : begin + 1), value) ? std::optional(value) : std::nullopt;
}

std::optional<double> number_behind(Text text) {
    text = text.substr(std::min(text.find_first_not_of(" \t:=of"), text.size()));
    double value = 0;
    return parse_number(text.substr(0, text.find_first_not_of("0123456789.")), value) ? std::optional(value)
                                                                                      : std::nullopt;
}

}  // namespace

std::string ordinate_name(std::string_view name) {
    auto plain = trimmed(name);
    if (!lowered(plain).starts_with("ln")) {
        return std::string(plain);
    }
    plain = trimmed(plain.substr(2));
    if (plain.starts_with('_')) {
        plain = trimmed(plain.substr(1));
    }
    if (plain.starts_with('(') && !unit_spelled(plain.substr(1, plain.find(')') - 1), Dimension::acceleration)) {
        auto const close = plain.find(')');
        return std::string(plain.substr(1, close - 1))
               + std::string(plain.substr(std::min(close == Text::npos ? close : close + 1, plain.size())));
    }
    return std::string(plain);
}

bool are_target_names(std::string_view first, std::string_view second) {
    return is_period_name(first) || is_frequency_name(first) || (kind_named(ordinate_name(second)) && !first.empty());
}

std::optional<double> frequency_unit(PairTable const& table, Location const& where) {
    auto const [text, bracketed] = unit_text_in_name(table.first_name);
    if (table.names_line > 0 && is_frequency_name(table.first_name)) {
        return unit_spelled(text, Dimension::frequency).value_or(1);
    }
    auto const stem = stem_of(table.first_name);
    bool const seconds = bracketed && unit_spelled(text, Dimension::time) && stem.starts_with('t') && stem != "time";
    bool const wordless = table.names_line == 0 || stem.empty();
    if (!wordless && !seconds && !is_period_name(table.first_name)) {
        throw InputError(where, fmt::format("'{}' (a period or a frequency belongs into the first column). Name it T "
                                            "(s), or f (Hz)",
                                            table.first_name));
    }
    return std::nullopt;
}

bool are_logarithms(PairTable const& table, Location const& where) {
    auto const lower = lowered(trimmed(table.second_name));
    if (lower.starts_with("log")) {
        throw InputError(where, fmt::format("'{}' (a logarithm of which base?). Give the ordinates themselves, or ln "
                                            "of them",
                                            table.second_name));
    }
    return lower.starts_with("ln");
}

void check_kind(PairTable const& table, TargetKind kind, Location const& where) {
    if (table.second_name.find_first_of(",;\t") != std::string::npos) {
        throw InputError(where, fmt::format("'{}' over the second of two columns (names of more columns than there "
                                            "are). Mend the names",
                                            table.second_name));
    }
    if (table.names_line == 0) {
        return;
    }
    if (is_something_else(table.second_name)) {
        throw InputError(where, fmt::format("'{}' (no ordinate of a response spectrum). Give Sa, Sv or Sd, or name the "
                                            "column so",
                                            table.second_name));
    }
    auto const named = kind_named(ordinate_name(table.second_name));
    bool const energy = kind == TargetKind::energy_velocity && named == TargetKind::pseudo_velocity;
    if (named == TargetKind::energy_velocity && kind != *named) {
        throw InputError(where,
                         fmt::format("'{}' (an energy spectrum, which kind says it is not). Mend the kind, or the "
                                     "header",
                                     table.second_name));
    }
    if (named && *named != kind && !energy) {
        throw InputError(where, fmt::format("'{}' where kind says {} (they contradict each other). Mend the kind, or "
                                            "the header",
                                            table.second_name, name_of(dimension_of(kind))));
    }
}

std::vector<std::string> check_text(PairTable const& table, TargetKind kind, double damping, std::string const& name) {
    std::vector<std::string> unread;
    auto const check_damping = [&](Text lower, int line) {
        constexpr double printed = 1e-3;
        auto const stated = damping_in(lower);
        if (stated && std::abs(*stated - damping) > printed) {
            throw InputError({name, line},
                             fmt::format("damping {} in the text, {} in the campaign (they contradict each "
                                         "other). State stated_damping = {}",
                                         *stated, damping, *stated));
        }
        return stated.has_value();
    };
    auto named = lowered(table.second_name);
    if (auto const at = named.find("pct"); at != std::string::npos) {
        named.replace(at, 3, "%");
    }
    auto const percent = named.find('%');  // of a column's name nothing else
    auto const before = percent == std::string::npos ? std::nullopt : number_before(Text(named).substr(0, percent));
    check_damping(before ? fmt::format("{} % damped", *before) : named, table.names_line);
    for (auto const& line : table.text) {
        Claims claims(dimension_of(kind));
        claims.take(line.text, line.number);
        auto const& other = claims.other();
        auto const lower = lowered(line.text);
        auto const of_spectrum = other == "a spectrum" ? kind_of_spectrum(lower) : std::nullopt;
        if ((!other.empty() && other != "a spectrum")
            || (of_spectrum && dimension_of(*of_spectrum) != dimension_of(kind))) {
            throw InputError(
                {name, line.number},
                fmt::format("{}, says the text, where kind says {} (they contradict each other). Mend the "
                            "kind, or the text",
                            of_spectrum ? "a spectrum of " + std::string(name_of(dimension_of(*of_spectrum))) : other,
                            name_of(dimension_of(kind))));
        }
        if (lower.find("fourier") != std::string::npos) {
            throw InputError({name, line.number},
                             fmt::format("{} (no response spectrum). Give Sa, Sv or Sd, or mend the text",
                                         in_quotes(trimmed(line.text))));
        }
        if (lower.find("energy") != std::string::npos && kind != TargetKind::energy_velocity) {
            throw InputError(
                {name, line.number},
                fmt::format("{} where kind says another spectrum (they contradict each other). Mend the kind, "
                            "or the text",
                            in_quotes(trimmed(line.text))));
        }
        bool const damped = check_damping(lower, line.number);
        bool const telling = tells_vertical(lower) || lower.find("floor") != std::string::npos
                             || (!damped && holds_any(lower, {"damp", "critical"}));
        bool const more = tells_factor(lower) || tells_statistic(lower) || tells_other_span(lower) || telling;
        auto const said = !damped ? claims.unread() : more ? claims.telling() : std::vector<std::string>();
        if (said.empty() && telling) {
            unread.push_back(fmt::format("line {}: {}", line.number, in_quotes(trimmed(line.text))));
        }
        std::ranges::copy(said, std::back_inserter(unread));
    }
    return unread;
}

std::optional<double> damping_in(std::string_view lower) {
    std::string plain(lower);
    for (Text const word : {" percent", "percent", " per cent", "pct"}) {
        for (auto at = plain.find(word); at != std::string::npos; at = plain.find(word, at)) {
            plain.replace(at, word.size(), "%");
        }
    }
    lower = plain;
    // "5 % damped", "2 % of critical": the number right before; "10 % in 50 years, damping 5 %" is none.
    constexpr std::size_t fillings = 16;
    for (Text const word : {"damp", "of critical"}) {
        auto const at = lower.find(word);
        auto const percent = at == Text::npos ? Text::npos : lower.rfind('%', at);
        if (percent == Text::npos || at - percent > fillings
            || lower.substr(percent, at - percent).find_first_of(",;:0123456789") != Text::npos
            || holds_any(lower.substr(percent, at - percent), {" in ", "year", "yr", " and "})) {
            continue;
        }
        auto const value = number_before(lower.substr(0, percent));
        return value ? std::optional(*value / 100) : std::nullopt;
    }
    for (Text const key :
         {"damping ratio", "damping factor", "damping", "zeta", "\xCE\xB6", "xi", "\xCE\xBE", "h =", "h="}) {
        auto const at = lower.find(key);
        if (at == Text::npos || (at > 0 && is_letter(lower[at - 1]))) {
            continue;
        }
        auto const value = number_behind(lower.substr(at + key.size()));
        auto const begin = std::min(lower.find_first_not_of(" \t:=of", at + key.size()), lower.size());
        auto const end = std::min(lower.find_first_not_of("0123456789.", begin), lower.size());
        auto const mark = lower.find_first_not_of(" \t", end);
        bool const percent_behind = value && mark != Text::npos && lower[mark] == '%';
        if (percent_behind && lower.substr(mark + 1).starts_with(" and ")) {
            return std::nullopt;  // "damping 5 % and 2 %"
        }
        double const share = value.value_or(0) / (percent_behind ? 100 : 1);
        if (share > 0 && share < 1) {
            return share;
        }
    }
    return std::nullopt;
}

}  // namespace overturn
