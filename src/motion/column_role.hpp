/// Meaning of a column by its name: quantity, unit, component.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/units.hpp"
#include "motion/component_name.hpp"

namespace overturn {

enum class Quantity {
    unknown,
    index,
    time,
    acceleration,
    velocity,
    displacement,
    counts,
    frequency,
    spectrum,
    hazard,
    other
};

/// "a velocity", "a time", ... for messages.
[[nodiscard]] std::string_view name_of(Quantity quantity);

struct ColumnRole {
    std::string name;
    Quantity quantity = Quantity::unknown;
    ComponentName component = {};
    std::optional<double> unit = {};  ///< SI value of one unit, of the quantity's dimension
    std::string unknown_unit = {};    ///< text in brackets that is no known unit

    [[nodiscard]] bool is_known() const {
        return quantity != Quantity::unknown || component.direction != Direction::unknown;
    }
};

/// "Velocity [cm/sec]", "accX", "CH3(UD)", "index", "T (ms)". A unit goes before a word: "acc (cm/s)" is a velocity.
[[nodiscard]] ColumnRole column_role(std::string_view name);

/// In lower case, a period as levels have it: "Sa(1.0s) [g]" is "sa(1 s) [g]".
[[nodiscard]] std::string measure_in_name(std::string_view name);

/// Is it the name of a spectrum's periods, "T", "T_n (s)", "t*", "Period", in several languages? "time" and "ln T" are
/// none.
[[nodiscard]] bool is_period_name(std::string_view name);

/// Is it the name of a spectrum's frequencies, "f", "freq_hz", "Frequency (Hz)"? "omega" is none.
[[nodiscard]] bool is_frequency_name(std::string_view name);

}  // namespace overturn
