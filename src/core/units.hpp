/// Units: SI inside, and the field's own units (gal, kine, t, g) wherever a user states a quantity.
#pragma once

#include <numbers>
#include <optional>
#include <string>
#include <string_view>

namespace overturn {

/// Standard gravity [m/s2], CGPM 1901.
inline constexpr double g0 = 9.80665;
inline constexpr double pi = std::numbers::pi;
/// One gal [m/s2].
inline constexpr double gal_mps2 = 0.01;

/// Dimension of a quantity; decides which unit symbols are accepted.
enum class Dimension { none, time, length, mass, inertia, velocity, acceleration, angle, frequency, pressure };

/// SI value of one `symbol` of the given dimension, e.g. ("gal", acceleration) -> 0.01.
/// \throws InputError naming the accepted symbols if `symbol` is none of them.
[[nodiscard]] double unit_factor(std::string_view symbol, Dimension dimension);

/// The SI value of a text such as "117 t", "0.3 g" or "2.5" (a bare number is SI already).
/// \throws InputError if the number or the unit cannot be read, or the number is not finite.
[[nodiscard]] double parse_quantity(std::string_view text, Dimension dimension);

/// The SI value of "1.36 m": a number, a blank and a unit of whatever dimension. Nothing for any other text.
[[nodiscard]] std::optional<double> quantity_with_unit(std::string_view text);

/// The SI symbol of a dimension ("m/s2"), "" for a pure number.
[[nodiscard]] std::string_view si_symbol(Dimension dimension);

/// "time", "acceleration", ... for messages.
[[nodiscard]] std::string_view name_of(Dimension dimension);

/// All symbols accepted for a dimension, comma separated, for messages.
[[nodiscard]] std::string accepted_units(Dimension dimension);

/// The whole of `text` as a finite double. Accepts Fortran exponents (1.5D-03), a leading dot or plus.
/// \return false if it is anything else.
[[nodiscard]] bool parse_number(std::string_view text, double& value);

/// Without leading and trailing blanks, tabs and line ends.
[[nodiscard]] std::string_view trimmed(std::string_view text);

}  // namespace overturn
