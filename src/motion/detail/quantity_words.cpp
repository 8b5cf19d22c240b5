#include "motion/detail/quantity_words.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <string>

#include "core/units.hpp"
#include "motion/column_unit.hpp"
#include "motion/component_name.hpp"
#include "motion/detail/other_quantities.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

using Text = std::string_view;

struct QuantityWord {
    Text text;
    Quantity quantity;
};
// Parts of words, the more telling ones first: "acceleration" is also written "accel. time history".
constexpr auto parts = std::to_array<QuantityWord>({
    {"spectr", Quantity::spectrum},
    {"spektr", Quantity::spectrum},
    {"spettr", Quantity::spectrum},
    {"fourier", Quantity::spectrum},
    {"\xE3\x82\xB9\xE3\x83\x9A\xE3\x82\xAF\xE3\x83\x88\xE3\x83\xAB", Quantity::spectrum},
    {"angular", Quantity::other},
    {"rad/s", Quantity::other},
    {"jerk", Quantity::other},
    {"integrated accel", Quantity::velocity},
    {"integral of accel", Quantity::velocity},
    {"integral of the accel", Quantity::velocity},
    {"integrated once", Quantity::velocity},
    {"integrated twice", Quantity::displacement},
    {"\xE8\xA7\x92\xE9\x80\x9F", Quantity::other},  // angular velocity
    {"accel", Quantity::acceleration},
    {"acc\xC3\xA9l", Quantity::acceleration},
    {"aceler", Quantity::acceleration},
    {"beschleunig", Quantity::acceleration},
    {"ivme", Quantity::acceleration},
    {"\xC4\xB0vme", Quantity::acceleration},
    {"\xD1\x83\xD1\x81\xD0\xBA\xD0\xBE\xD1\x80", Quantity::acceleration},
    {"\xEA\xB0\x80\xEC\x86\x8D\xEB\x8F\x84", Quantity::acceleration},
    {"\xE5\x8A\xA0\xE9\x80\x9F\xE5\xBA\xA6", Quantity::acceleration},
    {"veloc", Quantity::velocity},
    {"vitesse", Quantity::velocity},
    {"geschwind", Quantity::velocity},
    {"h\xC4\xB1z", Quantity::velocity},
    {"\xD0\xBA\xD0\xBE\xD1\x80\xD0\xBE\xD1\x81\xD1\x82", Quantity::velocity},
    {"speed", Quantity::velocity},
    {"\xEC\x86\x8D\xEB\x8F\x84", Quantity::velocity},
    {"\xE9\x80\x9F\xE5\xBA\xA6", Quantity::velocity},
    {"displ", Quantity::displacement},
    {"desplaz", Quantity::displacement},
    {"d\xC3\xA9plac", Quantity::displacement},
    {"deplac", Quantity::displacement},
    {"deplasman", Quantity::displacement},
    {"verschieb", Quantity::displacement},
    {"spostam", Quantity::displacement},
    {"\xEB\xB3\x80\xEC\x9C\x84", Quantity::displacement},
    {"\xE5\xA4\x89\xE4\xBD\x8D", Quantity::displacement},
    {"\xE4\xBD\x8D\xE7\xA7\xBB", Quantity::displacement},
    {"voltage", Quantity::other},
    {"volts", Quantity::other},
});
// Parts of names alone: in prose they are of other things.
constexpr auto parts_of_names = std::to_array<QuantityWord>({
    {"freq", Quantity::frequency},
    {"time", Quantity::time},
    {"tiempo", Quantity::time},
    {"temps", Quantity::time},
    {"zeit", Quantity::time},
    {"zaman", Quantity::time},
    {"\xE6\x99\x82\xE9\x96\x93", Quantity::time},
    {"\xE6\x97\xB6\xE9\x97\xB4", Quantity::time},
    {"\xE6\x99\x82\xE5\x88\xBB", Quantity::time},
    {"\xE6\x97\xB6\xE5\x88\xBB", Quantity::time},
    {"\xEC\x8B\x9C\xEA\xB0\x84", Quantity::time},
    {"arias", Quantity::other},
    {"husid", Quantity::other},
});
// Before all others: "probability of exceeding the acceleration".
constexpr auto parts_of_hazards = std::to_array<QuantityWord>({{"exceed", Quantity::hazard},
                                                               {"annual", Quantity::hazard},
                                                               {"hazard", Quantity::hazard},
                                                               {"probab", Quantity::hazard}});
