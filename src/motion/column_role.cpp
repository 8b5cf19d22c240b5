#include "motion/column_role.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/digit.hpp"
#include "motion/column_unit.hpp"
#include "motion/detail/quantity_words.hpp"
#include "motion/detail/time_words.hpp"
#include "motion/detail/unit_in_text.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

using Text = std::string_view;

/// What stands in brackets, one after the other, and what is left without them.
struct Parts {
    std::string outside;
    std::vector<std::string> brackets;
};

Parts parts_of(Text name) {
    Parts made;
    while (true) {
        auto const open = name.find_first_of("([{");
        made.outside += name.substr(0, open);
        if (open == Text::npos) {
            break;
        }
        int depth = 0;
        auto close = open;
        for (; close < name.size(); ++close) {
            depth += Text("([{").find(name[close]) != Text::npos ? 1 : 0;
            depth -= Text(")]}").find(name[close]) != Text::npos ? 1 : 0;
            if (depth == 0) {
                break;
            }
        }
        made.brackets.emplace_back(trimmed(name.substr(open + 1, close - open - 1)));
        name = name.substr(std::min(close + 1, name.size()));
    }
    return made;
}

struct Unit {
    Quantity quantity = Quantity::unknown;
    double si = 0;
};

Unit unit_named(Text text) {
    for (auto const& [dimension, quantity] : {std::pair{Dimension::acceleration, Quantity::acceleration},
                                              {Dimension::velocity, Quantity::velocity},
                                              {Dimension::time, Quantity::time},
                                              {Dimension::length, Quantity::displacement},
                                              {Dimension::frequency, Quantity::frequency}}) {
        if (auto const si = unit_spelled(text, dimension)) {
            return {quantity, *si};
        }
    }
    auto const lower = lowered(text);
    return lower == "counts" || lower == "count" || lower == "cnt" ? Unit{Quantity::counts, 1} : Unit{};
}

/// Behind the last blank, underscore or "in"; a letter there may be anything.
Unit unit_behind(Text outside, std::string& left) {
    auto const plain = trimmed(outside);
    auto const last = plain.find_last_of("_ ");
    constexpr std::size_t telling = 2;
    if (last == Text::npos || plain.size() - last - 1 < telling) {
        return {};
    }
    auto const unit = unit_named(plain.substr(last + 1));
    auto const before = trimmed(plain.substr(0, last));
    if (unit.quantity != Quantity::unknown) {
        left = std::string(before);
    }
    return unit;
}

/// "acc 9.81 m/s2", "acc 1e-3 g", "acc_g/10": what stands in a unit's place and is none; empty if there is none.
std::string odd_unit_behind(Text outside) {
    auto const lower = lowered(trimmed(outside));
    auto const last = lower.find_last_of("_ ");
    if (last == std::string::npos) {
        return {};
    }
    auto const word = Text(lower).substr(last + 1);
    auto const before = trimmed(Text(lower).substr(0, last));
    auto const factor = before.substr(std::min(before.find_last_of("_ ") + 1, before.size()));
    bool const figures = !factor.empty() && before.find_last_of("_ ") != Text::npos && is_digit(factor.back())
                         && factor.find_first_not_of("0123456789.e+-^x*") == Text::npos;
    bool const unit = unit_named(word).quantity == Quantity::acceleration || word == "g";
    bool const odd = word.find_first_of("/*^") != Text::npos && unit_named(word).quantity == Quantity::unknown;
    return (figures && unit) || (odd && looks_like_unit(word))
               ? std::string(figures ? Text(lower).substr(before.size() - factor.size()) : word)
               : std::string();
}

/// "d", "0.01 s", "x10 ms", "-": beside "UTC" and "local" these are no seconds.
std::string odd_unit_of_time(std::vector<std::string> const& brackets) {
    constexpr auto others = std::to_array<Text>(
        {"d",      "day",   "days", "frame", "frames", "sample", "samples", "step", "steps", "counts", "-",     "min:s",
         "months", "years", "cs",   "ds",    "ns",     "ticks",  "points",  "pts",  "hours", "hrs",    "index", "no"});
    auto const odd = std::ranges::find_if(brackets, [&](std::string const& text) {
        auto const lower = lowered(text);
        return lower.find_first_of("0123456789") != std::string::npos
               || std::ranges::find(others, Text(lower)) != others.end();
    });
    return odd == brackets.end() ? std::string() : *odd;
}

}  // namespace

std::string_view name_of(Quantity quantity) {
    switch (quantity) {
        case Quantity::index:
            return "a count of rows";
        case Quantity::time:
            return "a time";
        case Quantity::acceleration:
            return "an acceleration";
        case Quantity::velocity:
            return "a velocity";
        case Quantity::displacement:
            return "a displacement";
        case Quantity::counts:
            return "counts of an instrument";
        case Quantity::frequency:
            return "a frequency or a period";
        case Quantity::spectrum:
            return "a spectrum";
        case Quantity::hazard:
            return "a hazard curve";
        case Quantity::other:
            return "no acceleration";
        case Quantity::unknown:
            break;
    }
    return "nothing known";
}

std::string measure_in_name(std::string_view name) {
    auto lower = lowered(trimmed(name));
    constexpr Text begin = "sa(";
    auto const close = lower.find(')');
    if (!lower.starts_with(begin) || close == std::string::npos) {
        return lower;
    }
    auto number = trimmed(Text(lower).substr(begin.size(), close - begin.size()));
    for (Text const unit : {"seconds", "sec", "s"}) {
        number = trimmed(number.substr(0, number.size() - (number.ends_with(unit) ? unit.size() : 0)));
    }
    double seconds = 0;
    return parse_number(number, seconds) ? fmt::format("sa({:g} s){}", seconds, lower.substr(close + 1)) : lower;
}

