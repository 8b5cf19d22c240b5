/// The unit of times: in the name of their column and in prose.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace overturn {

/// "ms", "msec", "t/ms", "time.millis", without brackets: SI value of one unit; nothing if the name says none.
[[nodiscard]] std::optional<double> unit_in_time_name(std::string_view name);

/// "t*10", "time/10 (s)", "t x 0.5", "scaled time", "0.01 s": must its numbers be reckoned with to be times? A clock's
/// "hh:mm:ss", a date, a number at a word ("t0") and "relative time" are none.
[[nodiscard]] bool tells_factor_of_time(std::string_view name);

/// "t: ms", "time in ms", "Time [ms], a [gal]": SI value of the one unit that a line in lower case states for the
/// times; nothing where other words or figures stand beside it in its clause.
[[nodiscard]] std::optional<double> unit_of_times_in(std::string_view lower);

/// "ms", or the SI value with its unit.
[[nodiscard]] std::string name_of_time_unit(double si);

}  // namespace overturn
