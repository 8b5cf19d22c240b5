#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "cli/fit_tables.hpp"
#include "cli/named_files.hpp"
#include "core/error.hpp"
#include "core/units.hpp"
#include "motion/column_unit.hpp"
#include "results/hazard_table.hpp"

namespace overturn::cli {

StatedNumber stated_number(std::string_view text, std::string_view option, std::string_view what) {
    auto const plain = trimmed(text);
    auto const split = std::min(plain.find_first_of(" \t"), plain.size());
    StatedNumber stated{.unit = trimmed(plain.substr(split))};
    validate(parse_number(plain.substr(0, split), stated.value) && stated.value > 0 && std::isfinite(stated.value),
             "{}: '{}' (must be {}", option, text, what);
    return stated;
}

HazardCurve hazard_of_table(FitOptions const& options, TableAxis const& axis) {
    validate(!axis.unit.empty(),
             "--hazard beside {}: column '{}' states no unit (none is guessed). Call it for example 'pga [g]'",
             axis.option, axis.column);
    validate(
        axis.measure != "sa",
        "--hazard beside {}: column '{}' states no period (of which oscillator?). Call it for example 'sa(1 s) [{}]'",
        axis.option, axis.column, axis.unit);
    auto const unit = intensity_unit_spelled(axis.unit);
    validate(unit.has_value(),
             "--hazard beside {}: column '{}' (no unit of acceleration, velocity or length). Call it for example "
             "'pga [g]'",
             axis.option, axis.column);
    double const si = unit->si;
    auto const hazard = parse_hazard(read_named(options.hazard), options.hazard,
                                     {.label = axis.measure,
                                      .dimension = unit->dimension,
                                      .unit = {axis.unit, si},
                                      .lowest = axis.lowest * si,
                                      .highest = axis.highest * si,
                                      .column = axis.column});
    auto points = hazard.points();
    for (auto& point : points) {
        point.intensity /= si;
    }
    auto remarks = hazard.remarks();
    if (axis.measure.empty()) {
        remarks.push_back(fmt::format(
            "column '{}' of the table names no measure: it is taken to be the curve's, which names none either",
            axis.column));
    }
    return HazardCurve(std::move(points), {hazard.stated().symbol, hazard.stated().si / si}, std::move(remarks));
}

}  // namespace overturn::cli
