#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/command_line.hpp"
#include "cli/fit_tables.hpp"
#include "cli/stripe_csv.hpp"
#include "core/error.hpp"
#include "core/input_files.hpp"
#include "core/units.hpp"
#include "core/wrapped.hpp"
#include "motion/column_unit.hpp"
#include "output/curve_tables.hpp"
#include "output/curve_text.hpp"
#include "output/fit_json.hpp"
#include "output/frequency_text.hpp"
#include "output/stripe_tables.hpp"
#include "output/stripe_text.hpp"
#include "output/summary_tables.hpp"
#include "results/analysis.hpp"
#include "results/hazard_frequency.hpp"
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
    for (auto const dimension : {Dimension::acceleration, Dimension::velocity, Dimension::length}) {
        auto const of_table = unit_spelled(table.unit, dimension);
        auto const own = unit_spelled(unit, dimension);
        if (of_table && own) {
            return number * *own / *of_table;
        }
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
    InputFiles files(std::filesystem::path("."));
    auto const table = parse_stripes(files.read(options.stripes), options.stripes);
    auto const& stripes = table.stripes;
    constexpr double usual = 0.95;
    FragilityRequest request;
    request.confidence = options.confidence.value_or(usual);
    request.beta_u = options.beta_u.value_or(0);
    MeasuredFragility measured;
    measured.name = "amplitude";
    measured.label = table.amplitude;
    measured.units = table.unit.empty() ? "1" : table.unit;
    measured.shown_in = {"1"};  // its column names the unit
    if (!options.design_basis.empty()) {
        double const basis = design_basis_of(options.design_basis, table);
        measured.quote_base = "design-basis";
        for (double const multiple : quoted_multiples) {
            request.quotes.push_back({multiple * basis, multiple});
        }
    }
    auto const data = data_of(table, options);
    measured.fit = fit_fragility(data, request);
    measured.rank_area = rank_area(data.points);
    std::optional<HazardCurve> hazard;
    std::vector<BodyFrequency> frequencies;
    if (!options.hazard.empty()) {
        hazard = hazard_of_table(options, {.option = "--stripes",
                                           .column = table.amplitude,
                                           .measure = table.measure,
                                           .unit = table.unit,
                                           .lowest = table.stripes.front().amplitude,
                                           .highest = table.stripes.back().amplitude});
        frequencies.push_back(frequency_of(measured.fit, data, *hazard, request.confidence, 0));
        frequencies.back().body = table.amplitude;
        frequencies.back().limit = overturning_limit;
    }
    if (!options.json) {
        fmt::print("{}{}{}\n{}", narrowed(output::fragility_table({measured}, request.confidence)),
                   options.text.full && !std::isnan(measured.rank_area) ? output::rank_text() : std::string(),
                   hazard ? output::frequency_text(frequencies, *hazard, request.confidence) : std::string(),
                   output::table_stripes_text(table.amplitude, stripes, request.confidence, options.text.full));
        print_unread(table.unread);
        return done;
    }
    std::vector<MeasuredFragility> const fits{measured};
    auto tables = output::curve_tables({.body = "", .confidence = request.confidence}, fits);
    tables.insert(tables.begin(), output::stripe_table(stripes, measured.units, request.confidence));
    if (hazard) {
        std::ranges::move(output::frequency_tables(table.unit, frequencies, *hazard, request.confidence),
                          std::back_inserter(tables));
    }
    auto json = output::json_of(tables);
    if (hazard) {
        json["hazard_notes"] = hazard->remarks();
    }
    json["warnings"] = output::warnings_json("", fits, request.confidence);
    json["amplitude"] = table.amplitude;
    json["not_understood"] = table.unread;
    fmt::print("{}\n", json.dump(2));
    return done;
}

}  // namespace overturn::cli
