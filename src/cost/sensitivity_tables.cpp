#include <algorithm>
#include <functional>
#include <iterator>
#include <limits>
#include <span>

#include "cost/sensitivity.hpp"

namespace overturn::cost {
namespace {

using output::stated_unit;
using output::Table;
using output::TableOf;

constexpr auto* coarse_meaning = "1: no median, as at most one level has both outcomes (the levels are too far apart)";

/// One input at one of its ends.
struct MovedEnd {
    SensitivityRow const* row;
    VariedInput const* input;
    std::size_t end;

    [[nodiscard]] bool refused() const { return !row->ends.at(end); }
    [[nodiscard]] Shift shift() const { return row->ends.at(end).value_or(Shift()); }
};

// begin_decided, begin_passed, begin_probability. `get(row)` is Counts.
template <class Row, class Get>
void add_counts(TableOf<Row>& table, std::string const& begin, std::string const& where, Get get) {
    table
        .add(begin + "decided", "1", "trials with a verdict " + where, [=](Row const& row) { return get(row).decided; })
        .add(begin + "passed", "1", "trials of these that exceeded the limit",
             [=](Row const& row) { return get(row).passed; })
        .add(begin + "probability", "1", "their share", [=](Row const& row) { return get(row).share(); });
}

// The body and the limit state of a row. `get(row)` has their numbers.
template <class Row, class Get> void add_place(TableOf<Row>& table, Sensitivity const& study, Get get) {
    table.category("body", "the body", study.bodies, [&, get](Row const& row) { return study.bodies[get(row).body]; })
        .category("limit", "the limit state", study.limits,
                  [&, get](Row const& row) { return study.limits[get(row).limit]; });
}

Table sensitivity_table(Sensitivity const& study) {
    TableOf<Sensitivity> table({.name = "study", .constants = {{"units", study.units}}}, std::span(&study, 1));
    table.add("title", "1", "title of the campaign", std::mem_fn(&Sensitivity::title))
        .add("waves", "1", "waves that were used", std::mem_fn(&Sensitivity::waves))
        .add("campaign_waves", "1", "waves of the campaign", std::mem_fn(&Sensitivity::campaign_waves))
        .add("confidence", "1", "of intervals", std::mem_fn(&Sensitivity::confidence))
        .add("measure", "1", "measure of the levels", std::mem_fn(&Sensitivity::measure))
        .add("stated_unit", "1", "unit in which levels are stated", std::mem_fn(&Sensitivity::shown_units))
        .add("stated_unit_si", "1", "SI value of one of it", std::mem_fn(&Sensitivity::shown_si))
        .add("design_basis", stated_unit(study.units), "level of the design basis",
             std::mem_fn(&Sensitivity::design_basis));
    return table.take();
}

Table unmoved_table(Sensitivity const& study) {
    TableOf<Unmoved> table({.name = "unmoved", .constants = {{"units", study.units}}}, study.unmoved);
    add_place(table, study, std::identity());
    table
        .add("median", stated_unit(study.units), "median of the curve as the campaign stands",
             std::mem_fn(&Unmoved::median))
        .add("levels_too_coarse", "1", coarse_meaning, std::mem_fn(&Unmoved::levels_too_coarse));
    add_counts(table, "", "at all levels", std::mem_fn(&Unmoved::all));
    if (study.design_basis) {
        add_counts(table, "design_basis_", "at the design basis", std::mem_fn(&Unmoved::at_design_basis));
    }
    return table.take();
}

void add_design_basis(TableOf<MovedEnd>& table) {
    add_counts(table, "design_basis_", "at the design basis",
               [](MovedEnd const& moved) { return moved.shift().at_design_basis; });
    table
        .add("design_basis_newly_passed", "1", "waves that pass the limit there only when it is moved",
             [](MovedEnd const& moved) { return moved.shift().design_passed; })
        .add("design_basis_no_longer_passed", "1", "waves that pass it there only when it is not",
             [](MovedEnd const& moved) { return moved.shift().design_no_longer; })
        .add("design_basis_p_value", "1", "P of so uneven a split of these by chance (McNemar 1947, exact)",
             [](MovedEnd const& moved) {
                 return moved.refused() ? std::nullopt : std::optional(moved.shift().design_p_value);
             });
}

Table moved_table(Sensitivity const& study) {
    static std::vector<std::string> const ends{"low", "high"};
    std::vector<MovedEnd> rows;
    std::vector<std::string> keys;
    for (auto const& row : study.rows) {
        auto const& input = study.inputs[row.input];
        rows.insert(rows.end(), {{&row, &input, 0}, {&row, &input, 1}});
        std::ranges::copy(input.keys, std::back_inserter(keys));
    }
    TableOf<MovedEnd> table({.name = "rows"}, rows);
    add_place(table, study, [](MovedEnd const& moved) { return *moved.row; });
    table
        .names("keys", "the input; several where bodies share a file", keys,
               [](MovedEnd const& moved) { return moved.input->keys; })
        .add("value", "1", "as it stands", [](MovedEnd const& moved) { return moved.input->value; })
        .add("source", "1", "where it comes from",
             [](MovedEnd const& moved) { return output::text_or_none(moved.input->source); })
        .add("range_stated", "1", "1: moved to the ends of its range; 0: by a tenth",
             [](MovedEnd const& moved) { return moved.input->range_stated; })
        .category("end", "which end of its range", ends, [](MovedEnd const& moved) { return ends[moved.end]; })
        .add("moved_to", "1", "its value there", [](MovedEnd const& moved) { return moved.input->ends.at(moved.end); })
        .add("refused", "1", "why a campaign with that value cannot be",
             [](MovedEnd const& moved) { return output::text_or_none(moved.input->refused.at(moved.end)); })
        .add("median_ratio", "1", "median with it moved over that without",
             [](MovedEnd const& moved) { return moved.shift().median_ratio; })
        .add("median_ratio", "1", "the ratio, by bootstrap over waves",
             [](MovedEnd const& moved) {
                 auto ratio = moved.shift().median_interval;
                 if (ratio && ratio->lower == 0) {
                     ratio->lower = -std::numeric_limits<double>::infinity();
                 }
                 return ratio;
             })
        .add("levels_too_coarse", "1", coarse_meaning,
             [](MovedEnd const& moved) { return moved.shift().levels_too_coarse; })
        .add("resolved", "1", "1: significant (the interval excludes no change)",
             [](MovedEnd const& moved) { return moved.shift().resolved(); })
        .add("compared", "1", "trials that both decide", [](MovedEnd const& moved) { return moved.shift().compared; })
        .add("newly_passed", "1", "of them pass the limit only when it is moved",
             [](MovedEnd const& moved) { return moved.shift().passed; })
        .add("no_longer_passed", "1", "of them pass it only when it is not",
             [](MovedEnd const& moved) { return moved.shift().no_longer; });
    if (study.design_basis) {
        add_design_basis(table);
    }
    return table.take();
}

Table unvaried_table(Sensitivity const& study) {
    TableOf<UnvariedInput> table({.name = "not_moved"}, study.unvaried);
    table.add("key", "1", "the input", std::mem_fn(&UnvariedInput::key))
        .add("value", "1", "as it stands", std::mem_fn(&UnvariedInput::value))
        .add("why", "1", "why it was not moved", std::mem_fn(&UnvariedInput::why));
    return table.take();
}

}  // namespace

std::vector<Table> sensitivity_tables(Sensitivity const& study) {
    return {sensitivity_table(study), unmoved_table(study), moved_table(study), unvaried_table(study)};
}

}  // namespace overturn::cost