bool is_period_name(std::string_view name) {
    auto const lower = lowered(trimmed(name.substr(0, name.find_first_of("(["))));
    Text const stem = lower;
    auto const is_letter = [&](std::size_t at) { return is_small_letter(stem[at]); };
    constexpr auto words = std::to_array<Text>({"perio", "p\xC3\xA9rio", "periyo", "\xE5\x91\xA8\xE6\x9C\x9F"});
    return (stem.starts_with('t') && (stem.size() == 1 || !is_letter(1) || stem == "tn"))
           || std::ranges::any_of(words, [&](Text word) { return stem.find(word) != Text::npos; });
}

bool is_frequency_name(std::string_view name) {
    auto const lower = lowered(trimmed(name.substr(0, name.find_first_of("([_"))));
    return lower == "f" || lower.starts_with("freq") || lower.starts_with("fr\xC3\xA9q")
           || unit_spelled(unit_text_in_name(name).text, Dimension::frequency).has_value();
}

namespace {

/// "v(t)": of a function of time the letter says what it is.
Quantity of_function(Parts const& parts) {
    auto const letter = lowered(trimmed(parts.outside));
    bool const function = parts.brackets.size() == 1 && lowered(parts.brackets[0]) == "t" && letter.size() == 1;
    return !function                                     ? Quantity::unknown
           : letter == "v"                               ? Quantity::velocity
           : Text("udxyz").find(letter[0]) != Text::npos ? Quantity::displacement
                                                         : Quantity::unknown;
}

/// "kine", "cm/s", "gal": a name that is a unit alone.
Unit unit_as_name(Text name) {
    auto const plain = trimmed(name);
    constexpr auto words = std::to_array<Text>({"gal", "gals", "mgal", "kine", "kines", "cm", "mm"});
    bool const is_unit = plain.find('/') != Text::npos || std::ranges::find(words, Text(lowered(plain))) != words.end();
    return is_unit ? unit_named(plain) : Unit{};
}

}  // namespace

ColumnRole column_role(std::string_view name) {
    ColumnRole role{std::string(trimmed(name))};
    auto parts = parts_of(name);
    if (auto const function = of_function(parts); function != Quantity::unknown) {
        role.quantity = function;
        return role;
    }
    auto& [outside, brackets] = parts;
    Unit unit;
    for (auto const& text : brackets) {
        auto const found = unit_named(text);
        bool const volts = text == "V" && component_in(outside).direction == Direction::horizontal;
        bool const direction = !volts && component_named(text).direction != Direction::unknown;
        // One letter is a direction as often as a unit: "(s)" is seconds, "(N)" north, "(g)" g.
        unit = found.quantity != Quantity::unknown && unit.quantity == Quantity::unknown ? found : unit;
        if (found.quantity == Quantity::unknown && !direction && !text.empty()) {
            role.unknown_unit = text;
        }
    }
    if (unit.quantity == Quantity::unknown && brackets.empty()) {
        role.unknown_unit = odd_unit_behind(outside);
    }
    if (unit.quantity == Quantity::unknown && brackets.empty()) {
        unit = unit_as_name(outside);
        role.unknown_unit = unit.quantity == Quantity::unknown ? role.unknown_unit : std::string();
    }
    if (unit.quantity == Quantity::unknown && role.unknown_unit.empty()) {
        unit = unit_behind(outside, outside);
    }
    bool const unit_alone = trimmed(outside).empty() && !brackets.empty();
    auto const words = unit_alone ? Quantity::unknown : quantity_in_name(outside);
    role.component = component_in(name);
    bool const by_word = words == Quantity::spectrum || words == Quantity::hazard || words == Quantity::index;
    role.quantity = unit.quantity == Quantity::unknown || by_word ? words : unit.quantity;
    role.unit =
        unit.quantity == role.quantity && unit.quantity != Quantity::unknown ? std::optional(unit.si) : std::nullopt;
    // A word that says one quantity beside the unit of another: neither is to be trusted.
    bool const motion = (words == Quantity::velocity || words == Quantity::displacement) && !unit_decides(outside);
    if (unit.quantity == Quantity::acceleration && motion) {
        role.quantity = words;
        role.unit.reset();
    }
    if (role.quantity == Quantity::counts) {
        role.unit.reset();
    }
    if (words == Quantity::frequency && role.quantity == Quantity::time) {  // "Period (s)"
        role.quantity = Quantity::frequency;
        role.unit.reset();
    }
    if (brackets.empty() && (role.quantity == Quantity::time || role.quantity == Quantity::unknown)) {
        auto const seconds = unit_in_time_name(outside);
        constexpr double longest = 1;  // "min" may be the least, "h" horizontal
        bool const taken = seconds && *seconds <= longest;
        role.unit = taken && !role.unit ? seconds : role.unit;
        role.quantity = taken ? Quantity::time : role.quantity;
    }
    if (role.quantity == Quantity::time) {
        role.unknown_unit = role.unit ? std::string() : odd_unit_of_time(brackets);
    }
    if (role.quantity == Quantity::time || role.quantity == Quantity::index) {
        role.component = lowered(trimmed(outside)) == "t" && role.quantity == Quantity::time && !role.unit
                             ? ComponentName{Direction::horizontal, "t"}
                             : ComponentName{};
    }
    return role;
}

}  // namespace overturn
