/// Meaning of one line of prose, word by word. Every function takes a line in lower case.
#pragma once

#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/units.hpp"

namespace overturn {

/// Hands out the SI value of each unit of the dimension: "in m/s/s", "(gal)", "units: g". Short ones, "g", "mg", "cm",
/// count only where words or brackets say so; "9.81 m/s2" is a quantity and counts not at all.
void each_unit(std::string_view line, Dimension dimension, std::function<void(double)> const& take);

/// The number that `text` begins with, "0.005", "5e-3", "1/200", cut off it; nothing if there is none above 0.
[[nodiscard]] std::optional<double> cut_number(std::string_view& text);

/// "dt = 0.005", "@200Hz", "every 5 ms", "Time Increment (s): 0.005", "sampling rate 100 Hz", "points at 0.02 sec",
/// "200 sps" [s]
[[nodiscard]] std::optional<double> step_in(std::string line);

/// "npts: 2500", "NUMBER OF DATA : 3000", "3000 samples"
[[nodiscard]] std::optional<std::size_t> count_in(std::string line);

struct PeakInText {
    double value = 0;                 ///< without its sign
    std::optional<double> unit = {};  ///< SI value of the one behind it
    double digit = 0;                 ///< of the value's last one
    std::vector<double> beside = {};  ///< of other components, "(N-S) 13.2 (E-W) 12.1"
    bool rough = false;               ///< "about", raw, or of a resultant: near the numbers' own
    bool other = false;               ///< of a spectrum, a sensor's range, a target: not the numbers' own
};
/// "PGA (gal): 13.2", "peak value: 53.138", "PGA = 300 gal", "peak acceleration of 0.3 g", "max. 0.3 g": in the unit
/// behind it, else in that of the line, or of the numbers.
[[nodiscard]] std::optional<PeakInText> peak_in(std::string_view line, Dimension dimension);

/// Does it speak of a peak and state a figure, whether that is understood or not?
[[nodiscard]] bool tells_peak(std::string_view line);

/// "0.5 g", "500gal": a figure with a unit of the dimension behind it?
[[nodiscard]] bool states_value(std::string_view line, Dimension dimension);

/// Does it hold the word, or the words, as such?
[[nodiscard]] bool holds_word(std::string_view line, std::string_view word);

/// To the digits that such lines print.
[[nodiscard]] inline bool same_as_printed(double a, double b) {
    constexpr double printed = 1e-3;
    return std::abs(a - b) <= printed * std::abs(b);
}

}  // namespace overturn
