#include "spectra/detail/target_names.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/digit.hpp"
#include "core/units.hpp"
#include "motion/column_role.hpp"
#include "motion/column_unit.hpp"
#include "motion/operators_in_name.hpp"
#include "motion/percent_in_name.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

using Text = std::string_view;

bool holds_any(Text text, std::initializer_list<Text> words) {
    return std::ranges::any_of(words, [&](Text word) { return text.find(word) != Text::npos; });
}

/// Before its brackets, in lower case.
std::string stem_of(Text name) { return lowered(trimmed(name.substr(0, name.find_first_of("([")))); }

/// "V_E", "Ve (m/s)", "energy velocity", "Veq", "sqrt(2E/m)"; "vel" is none.
bool names_energy(Text lower) {
    constexpr auto begins = std::to_array<Text>({"veq", "v-e", "sv_e", "psv_e", "e_i"});
    auto const alone = [&](Text word) {
        return lower.starts_with(word) && (lower.size() == word.size() || !is_small_letter(lower[word.size()]));
    };
    return alone("ve") || alone("v_e") || holds_any(lower, {"energy", "equivalent vel", "velocity_eq", "sqrt(2e"})
           || std::ranges::any_of(begins, [&](Text begin) { return lower.starts_with(begin); });
}

}  // namespace

std::optional<TargetKind> kind_named(std::string_view name) {
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

namespace {

/// Of no response spectrum, whatever its kind.
bool is_something_else(Text name) {
    auto const lower = lowered(trimmed(name));
    auto const quantity = column_role(ordinate_name(without_hazard_levels(name))).quantity;
    return quantity == Quantity::hazard || quantity == Quantity::counts || quantity == Quantity::index
           || quantity == Quantity::frequency || quantity == Quantity::other || lower == "t" || lower == "pga"
           || lower.starts_with("ratio") || lower.starts_with("pga ") || lower.starts_with("pga(")
           || lower.starts_with("pgv") || lower.starts_with("pgd")
           || holds_any(lower, {"sigma", "std", "uncert", "dispersion", "st.dev", "deviation", " ratio", "norm", "/pga",
                                "/ pga", "amplif", "fourier", "fas", "time", "rate", "\xCF\x83"});
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
    auto const name = trimmed(table.first_name);
    if (auto const slash = name.find('/'); slash != Text::npos && name.find_first_of("([") == Text::npos) {
        throw InputError(where, fmt::format("'{}' (a quotient, or a unit?). Name it T (s), or f (Hz)", name));
    }
    if (table.names_line > 0 && is_frequency_name(table.first_name)) {
        if (bracketed && !unit_spelled(text, Dimension::frequency)) {
            throw InputError(where, fmt::format("unit '{}' of the frequencies (it is not known). Write f (Hz)", text));
        }
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
    if (tells_operation_in_name(ordinate_name(table.second_name)) && !names_energy(lowered(table.second_name))) {
        throw InputError(where, fmt::format("'{}' (an operation in its name: are its numbers that, or still to be "
                                            "changed by it?). Give the ordinates as such, under a plain name",
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

}  // namespace overturn
