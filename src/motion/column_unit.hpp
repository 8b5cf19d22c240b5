/// Units as files write them: in the names of columns and in prose.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/units.hpp"

namespace overturn {

/// SI value of one unit in any of its usual spellings ("cm/sec/sec", "gals", "g's", "m/s**2", "m s-2"); nothing if it
/// is none of the dimension's: acceleration, velocity, length, time. Capitals do not count.
[[nodiscard]] std::optional<double> unit_spelled(std::string_view text, Dimension dimension);

/// A unit of an intensity: of acceleration, velocity or length. Nothing if it is none of these.
struct IntensitySpelled {
    Dimension dimension = Dimension::none;
    double si = 1;
};
[[nodiscard]] std::optional<IntensitySpelled> intensity_unit_spelled(std::string_view text);

/// Text of the unit in a column's name: in its brackets, "acceleration (g)", of several those that hold a unit, "Se(T)
/// (g)", or behind its last blank or underscore, "ax_mps2"; empty without either.
struct UnitText {
    std::string_view text;
    bool bracketed = false;
};
[[nodiscard]] UnitText unit_text_in_name(std::string_view name);

/// SI value of one unit of a column: "ax_mps2", "acceleration (g)", "Acc(gal)", "NS [cm/s2]", "Sv [kine]". Nothing if
/// the name says none; a bare suffix "_g" or "_s" says none either: it is as often the ground or a spectrum.
[[nodiscard]] std::optional<double> unit_in_name(std::string_view name, Dimension dimension = Dimension::acceleration);

/// The same of a column of values whose quantity is known: there a letter g of its own, "Sa_g", is the unit, for no
/// ground can be meant.
[[nodiscard]] std::optional<double> unit_of_values(std::string_view name, Dimension dimension);

/// "gal", "g", "m/s2", "cm/s", or the SI value where it is another one.
[[nodiscard]] std::string name_of_unit(double si, Dimension dimension);
[[nodiscard]] inline std::string name_of_acceleration_unit(double si) {
    return name_of_unit(si, Dimension::acceleration);
}

/// Is a column in the dimension's SI unit, or does its name state none? Brackets of anything else: no.
[[nodiscard]] bool is_in_si(std::string_view name, Dimension dimension);

}  // namespace overturn
