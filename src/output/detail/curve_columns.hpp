/// The columns of a curve and of a quoted probability.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "output/table.hpp"
#include "results/analysis.hpp"

namespace overturn::output {

/// Columns of the trials and their outcomes.
void add_trial_columns(TableOf<MeasuredFragility>& table, Passing passing);
/// Median, beta and the points that are read off the curve, with their intervals.
void add_curve_columns(TableOf<MeasuredFragility>& table);
/// Whether the curve describes the data, and what the data hold without it.
void add_check_columns(TableOf<MeasuredFragility>& table, Passing passing);

/// The columns of what was seen at some intensities: from, to, trials, overturned, interval. `get(row)` is a SeenBound
/// or null.
template <class Row, class Get>
void add_seen_columns(TableOf<Row>& table, std::string const& name, std::string const& what, std::string const& passed,
                      Get get) {
    auto const value = [get](auto member) {
        return [get, member](Row const& row) {
            SeenBound const* const seen = get(row);
            return seen != nullptr ? std::optional(seen->*member) : std::nullopt;
        };
    };
    table.add(name + "_from", unit_of_row(), "lowest intensity of " + what, value(&SeenBound::from))
        .add(name + "_to", unit_of_row(), "highest intensity of " + what, value(&SeenBound::to))
        .add(name + "_trials", "1", "trials of " + what + "; distinct waves where trials share them",
             value(&SeenBound::units))
        .add(name + "_" + passed, "1", "trials of these that exceeded the limit", value(&SeenBound::overturned))
        .add(name, "1", "P of " + what, value(&SeenBound::probability));
}

/// P at one intensity. `Row` has a `part`, the QuotedProbability, and a `curve`.
template <class Row> void add_quote_columns(TableOf<Row>& table, std::string const& passed) {
    auto const seen = [](std::optional<SeenBound> QuotedProbability::*which) {
        return [which](Row const& row) { return row.part->*which ? &*(row.part->*which) : nullptr; };
    };
    auto const side = [](SeenBound Neighbours::*which) {
        return [which](Row const& row) -> SeenBound const* {
            auto const& neighbours = row.part->neighbours;
            return neighbours && ((*neighbours).*which).units > 0 ? &((*neighbours).*which) : nullptr;
        };
    };
    using Source = QuotedProbability::Source;
    table
        .category("of", "what the multiple is of", {"design-basis", "v_ereq"},
                  [](Row const& row) { return row.curve->quote_base; })
        .add("multiple", "1", "of the design basis, or of V_Ereq",
             [](Row const& row) { return row.part->quote.multiple; })
        .add("amplitude", unit_of_row(), "intensity", [](Row const& row) { return row.part->quote.intensity; })
        .add("probability", "1", "P there; NaN: not reported", [](Row const& row) { return row.part->probability; })
        .add("", "1", "its interval",
             [](Row const& row) {
                 return row.part->source == Source::none ? std::nullopt : std::optional(row.part->bounds);
             })
        .category("bounds_from", "where the interval comes from", {"none", "curve", "stripe", "neighbours"},
                  [](Row const& row) {
                      static constexpr std::array names{"none", "curve", "stripe", "neighbours"};
                      return std::string(names.at(static_cast<std::size_t>(row.part->source)));
                  })
        .add("curve_probability", "1", "P of the curve, also where it is not reported; NaN: below 1/(10 n)",
             [](Row const& row) { return row.part->bound ? std::nullopt : row.part->curve; })
        .add("trials", "1", "trials at this intensity", [](Row const& row) { return row.part->trials; })
        .add(passed, "1", "trials of these that exceeded the limit",
             [](Row const& row) { return row.part->overturned; })
        .add("observed", "1", "their proportion",
             [](Row const& row) {
                 return row.part->trials > 0 ? std::optional(row.part->overturned / row.part->trials) : std::nullopt;
             })
        .add("observed", "1", "the observed proportion, exact",
             [](Row const& row) { return row.part->trials > 0 ? std::optional(row.part->seen) : std::nullopt; });
    add_seen_columns(table, "pooled", "stripes from there on that ended the same way", passed,
                     seen(&QuotedProbability::pooled));
    add_seen_columns(table, "below", "the nearest stripe below", passed, side(&Neighbours::below));
    add_seen_columns(table, "above", "the nearest stripe above", passed, side(&Neighbours::above));
    add_seen_columns(table, "bound", "the trials that bound P where the curve's P is below `least`", passed,
                     seen(&QuotedProbability::bound));
    table
        .add("least", "1", "1/(10 n): the P of the curve is not reported below it",
             [](Row const& row) { return row.part->least; })
        .add("outside_data", "1", "1: below the lowest or above the highest intensity of the trials",
             [](Row const& row) { return row.part->outside_data; })
        .add("in_tail", "1", "1: P is below a tenth of the lowest proportion that is not zero",
             [](Row const& row) { return row.part->in_tail; });
}

}  // namespace overturn::output
