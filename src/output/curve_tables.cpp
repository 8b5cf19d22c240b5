#include "output/curve_tables.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "output/detail/curve_columns.hpp"
#include "output/detail/fit_names.hpp"
#include "results/schema.hpp"

namespace overturn::output {
namespace {

using Curve = MeasuredFragility;

Table begin(char const* name, CurvesOf const& of, char const* axis = "") {
    return {.name = name,
            .group = group_of(name, of.body, of.limit),
            .axis = axis,
            .constants = {{"body", of.body}, {"limit", of.limit}, {"confidence", of.confidence}}};
}

std::vector<std::string> measure_names(std::span<Curve const> fits) {
    std::vector<std::string> names;
    std::ranges::transform(fits, std::back_inserter(names), &Curve::name);
    return names;
}

// The units of the measures, each once.
std::vector<std::string> unit_names(std::span<Curve const> fits) {
    std::vector<std::string> units;
    for (auto const& fit : fits) {
        if (std::ranges::find(units, fit.units) == units.end()) {
            units.push_back(fit.units);
        }
    }
    return units;
}

// What the rows of a table of one measure each begin with.
template <class Row> void add_measure(TableOf<Row>& table, std::span<Curve const> fits, auto curve_of) {
    table
        .category("measure", "intensity measure", measure_names(fits),
                  [=](Row const& row) { return curve_of(row).name; })
        .category("units",
                  "unit of the measure, and of every column of this row whose attribute units_from names this column",
                  unit_names(fits), [=](Row const& row) { return curve_of(row).units; });
}

// A part of a curve, and its curve.
template <class Part> struct PartOf {
    Curve const* curve;
    Part const* part;
};

template <class Part, class List> std::vector<PartOf<Part>> parts_of(std::span<Curve const> fits, List list) {
    std::vector<PartOf<Part>> parts;
    for (auto const& fit : fits) {
        for (auto const& part : list(fit)) {
            parts.push_back({&fit, &part});
        }
    }
    return parts;
}

template <class Part, class List>
TableOf<PartOf<Part>> part_table(char const* name, CurvesOf const& of, std::span<Curve const> fits,
                                 std::vector<PartOf<Part>>& parts, List list) {
    parts = parts_of<Part>(fits, list);
    TableOf<PartOf<Part>> table(begin(name, of), parts);
    add_measure(table, fits, [](PartOf<Part> const& row) -> Curve const& { return *row.curve; });
    return table;
}

Table probability_table(CurvesOf const& of, std::span<Curve const> fits) {
    std::vector<PartOf<QuotedProbability>> parts;
    auto table = part_table(
        "probabilities", of, fits, parts, [](Curve const& curve) -> auto const& { return curve.fit.quotes; });
    add_quote_columns(table, passed_name(fits.front().fit.passing));
    return table.take();
}

Table band_table(CurvesOf const& of, std::span<Curve const> fits) {
    using Row = PartOf<BandPoint>;
    std::vector<Row> parts;
    auto table = part_table(
        "band", of, fits, parts, [](Curve const& curve) -> auto const& { return curve.fit.band; });
    table.add("amplitude", unit_of_row(), "intensity", [](Row const& row) { return row.part->intensity; })
        .add("probability", "1", "P of the curve", [](Row const& row) { return row.part->probability; })
        .add("", "1", "its pointwise interval", [](Row const& row) { return row.part->bounds; });
    return table.take();
}

Table isotonic_table(CurvesOf const& of, std::span<Curve const> fits) {
    using Row = PartOf<PooledPoints>;
    std::vector<Row> parts;
    auto table = part_table(
        "isotonic", of, fits, parts, [](Curve const& curve) -> auto const& { return curve.fit.isotonic; });
    table
        .add("from", unit_of_row(), "lowest intensity that shares the estimate",
             [](Row const& row) { return row.part->from; })
        .add("to", unit_of_row(), "highest intensity that shares it", [](Row const& row) { return row.part->to; })
        .add("trials", "1", "trials there", [](Row const& row) { return row.part->trials; })
        .add(passed_name(fits.front().fit.passing), "1", "trials of these that exceeded the limit",
             [](Row const& row) { return row.part->overturned; })
        .add("probability", "1", "isotonic estimate of P: maximum likelihood, never decreasing",
             [](Row const& row) { return row.part->probability(); });
    return table.take();
}

struct Drawn {
    Curve const* curve;
    std::size_t place;
};

Table drawn_table(CurvesOf const& of, std::span<Curve const> fits) {
    std::vector<Drawn> rows;
    for (auto const& fit : fits) {
        for (std::size_t k = 0; fit.split && k < fit.split->per_score.size(); ++k) {
            rows.push_back({&fit, k});
        }
    }
    TableOf<Drawn> table(begin("drawn", of), rows);
    add_measure(table, fits, [](Drawn const& row) -> Curve const& { return *row.curve; });
    table
        .category("quantity", "drawn property of the body",
                  [](Drawn const& row) { return row.curve->drawn.at(row.place); })
        .add("log_median_per_deviation", "1", "change of ln median with one standard deviation of the quantity",
             [](Drawn const& row) { return row.curve->split->per_score.at(row.place); })
        .add("standard_error", "1", "its standard error",
             [](Drawn const& row) { return row.curve->split->per_score_error.at(row.place); });
    return table.take();
}

}  // namespace

std::string passed_name(Passing passing) { return passing == Passing::exceeded ? "exceeded" : "overturned"; }

Table curve_table(CurvesOf const& of, std::span<MeasuredFragility const> fits) {
    auto const passing = fits.front().fit.passing;
    TableOf<Curve> table(begin("fragility", of, "measure"), fits);
    add_measure(table, fits, [](Curve const& curve) -> Curve const& { return curve; });
    table.add("label", "1", "the measure as figures and tables name it", [](Curve const& curve) { return curve.label; })
        .add("title", "1", "the measure as a figure's axis names it", [](Curve const& curve) { return curve.title; })
        .add("depends_on_levels", "1",
             "1: the curve depends on the levels that were run, and on the number of waves at each",
             [](Curve const& curve) { return !curve.of_levels; })
        .category("state", "state of the fit", names_of_states(passing),
                  [](Curve const& curve) { return name_of(curve.fit.state, curve.fit.passing); });
    add_trial_columns(table, passing);
    add_curve_columns(table);
    add_check_columns(table, passing);
    return table.take();
}

std::vector<Table> curve_tables(CurvesOf const& of, std::span<MeasuredFragility const> fits) {
    return {curve_table(of, fits), probability_table(of, fits), band_table(of, fits), isotonic_table(of, fits),
            drawn_table(of, fits)};
}

}  // namespace overturn::output
