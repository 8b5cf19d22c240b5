#include "motion/detail/quantity_words.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <string>

#include "core/units.hpp"
#include "motion/column_unit.hpp"
#include "motion/component_name.hpp"
#include "motion/detail/other_quantities.hpp"
#include "motion/detail/quantity_tables.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

using Text = std::string_view;

using quantity_tables::parts;
using quantity_tables::parts_of_hazards;
using quantity_tables::parts_of_names;
using quantity_tables::QuantityWord;
using quantity_tables::tokens;
using quantity_tables::tokens_of_names;
using quantity_tables::wholes;

/// "velns", "nsvel", "dispx": with a component, or none, before or behind it.
Quantity with_component(Text token) {
    constexpr auto stems = std::to_array<QuantityWord>({{"vel", Quantity::velocity},
                                                        {"velo", Quantity::velocity},
                                                        {"vit", Quantity::velocity},
                                                        {"hiz", Quantity::velocity},
                                                        {"disp", Quantity::displacement},
                                                        {"depl", Quantity::displacement},
                                                        {"rot", Quantity::other}});
    auto const points = [](Text rest) { return component_named(rest).direction != Direction::unknown; };
    for (auto const& [stem, quantity] : stems) {
        bool const before = token.starts_with(stem) && points(token.substr(stem.size()));
        if (before || (token.ends_with(stem) && points(token.substr(0, token.size() - stem.size())))) {
            return quantity;
        }
    }
    // "vx", "v_y", "dz", "ux" of a program's output.
    auto const axis = token.substr(token.size() > 2 && token[1] == '_' ? 2 : 1);
    bool const of_axis = axis == "x" || axis == "y" || axis == "z";
    return !of_axis                                       ? Quantity::unknown
           : token.front() == 'v'                         ? Quantity::velocity
           : token.front() == 'd' || token.front() == 'u' ? Quantity::displacement
                                                          : Quantity::unknown;
}

/// "udot", "xdot", "udotx"; "uddot" and "udotdot" are accelerations, "accdot" is a jerk.
Quantity of_dots(Text token) {
    constexpr std::size_t longest = 8;
    auto const at = token.find("dot");
    auto const stem = token.substr(0, at);
    if (at == Text::npos || at == 0 || token.size() > longest) {
        return Quantity::unknown;
    }
    auto rest = token.substr(at + Text("dot").size());
    bool const twice = stem.ends_with('d') || rest.starts_with("dot");
    rest = rest.substr(rest.starts_with("dot") ? Text("dot").size() : 0);
    bool const whole = rest.empty() || component_named(rest).direction != Direction::unknown;
    bool const of_acceleration = stem == "a" || stem.starts_with("acc");
    return !whole            ? Quantity::unknown
           : of_acceleration ? Quantity::other
           : twice           ? Quantity::acceleration
                             : Quantity::velocity;
}

/// "v(t)", "V1", "u2": a letter of a function of time, or with a number.
Quantity of_letter_alone(Text name) {
    constexpr std::size_t letter_and_digit = 2;
    bool const numbered = name.size() == letter_and_digit && name[1] >= '1' && name[1] <= '9';
    if (!numbered || Text("vd").find(name[0]) == Text::npos) {
        return Quantity::unknown;
    }
    return name[0] == 'v' ? Quantity::velocity : Quantity::displacement;
}

/// "V_NS", "vEW", "D-UD": a letter of a velocity or a displacement before a direction, which it is none itself.
Quantity of_letter_before(Text name) {
    auto const quantity = name.starts_with('v')                            ? Quantity::velocity
                          : name.starts_with('d') || name.starts_with('u') ? Quantity::displacement
                                                                           : Quantity::unknown;
    auto const rest = name.substr(std::min(name.find_first_not_of(" _-.", 1), name.size()));
    bool const parted = name.size() > 1 && Text("_-. ").find(name[1]) != Text::npos;  // "dn" is down, "d_n" is not
    bool const pair = name == "u-d" || name == "u_d" || name == "v-h";
    if (quantity == Quantity::unknown || pair || (!parted && component_named(name).direction != Direction::unknown)) {
        return Quantity::unknown;
    }
    constexpr auto directions =
        std::to_array<Text>({"ns", "ew", "ud", "n", "e", "z", "n-s", "e-w", "u-d", "x", "y", "h1", "h2", "up"});
    return std::ranges::find(directions, rest) != directions.end() ? quantity : Quantity::unknown;
}

/// HHE, BH1: the second letter of a SEED channel is its instrument, H a seismometer of velocities.
bool is_seismometer(Text lower) {
    constexpr std::size_t letters = 3;
    return lower.size() == letters && Text("hbeslm").find(lower[0]) != Text::npos && lower[1] == 'h'
           && Text("zne12").find(lower[2]) != Text::npos && component_named(lower).direction != Direction::unknown;
}

template <class Words> Quantity part_of(Text lower, Words const& words) {
    auto const* const found =
        std::ranges::find_if(words, [&](QuantityWord const& word) { return lower.find(word.text) != Text::npos; });
    return found == words.end() ? Quantity::unknown : found->quantity;
}

