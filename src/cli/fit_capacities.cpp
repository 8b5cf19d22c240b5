#include "cli/capacity_csv.hpp"
#include "cli/fit_tables.hpp"
#include "cli/named_files.hpp"
#include "output/stripe_tables.hpp"
#include "output/stripe_text.hpp"
#include "stats/capacity_fit.hpp"

namespace overturn::cli {

int fit_capacities(FitOptions const& options) {
    auto const table = parse_capacities(read_named(options.capacities), options.capacities);
    TableFit fit{.axis = {.option = "--capacities",
                          .column = table.column,
                          .measure = table.measure,
                          .unit = table.unit,
                          .lowest = table.capacities.front().intensity,
                          .highest = table.capacities.back().intensity},
                 .data = FragilityData::of_stripes(stripes_of(table.capacities)),
                 .unread = table.unread,
                 .above = output::capacities_text(table.capacities, {table.unit, 1}) + "\n"};
    auto const request = request_of(options);
    fit.measured.name = "capacity";
    fit.measured.fit = fragility_of(table.capacities, request);
    fit.json["capacities"] = output::json_of(output::capacities_table(table.capacities, table.unit)).front();
    return print_fit(options, request, std::move(fit));
}

}  // namespace overturn::cli
