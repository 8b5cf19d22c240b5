/// The amplitudes of a scan: the intensity measure that defines them, their values, and which of them are special.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "campaign/intensity_measure.hpp"
#include "config/table.hpp"

namespace overturn {

/// Purpose of a level.
enum class LevelClass : std::uint8_t { ordinary = 0, design_basis = 1, beyond_design = 2 };

/// The measures that levels may be stated by, under the words of levels.measure.
[[nodiscard]] std::span<config::Entry<Measure> const> level_measures();

struct Level {
    double value = 0;  ///< SI
    LevelClass purpose = LevelClass::ordinary;

    /// The value in millionths, rounded: what names a level's own waves, whatever other levels there are.
    [[nodiscard]] std::int64_t key() const;
};

struct LevelSpec {
    Measure measure = measure_named("pga");  ///< Sa: at the place of its period among measures.sa_periods
    std::vector<Level> levels;               ///< rising
    double sa_period_s = 0;                  ///< where the measure is Sa
    bool independent_waves = false;          ///< every level has waves of its own
    std::string stated_unit = {};            ///< in which the values are written; empty: as bare numbers, or pure ones
    double stated_unit_si = 1;               ///< SI value of one of it
    std::optional<std::pair<double, double>> falling = {};  ///< the first two values that were not listed rising

    [[nodiscard]] std::string measure_name() const;
    /// The same for people: "sa(3 s)".
    [[nodiscard]] std::string measure_label() const {
        return measure->period ? fmt::format("sa({:g} s)", sa_period_s) : measure_name();
    }
    [[nodiscard]] Dimension dimension() const;
    [[nodiscard]] std::string units() const;
    /// The user's unit, a value in it, and both as text.
    [[nodiscard]] std::string shown_units() const { return stated_unit.empty() ? units() : stated_unit; }
    [[nodiscard]] double shown(double value) const { return value / stated_unit_si; }
    [[nodiscard]] std::string text(double value) const;
    /// The level that is the design basis; null: none is.
    [[nodiscard]] Level const* design_basis() const;
    /// The factor that brings a wave to `level`; empty if the wave's measure is zero.
    [[nodiscard]] std::optional<double> scale(Level const& level, WaveRow const& wave) const;
};

/// Keys of [levels].
extern config::KeyTable const levels_table;

/// A named level that is not among the values is added to them; named levels need no values. \throws InputError
[[nodiscard]] LevelSpec read_levels(config::Table const& table);

/// "ordinary", "design-basis", "beyond-design".
[[nodiscard]] std::string name_of(LevelClass purpose);

}  // namespace overturn