template <class Words> Quantity token_of(Text token, Words const& words) {
    auto const* const found = std::ranges::find(words, token, &QuantityWord::text);
    return found == words.end() ? Quantity::unknown : found->quantity;
}

template <class Take> void each_token(Text lower, Take take) {
    for (auto const token : parted_at(lower, " \t_-./,:;()[]{}=\"'#%!*|")) {
        take(token);
    }
}

bool holds_any(Text line, std::span<Text const> words) {
    return std::ranges::any_of(words, [&](Text word) { return line.find(word) != Text::npos; });
}

/// "Units: cm", "unit = counts": what the numbers are by that unit.
Quantity of_stated_unit(Text lower) {
    auto const key = lower.find("unit");
    auto const colon = lower.find_first_of(":=", key);
    if (key == Text::npos || colon == Text::npos) {
        return Quantity::unknown;
    }
    auto const unit = trimmed(lower.substr(colon + 1, lower.find_first_of(",;", colon) - colon - 1));
    constexpr std::array counted{Text("count"), Text("counts"), Text("cts"), Text("cnt")};
    constexpr std::array others{Text("v"),     Text("mv"),     Text("volt"), Text("volts"), Text("rad/s"),
                                Text("deg/s"), Text("mrad/s"), Text("m/s3"), Text("m/s^3"), Text("rad")};
    return std::ranges::find(counted, unit) != counted.end() ? Quantity::counts
           : std::ranges::find(others, unit) != others.end() ? Quantity::other
           : unit_spelled(unit, Dimension::velocity)         ? Quantity::velocity
           : unit_spelled(unit, Dimension::length)           ? Quantity::displacement
                                                             : Quantity::unknown;
}

/// Of what records and where, or of what a motion was made to meet.
bool is_of_something_else(Text lower) {
    constexpr auto words = std::to_array<Text>(
        {"sensor",       "seismometer",   "velocimeter", "accelerometer", "instrument", "model", "structure",
         "profile",      "wave velocity", "wave speed",  "shear",         "compatib",   "match", "target",
         "accelerogram", "station:",      "location:",   "site:",         "name:",      "event:"});
    return holds_any(lower, words);
}

}  // namespace

bool unit_decides(std::string_view name) {
    auto const lower = lowered(trimmed(name));
    constexpr std::size_t letters = 2;
    return lower.size() <= letters || (lower.size() == letters + 1 && lower[1] == '_') || is_seismometer(lower);
}

Quantity quantity_in_name(std::string_view name) {
    auto const lower = lowered(trimmed(name));
    if (auto const whole = token_of(lower, wholes); whole != Quantity::unknown) {
        return whole;
    }
    if (is_seismometer(lower)) {
        return Quantity::velocity;
    }
    auto const other = names_other_quantity(lower) ? Quantity::other : Quantity::unknown;
    for (auto const part :
         {part_of(lower, parts_of_hazards), part_of(lower, parts), other, part_of(lower, parts_of_names)}) {
        if (part != Quantity::unknown) {
            return part;
        }
    }
    for (auto const whole :
         {lower.empty() ? Quantity::unknown : with_component(lower), of_letter_before(lower), of_letter_alone(lower)}) {
        if (whole != Quantity::unknown) {
            return whole;
        }
    }
    auto found = Quantity::unknown;
    each_token(lower, [&](Text token) {
        for (auto const one :
             {token_of(token, tokens), token_of(token, tokens_of_names), with_component(token), of_dots(token)}) {
            found = found == Quantity::unknown ? one : found;
        }
    });
    return found;
}

Quantity quantity_in_prose(std::string_view lower) {
    if (auto const unit = of_stated_unit(lower); unit != Quantity::unknown) {
        return unit;
    }
    constexpr std::size_t label = 8;  // words; more are a sentence, in which such words are of anything
    std::size_t words = 0;
    auto by_token = Quantity::unknown;
    each_token(lower, [&](Text token) {
        ++words;
        auto const one = token_of(token, tokens);
        by_token = by_token == Quantity::unknown ? one : by_token;
    });
    if (by_token == Quantity::unknown && part_of(lower, parts) == Quantity::unknown && labels_other_quantity(lower)) {
        return Quantity::other;
    }
    if (words > label || is_of_something_else(lower)) {
        return Quantity::unknown;
    }
    if (lower.find("hazard curve") != Text::npos) {
        return Quantity::hazard;
    }
    auto const part = part_of(lower, parts);
    return part == Quantity::unknown ? by_token : part;
}

std::string_view plural_of(Quantity quantity) {
    switch (quantity) {
        case Quantity::velocity:
            return "velocities";
        case Quantity::displacement:
            return "displacements";
        case Quantity::counts:
            return "counts";
        case Quantity::spectrum:
            return "a spectrum";
        case Quantity::hazard:
            return "a hazard curve";
        case Quantity::other:
            return "another quantity";
        default:
            return {};
    }
}

}  // namespace overturn
