#include "campaign/level_spec.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "campaign/rows.hpp"

namespace overturn {
namespace {

// Sa once: its period is a key of its own.
constexpr bool is_level(IntensityMeasure const& entry) { return !entry.level.empty() && entry.period.value_or(0) == 0; }

constexpr auto measure_entries = [] {
    constexpr std::size_t count = std::ranges::count_if(intensity_measures, is_level);
    std::array<config::Entry<Measure>, count> all{};
    std::size_t next = 0;
    for (auto const& entry : intensity_measures) {
        if (is_level(entry)) {
            all.at(next++) = {entry.level, entry.meaning, &entry};
        }
    }
    return all;
}();

constexpr std::array independence{
    config::Entry<bool>{"shared", "every level scales the same waves", false},
    config::Entry<bool>{"independent", "every level has waves of its own", true},
};

constexpr std::array spacings{
    config::Entry<bool>{"linear", "equal steps", false},
    config::Entry<bool>{"log", "equal ratios", true},
};

constexpr std::int64_t most_levels = 100000;

constexpr config::Key level_key(std::string_view name, std::string_view meaning) {
    return config::number_key(name, Dimension::none, config::Range::positive(), meaning).in_unit_of("measure");
}
constexpr config::Keys level_range_keys{
    level_key("from", "lowest level"), level_key("to", "highest level"),
    config::integer_key("count", 1, most_levels, "number of levels"),
    config::word_key<spacings>("spacing", "spacing of the levels").otherwise("linear")};
constexpr config::KeyTable level_range_table{.meaning = "evenly spread levels", .keys = level_range_keys.all};

constexpr config::Key level_list_key(std::string_view name, std::string_view meaning) {
    return config::numbers_key(name, Dimension::none, config::Range::positive(), meaning).in_unit_of("measure");
}
constexpr config::Keys level_keys{
    config::word_key<measure_entries>("measure", "intensity measure by which waves are scaled"),
    config::number_key("period", Dimension::time, {.low = 0.02, .high = 20}, "period of Sa").only("measure = sa"),
    level_list_key("values",
                   "list of levels, or a table of evenly spread levels; required unless other levels are stated")
        .or_as(config::table_key<level_range_table>("values", ""))
        .optional(),
    config::word_key<independence>("waves", "same waves at every level, or separate waves for each level")
        .otherwise("shared"),
    level_key("design_basis", "level of the design basis, added to values").optional(),
    level_list_key("beyond_design", "levels beyond the design basis, added to values").optional()};

std::vector<double> read_values(config::Table const& table, Dimension dimension) {
    if (table.kind("values") != config::Kind::table) {
        auto values = table.numbers(level_keys["values"], {.dimension = dimension});
        if (values.empty()) {
            table.fail("values", "empty (no level to test at). List at least one");
        }
        return values;
    }
    auto const range = table.child(level_keys["values"]);
    double const from = range.number(level_range_keys["from"], {.dimension = dimension});
    double const to = range.number(level_range_keys["to"], {.dimension = dimension});
    auto const count = range.integer(level_range_keys["count"]);
    bool const log = range.choice<bool>(level_range_keys["spacing"], spacings);
    range.finish();
    if (count == 1 && to != from) {
        range.fail("count", "1 level between two (which one is meant?). Write values = [...], or count = 2");
    }
    if (count > 1 && !(to > from)) {
        range.fail("to", "not above 'from' (levels must rise). Swap them");
    }
    std::vector<double> values;
    for (std::int64_t i = 0; i < count; ++i) {
        double const part = count == 1 ? 0 : static_cast<double>(i) / static_cast<double>(count - 1);
        values.push_back(i + 1 == count && count > 1 ? to
                         : log                       ? from * std::pow(to / from, part)
                                                     : from + (to - from) * part);
    }
    return values;
}

bool same_level(double a, double b) {
    constexpr double tolerance = 1e-9;
    return std::abs(a - b) <= tolerance * std::max(std::abs(a), std::abs(b));
}

void name_level(std::vector<Level>& levels, double value, LevelClass purpose) {
    auto const found =
        std::find_if(levels.begin(), levels.end(), [&](Level const& l) { return same_level(l.value, value); });
    if (found != levels.end()) {
        found->purpose = purpose;
    } else {
        levels.push_back({value, purpose});
    }
}

}  // namespace

std::span<config::Entry<Measure> const> level_measures() { return measure_entries; }

std::string name_of(LevelClass purpose) {
    switch (purpose) {
        case LevelClass::ordinary:
            return "ordinary";
        case LevelClass::design_basis:
            return "design-basis";
        case LevelClass::beyond_design:
            return "beyond-design";
    }
    return "";
}

std::int64_t Level::key() const {
    constexpr double millionths = 1e6;
    return std::llround(value * millionths);
}

std::string LevelSpec::measure_name() const { return std::string(measure->period ? measure->level : measure->name); }

Dimension LevelSpec::dimension() const { return measure->dimension; }

std::string LevelSpec::units() const { return measure->units(); }

Level const* LevelSpec::design_basis() const {
    auto const found = std::ranges::find(levels, LevelClass::design_basis, &Level::purpose);
    return found == levels.end() ? nullptr : &*found;
}

std::string LevelSpec::text(double value) const {
    auto const unit = shown_units();
    return unit == "1" ? fmt::format("{:.6g}", shown(value)) : fmt::format("{:.6g} {}", shown(value), unit);
}

std::optional<double> LevelSpec::scale(Level const& level, WaveRow const& wave) const {
    double const base = unscaled(measure, wave, {});
    return base > 0 ? std::optional(level.value / base) : std::nullopt;
}

constinit config::KeyTable const levels_table{.meaning = "the levels that waves are scaled to", .keys = level_keys.all};

LevelSpec read_levels(config::Table const& table) {
    table.may_have(levels_table);
    LevelSpec spec;
    spec.measure = table.choice<Measure>(level_keys["measure"], measure_entries);
    auto const dimension = spec.dimension();
    if (spec.measure->period) {
        spec.sa_period_s = table.number(level_keys["period"]);
    }
    spec.independent_waves = table.choice<bool>(level_keys["waves"], independence);
    // Named levels alone make a campaign too.
    if (table.has("values") || !(table.has("design_basis") || table.has("beyond_design"))) {
        auto const values = read_values(table, dimension);
        if (auto const falls = std::ranges::adjacent_find(values, std::greater{}); falls != values.end()) {
            spec.falling = {*falls, *(falls + 1)};
        }
        for (double const value : values) {
            spec.levels.push_back({value, LevelClass::ordinary});
        }
    }
    auto const basis = table.maybe_number(level_keys["design_basis"], {.dimension = dimension});
    auto const beyond = table.has("beyond_design")
                            ? table.numbers(level_keys["beyond_design"], {.dimension = dimension})
                            : std::vector<double>();
    for (auto const* key : {"values", "design_basis", "beyond_design"}) {
        if (auto const unit = table.unit_at(key); spec.stated_unit.empty() && !unit.empty()) {
            spec.stated_unit = unit;
            spec.stated_unit_si = unit_factor(unit, dimension);
        }
    }
    if (basis) {
        name_level(spec.levels, *basis, LevelClass::design_basis);
    }
    for (double const value : beyond) {
        if (basis && value <= *basis) {
            table.fail("beyond_design",
                       fmt::format("{} (not above design_basis {}). Raise it", spec.text(value), spec.text(*basis)));
        }
        name_level(spec.levels, value, LevelClass::beyond_design);
    }
    table.finish();
    std::sort(spec.levels.begin(), spec.levels.end(), [](Level const& a, Level const& b) { return a.value < b.value; });
    constexpr double largest = 9000;  // keys of waves are 64 bits wide
    if (spec.independent_waves && spec.levels.back().value > largest) {
        table.fail("values", fmt::format("{} (independent waves reach up to {}). Lower it",
                                         spec.text(spec.levels.back().value), spec.text(largest)));
    }
    for (std::size_t i = 1; i < spec.levels.size(); ++i) {
        if (same_level(spec.levels[i - 1].value, spec.levels[i].value)
            || (spec.independent_waves && spec.levels[i - 1].key() == spec.levels[i].key())) {
            table.fail("values",
                       fmt::format("{} twice (a level is one stripe). Remove one", spec.text(spec.levels[i].value)));
        }
    }
    return spec;
}

}  // namespace overturn
