#include "motion/operators_in_name.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "core/units.hpp"
#include "motion/column_unit.hpp"
#include "motion/component_name.hpp"
#include "motion/percent_in_name.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

using Text = std::string_view;

bool is_unit_of_any(Text text) {
    constexpr std::array dimensions{Dimension::acceleration, Dimension::velocity, Dimension::length, Dimension::time,
                                    Dimension::frequency};
    return std::ranges::any_of(dimensions, [&](Dimension each) { return unit_spelled(text, each).has_value(); });
}

/// Without what stands in brackets;a line end in place of a unit.
std::string without_brackets(Text lower) {
    std::string rest;
    while (!lower.empty()) {
        auto const open = lower.find_first_of("([");
        rest += lower.substr(0, open);
        if (open == Text::npos) {
            break;
        }
        auto const close = std::min(lower.find_first_of(")]", open), lower.size());
        rest += is_unit_of_any(trimmed(lower.substr(open + 1, close - open - 1))) ? '\n' : ' ';
        lower.remove_prefix(std::min(close + 1, lower.size()));
    }
    return rest;
}

/// Is there a sign of reckoning in it that is not a unit's or a direction's? A spectrum's "V/H" is reported elsewhere.
bool has_operator(Text text) {
    return std::ranges::any_of(parted_at(text, " \t_,;:\n"), [](Text token) {
        bool const sign = token.find_first_of("/*^|+<>") != Text::npos || token.find("\xC3\x97") != Text::npos
                          || token.find("\xC2\xB7") != Text::npos;
        return sign && token != "v/h" && !is_unit_of_any(token)
               && component_named(token).direction == Direction::unknown;
    });
}

bool holds_made_word(Text text) {
    constexpr auto made = std::to_array<Text>({"half", "resultant", "srss", "rel", "res", "beta"});
    return std::ranges::any_of(parted_at(text, " \t_-./,;:\n"),
                               [&](Text word) { return std::ranges::find(made, word) != made.end(); });
}

/// "PSA (g)", "Sa [g]", "UHS": of oscillators, which have a damping
bool names_spectrum(Text lower) {
    constexpr auto words = std::to_array<Text>({"sa", "psa", "sv", "psv", "sd", "uhs", "spectral", "pseudo"});
    auto const end = std::min(lower.find_first_not_of("abcdefghijklmnopqrstuvwxyz"), lower.size());
    return std::ranges::find(words, lower.substr(0, end)) != words.end();
}

}  // namespace

bool tells_operation_in_name(std::string_view name) {
    auto const lower = lowered(trimmed(name));
    bool const spectral = names_spectrum(lower);
    auto const plain = without_brackets(spectral ? without_hazard_levels(lower) : lower);
    auto const unit = plain.find('\n');
    auto behind = unit == std::string::npos ? Text{} : Text(plain).substr(unit);
    behind = trimmed(behind.substr(std::min(behind.find_first_not_of(" \t\n,;:"), behind.size())));
    bool const times = behind == "x" || behind.starts_with("x ");
    bool const reckoned = !behind.empty() && !(spectral && is_damping_alone(behind))
                          && component_named(behind).direction == Direction::unknown
                          && (times || behind.find_first_of("0123456789-%") != Text::npos);
    return reckoned || has_operator(plain) || holds_made_word(plain);
}

}  // namespace overturn
