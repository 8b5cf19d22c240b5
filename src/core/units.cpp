#include "core/units.hpp"

#include <array>
#include <charconv>
#include <cmath>

#include "core/error.hpp"

namespace overturn {
namespace {

struct Unit {
    Dimension dimension;
    std::string_view symbol;
    double si;
};

constexpr double inch = 0.0254;       // m, exactly: international yard and pound agreement (1959)
constexpr double pound = 0.45359237;  // kg, exactly: the same

// The first symbol of each dimension is the SI one. Of a mass in units of force it is what weighs so much under
// standard gravity; tonf is the metric one.
constexpr std::array units{
    Unit{Dimension::time, "s", 1},
    Unit{Dimension::time, "ms", 1e-3},
    Unit{Dimension::time, "min", 60},
    Unit{Dimension::time, "h", 3600},
    Unit{Dimension::length, "m", 1},
    Unit{Dimension::length, "cm", 1e-2},
    Unit{Dimension::length, "km", 1e3},
    Unit{Dimension::length, "mm", 1e-3},
    Unit{Dimension::length, "in", inch},
    Unit{Dimension::length, "ft", 12 * inch},
    Unit{Dimension::mass, "kg", 1},
    Unit{Dimension::mass, "t", 1e3},
    Unit{Dimension::mass, "lb", pound},
    Unit{Dimension::mass, "kip", 1e3 * pound},  // what weighs so much under standard gravity
    Unit{Dimension::mass, "kN", 1e3 / g0},
    Unit{Dimension::mass, "tonf", 1e3},
    Unit{Dimension::inertia, "kg m2", 1},
    Unit{Dimension::inertia, "kg*m2", 1},
    Unit{Dimension::inertia, "t m2", 1e3},
    Unit{Dimension::inertia, "t*m2", 1e3},
    Unit{Dimension::inertia, "lb ft2", pound * 144 * inch* inch},
    Unit{Dimension::inertia, "kip ft2", 1e3 * pound * 144 * inch* inch},
    Unit{Dimension::velocity, "m/s", 1},
    Unit{Dimension::velocity, "cm/s", 1e-2},
    Unit{Dimension::velocity, "mm/s", 1e-3},
    Unit{Dimension::velocity, "kine", 1e-2},
    Unit{Dimension::velocity, "in/s", inch},
    Unit{Dimension::velocity, "ft/s", 12 * inch},
    Unit{Dimension::acceleration, "m/s2", 1},
    Unit{Dimension::acceleration, "m/s^2", 1},
    Unit{Dimension::acceleration, "cm/s2", 1e-2},
    Unit{Dimension::acceleration, "cm/s^2", 1e-2},
    Unit{Dimension::acceleration, "mm/s2", 1e-3},
    Unit{Dimension::acceleration, "gal", 1e-2},
    Unit{Dimension::acceleration, "in/s2", inch},
    Unit{Dimension::acceleration, "ft/s2", 12 * inch},
    Unit{Dimension::acceleration, "g", g0},
    Unit{Dimension::angle, "rad", 1},
    Unit{Dimension::angle, "deg", pi / 180},
    Unit{Dimension::frequency, "Hz", 1},
    Unit{Dimension::pressure, "Pa", 1},
    Unit{Dimension::pressure, "kPa", 1e3},
    Unit{Dimension::pressure, "MPa", 1e6},
    Unit{Dimension::pressure, "N/mm2", 1e6},
    Unit{Dimension::pressure, "psi", pound* g0 / (inch * inch)},
    Unit{Dimension::pressure, "ksi", 1e3 * pound* g0 / (inch * inch)},
};

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool same_ignoring_case(std::string_view a, std::string_view b) {
    if (a.size() != b.size()) {
        return false;
    }
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (lower(a[i]) != lower(b[i])) {
            return false;
        }
    }
    return true;
}

}  // namespace

std::string_view trimmed(std::string_view text) {
    auto const blank = std::string_view(" \t\r\n\v\f");
    auto const first = text.find_first_not_of(blank);
    if (first == std::string_view::npos) {
        return {};
    }
    return text.substr(first, text.find_last_not_of(blank) - first + 1);
}

