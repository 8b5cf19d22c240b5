/// What the name of a column says of its numbers: quantity, unit, component.
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
    std::string unknown_unit = {};    ///< what stands in brackets where nothing known does

    [[nodiscard]] bool said() const {
        return quantity != Quantity::unknown || component.direction != Direction::unknown;
    }
};

/// "Velocity [cm/sec]", "accX", "CH3(UD)", "index", "T (ms)". A unit goes before a word: "acc (cm/s)" is a velocity.
[[nodiscard]] ColumnRole column_role(std::string_view name);

}  // namespace overturn