// Words of their own, among others.
constexpr auto tokens = std::to_array<QuantityWord>({
    {"acc", Quantity::acceleration},
    {"vel", Quantity::velocity},
    {"dis", Quantity::displacement},
    {"disp", Quantity::displacement},
    {"counts", Quantity::counts},
    {"psa", Quantity::spectrum},
    {"psv", Quantity::spectrum},
    {"fas", Quantity::spectrum},
});
constexpr auto tokens_of_names = std::to_array<QuantityWord>({
    {"sa", Quantity::spectrum},    {"sv", Quantity::spectrum},  {"sd", Quantity::spectrum},
    {"poe", Quantity::hazard},     {"afe", Quantity::hazard},   {"cnt", Quantity::counts},
    {"cts", Quantity::counts},     {"hiz", Quantity::velocity}, {"pgv", Quantity::other},
    {"pgd", Quantity::other},      {"cav", Quantity::other},    {"theta", Quantity::other},
    {"omega", Quantity::other},    {"flag", Quantity::other},   {"date", Quantity::other},
    {"year", Quantity::other},     {"depth", Quantity::other},  {"magnitude", Quantity::other},
    {"distance", Quantity::other}, {"snr", Quantity::other},    {"power", Quantity::other},
});
// The whole name, without its unit.
constexpr auto wholes = std::to_array<QuantityWord>({{"", Quantity::index},
                                                     {"index", Quantity::index},
                                                     {"idx", Quantity::index},
                                                     {"no", Quantity::index},
                                                     {"no.", Quantity::index},
                                                     {"nr", Quantity::index},
                                                     {"nr.", Quantity::index},
                                                     {"num", Quantity::index},
                                                     {"number", Quantity::index},
                                                     {"n\xC2\xB0", Quantity::index},
                                                     {"id", Quantity::index},
                                                     {"i", Quantity::index},
                                                     {"row", Quantity::index},
                                                     {"point", Quantity::index},
                                                     {"sample", Quantity::index},
                                                     {"samples", Quantity::index},
                                                     {"step", Quantity::index},
                                                     {"count", Quantity::index},
                                                     {"unnamed: 0", Quantity::index},
                                                     {"\xE7\x95\xAA\xE5\x8F\xB7", Quantity::index},
                                                     {"\xE5\xBA\x8F\xE5\x8F\xB7", Quantity::index},
                                                     {"t", Quantity::time},
                                                     {"sec", Quantity::time},
                                                     {"secs", Quantity::time},
                                                     {"second", Quantity::time},
                                                     {"seconds", Quantity::time},
                                                     {"s", Quantity::time},
                                                     {"ms", Quantity::time},
                                                     {"\xE7\xA7\x92", Quantity::time},
                                                     {"a", Quantity::acceleration},
                                                     {"ag", Quantity::acceleration},
                                                     {"d", Quantity::displacement},
                                                     {"f", Quantity::frequency},
                                                     {"period", Quantity::frequency}});

/// "velns", "nsvel", "dispx": with a component, or none, before or behind it.
Quantity with_component(Text token) {
    constexpr auto stems = std::to_array<QuantityWord>({{"vel", Quantity::velocity}, {"disp", Quantity::displacement}});
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

/// "V_NS", "vEW", "D-UD": a letter of a velocity or a displacement before a direction, which it is none itself.
Quantity of_letter_before(Text name) {
    auto const quantity = name.starts_with('v')                            ? Quantity::velocity
                          : name.starts_with('d') || name.starts_with('u') ? Quantity::displacement
                                                                           : Quantity::unknown;
    auto const rest = name.substr(std::min(name.find_first_not_of(" _-.", 1), name.size()));
    if (quantity == Quantity::unknown || component_named(name).direction != Direction::unknown) {
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
    for (std::size_t at = 0; at < lower.size();) {
        constexpr Text separators = " \t_-./,:;()[]{}=\"'#%!*|";
        at = std::min(lower.find_first_not_of(separators, at), lower.size());
        auto const end = std::min(lower.find_first_of(separators, at), lower.size());
        if (end > at) {
            take(lower.substr(at, end - at));
        }
        at = end;
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
    for (auto const whole : {lower.empty() ? Quantity::unknown : with_component(lower), of_letter_before(lower)}) {
        if (whole != Quantity::unknown) {
            return whole;
        }
    }
    auto found = Quantity::unknown;
    each_token(lower, [&](Text token) {
        for (auto const one : {token_of(token, tokens), token_of(token, tokens_of_names), with_component(token)}) {
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
