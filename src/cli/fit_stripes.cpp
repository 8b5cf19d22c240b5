#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "cli/fit_tables.hpp"
#include "cli/named_files.hpp"
#include "cli/stripe_csv.hpp"
#include "core/error.hpp"
#include "core/units.hpp"
#include "motion/column_unit.hpp"
#include "output/curve_text.hpp"
#include "output/stripe_tables.hpp"
#include "output/stripe_text.hpp"
#include "results/analysis.hpp"
#include "stats/bootstrap.hpp"
#include "stats/rank.hpp"

namespace overturn::cli {
namespace {

// In the table's unit: as stated, or converted.
double design_basis_of(std::string const& text, StripeTable const& table) {
    auto const [number, unit] = stated_number(text, "--design-basis", "a number above 0). Write for example '0.3 g'");
    if (unit.empty() || table.unit.empty()) {
        validate(
            unit.empty() == table.unit.empty(),
            "--design-basis: '{}' beside column '{}' (one of them states a unit, one none). State both with theirs",
            text, table.amplitude);
        return number;
    }
    auto const of_table = intensity_unit_spelled(table.unit);
    auto const own = intensity_unit_spelled(unit);
    if (of_table && own && of_table->dimension == own->dimension) {
        return number * own->si / of_table->si;
    }
    throw InputError(fmt::format("--design-basis: '{}' beside '{}' (units that cannot be converted). State it in {}",
                                 text, table.amplitude, table.unit));
}

// Waves by their names; else as stated; else no more than the fullest level has, where levels have several trials each.
// Of trials alone at their levels nothing says how many: no fewer than a curve needs.
FragilityData data_of(StripeTable const& table, FitOptions const& options) {
    auto data = FragilityData::of_stripes(table.stripes);
    if (!table.trials.empty()) {
        validate(!options.waves, "--waves: the table names its waves (column '{}'). Leave it out", table.wave);
        data.trials = table.trials;
        data.waves_shared = table.waves < std::ssize(data.trials);
        return data;
    }
    auto const most = std::ranges::max(table.stripes, {}, &Stripe::trials).trials;
    std::int64_t trials = 0;
    for (auto const& stripe : table.stripes) {
        trials += stripe.trials;
    }
    validate(!options.waves || (*options.waves >= most && *options.waves <= trials),
             "--waves: {} (the table has {} trials, {} of them at one level). State a number from {} to {}",
             options.waves.value_or(0), trials, most, most, trials);
    bool const alone = trials < 2 * std::ssize(table.stripes);
    auto const fewest = alone ? std::min(trials, std::max(most, least_waves)) : most;
    data.fewest_waves = options.waves.value_or(fewest);
    data.waves_shared = data.fewest_waves < trials;
    data.waves_known = !data.waves_shared        ? WavesKnown::yes
                       : alone && !options.waves ? WavesKnown::number_unknown
                                                 : WavesKnown::no;
    return data;
}

}  // namespace

int fit_stripes(FitOptions const& options) {
    auto const table = parse_stripes(read_named(options.stripes), options.stripes);
    auto request = request_of(options);
    TableFit fit{.axis = {.option = "--stripes",
                          .column = table.amplitude,
                          .measure = table.measure,
                          .unit = table.unit,
                          .lowest = table.stripes.front().amplitude,
                          .highest = table.stripes.back().amplitude},
                 .unread = table.unread};
    fit.measured.name = "amplitude";
    if (!options.design_basis.empty()) {
        double const basis = design_basis_of(options.design_basis, table);
        fit.measured.quote_base = "design-basis";
        for (double const multiple : quoted_multiples) {
            request.quotes.push_back({multiple * basis, multiple});
        }
    }
    fit.data = data_of(table, options);
    fit.measured.fit = fit_fragility(fit.data, request);
    fit.measured.rank_area = rank_area(fit.data.points);
    fit.remark = options.text.full && !std::isnan(fit.measured.rank_area) ? output::rank_text() : std::string();
    fit.below =
        "\n" + output::table_stripes_text(table.amplitude, table.stripes, request.confidence, options.text.full);
    fit.tables = {output::stripe_table(table.stripes, unit_of(fit.axis), request.confidence)};
    fit.json["amplitude"] = table.amplitude;
    return print_fit(options, request, std::move(fit));
}

}  // namespace overturn::cli
