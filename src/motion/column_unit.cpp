#include "motion/column_unit.hpp"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

struct Spelling {
    std::string_view text;
    double si;
    Dimension dimension = Dimension::acceleration;
};

// Beside those of unit_factor.
constexpr std::array spellings{Spelling{"m/s/s", 1},
                               Spelling{"m/s**2", 1},
                               Spelling{"m/sec2", 1},
                               Spelling{"m/sec^2", 1},
                               Spelling{"m/sec**2", 1},
                               Spelling{"m/sec/sec", 1},
                               Spelling{"mps2", 1},
                               Spelling{"cm/s/s", 1e-2},
                               Spelling{"cm/s**2", 1e-2},
                               Spelling{"cm/sec2", 1e-2},
                               Spelling{"cm/sec^2", 1e-2},
                               Spelling{"cm/sec**2", 1e-2},
                               Spelling{"cm/sec/sec", 1e-2},
                               Spelling{"cmps2", 1e-2},
                               Spelling{"gals", 1e-2},
                               Spelling{"mm/s^2", 1e-3},
                               Spelling{"mm/s/s", 1e-3},
                               Spelling{"g's", g0},
                               Spelling{"m/sec", 1, Dimension::velocity},
                               Spelling{"mps", 1, Dimension::velocity},
                               Spelling{"cm/sec", 1e-2, Dimension::velocity},
                               Spelling{"cmps", 1e-2, Dimension::velocity},
                               Spelling{"kines", 1e-2, Dimension::velocity},
                               Spelling{"sec", 1, Dimension::time},
                               Spelling{"secs", 1, Dimension::time},
                               Spelling{"second", 1, Dimension::time},
                               Spelling{"seconds", 1, Dimension::time},
                               Spelling{"msec", 1e-3, Dimension::time}};

}  // namespace

std::optional<double> unit_spelled(std::string_view text, Dimension dimension) {
    auto const lower = lowered(trimmed(text));
    for (auto const& spelling : spellings) {
        if (spelling.dimension == dimension && spelling.text == lower) {
            return spelling.si;
        }
    }
    try {
        return unit_factor(lower, dimension);
    } catch (InputError const&) {
        return std::nullopt;
    }
}

UnitText unit_text_in_name(std::string_view name) {
    if (auto const open = name.find_first_of("(["); open != std::string_view::npos) {
        auto const close = name.find_first_of(")]", open);
        return {trimmed(name.substr(open + 1, close == std::string_view::npos ? close : close - open - 1)), true};
    }
    auto const last = trimmed(name).find_last_of("_ ");
    return {last == std::string_view::npos ? std::string_view{} : trimmed(name).substr(last + 1), false};
}

std::optional<double> unit_in_name(std::string_view name, Dimension dimension) {
    auto const [text, bracketed] = unit_text_in_name(name);
    constexpr std::size_t telling = 2;  // a letter alone needs its brackets
    return bracketed || text.size() >= telling ? unit_spelled(text, dimension) : std::nullopt;
}

std::optional<double> unit_of_values(std::string_view name, Dimension dimension) {
    bool const in_g = dimension == Dimension::acceleration && unit_text_in_name(name).text == "g";
    return in_g ? std::optional(g0) : unit_in_name(name, dimension);
}

std::string name_of_acceleration_unit(double si) {
    constexpr double same = 1e-9;
    static constexpr std::array names{"m/s2", "gal", "g", "mm/s2"};
    for (auto const* name : names) {
        if (double const named = unit_factor(name, Dimension::acceleration); std::abs(si - named) <= same * named) {
            return name;
        }
    }
    return fmt::format("{:.7g} m/s2", si);
}

}  // namespace overturn