bool parse_number(std::string_view text, double& value) {
    if (!text.empty() && text.front() == '+') {
        text.remove_prefix(1);
        if (!text.empty() && (text.front() == '-' || text.front() == '+')) {
            return false;
        }
    }
    std::string fortran;
    if (auto const at = text.find_first_of("dD"); at != std::string_view::npos) {
        fortran = text;
        fortran[at] = 'e';
        text = fortran;
    }
    auto const* const end = text.data() + text.size();
    auto const result = std::from_chars(text.data(), end, value);
    return result.ec == std::errc{} && result.ptr == end && std::isfinite(value);
}

std::string_view si_symbol(Dimension dimension) {
    for (auto const& unit : units) {
        if (unit.dimension == dimension) {
            return unit.symbol;
        }
    }
    return "";
}

std::string_view name_of(Dimension dimension) {
    switch (dimension) {
        case Dimension::none:
            return "pure number";
        case Dimension::time:
            return "time";
        case Dimension::length:
            return "length";
        case Dimension::mass:
            return "mass";
        case Dimension::inertia:
            return "moment of inertia";
        case Dimension::velocity:
            return "velocity";
        case Dimension::acceleration:
            return "acceleration";
        case Dimension::angle:
            return "angle";
        case Dimension::pressure:
            return "pressure";
        case Dimension::frequency:
            return "frequency";
    }
    return "";
}

std::string accepted_units(Dimension dimension) {
    std::string list;
    for (auto const& unit : units) {
        if (unit.dimension == dimension) {
            list += list.empty() ? "" : ", ";
            list += unit.symbol;
        }
    }
    return list;
}

double unit_factor(std::string_view symbol, Dimension dimension) {
    for (auto const& unit : units) {
        if (unit.dimension == dimension && same_ignoring_case(unit.symbol, symbol)) {
            return unit.si;
        }
    }
    validate(dimension != Dimension::none, "unit '{}' on a pure number (it has no unit). Write the number alone",
             symbol);
    throw InputError(fmt::format("unit '{}' (not a unit of {}). Use one of: {}", symbol, name_of(dimension),
                                 accepted_units(dimension)));
}

// "0.35g": where the unit begins of a number that is followed by one at once; npos: nothing of that kind.
std::string_view::size_type unit_at_once(std::string_view text, Dimension dimension) {
    for (auto const& unit : units) {
        double number = 0;
        if (unit.dimension == dimension && text.size() > unit.symbol.size()
            && same_ignoring_case(text.substr(text.size() - unit.symbol.size()), unit.symbol)
            && parse_number(text.substr(0, text.size() - unit.symbol.size()), number)) {
            return text.size() - unit.symbol.size();
        }
    }
    return std::string_view::npos;
}

double parse_quantity(std::string_view text, Dimension dimension) {
    text = trimmed(text);
    auto const blank = text.find_first_of(" \t");
    if (auto const at = unit_at_once(text, dimension); at != std::string_view::npos) {
        throw InputError(fmt::format("'{}' (no blank between number and unit). Write \"{} {}\"", text,
                                     text.substr(0, at), text.substr(at)));
    }
    double value = 0;
    validate(parse_number(text.substr(0, blank), value),
             "'{}' (not a finite number followed by a blank and a unit). Write for example {}", text,
             dimension == Dimension::none ? std::string("0.5") : fmt::format("\"1.5 {}\"", si_symbol(dimension)));
    if (blank == std::string_view::npos) {
        return value;
    }
    return value * unit_factor(trimmed(text.substr(blank)), dimension);
}

std::optional<double> quantity_with_unit(std::string_view text) {
    text = trimmed(text);
    auto const blank = text.find_first_of(" \t");
    double value = 0;
    if (blank == std::string_view::npos || !parse_number(text.substr(0, blank), value)) {
        return std::nullopt;
    }
    auto const symbol = trimmed(text.substr(blank));
    for (auto const& unit : units) {  // no two dimensions share a symbol
        if (same_ignoring_case(unit.symbol, symbol)) {
            return value * unit.si;
        }
    }
    return std::nullopt;
}

}  // namespace overturn
