#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/command_line.hpp"
#include "cli/fit_tables.hpp"
#include "cli/named_files.hpp"
#include "core/error.hpp"
#include "core/wrapped.hpp"
#include "motion/column_unit.hpp"
#include "output/curve_spread.hpp"
#include "output/json.hpp"
#include "output/stated_curve.hpp"

namespace overturn::cli {
namespace {

// "0.9 g": a number with a unit of acceleration, velocity or length.
struct StatedMedian {
    double value = 0;  // [SI]
    IntensityUnit unit;
    Dimension dimension = Dimension::none;
};

StatedMedian read_median(std::string const& text) {
    auto const [number, unit] =
        stated_number(text, "--median", "a number above 0 with its unit). Write for example '0.9 g'");
    if (auto const known = intensity_unit_spelled(unit)) {
        return {number * known->si, {std::string(unit), known->si}, known->dimension};
    }
    throw InputError(
        fmt::format("--median: '{}' (states no unit of acceleration, velocity or length). Write for "
                    "example '0.9 g' or '90 cm/s'",
                    text));
}

}  // namespace

int fit_stated(FitOptions const& options) {
    validate(*options.beta > 0 && std::isfinite(*options.beta),
             "--beta: {} (must be above 0). It is a lognormal standard deviation", *options.beta);
    output::check_spread("--beta", *options.beta);
    auto const median = read_median(options.median);
    output::StatedCurve const curve{median.value, median.unit, median.dimension, *options.beta,
                                    options.beta_u.value_or(0)};
    TableFrequency frequency;
    constexpr double none = 1;     // no sample, no confidence: bounds
    constexpr double ends = 3.09;  // from a P of 0.1 % to one of 99.9 %
    if (!options.hazard.empty()) {
        auto hazard = parse_hazard(read_named(options.hazard), options.hazard,
                                   {.label = "",
                                    .dimension = curve.dimension,
                                    .unit = curve.unit,
                                    .lowest = curve.at(ends * curve.composite()),
                                    .highest = curve.at(-ends * curve.composite())});
        auto found = frequency_of_stated(curve.median, curve.beta, curve.beta_u, hazard);
        frequency = {std::move(hazard), std::move(found), "stated curve"};
    }
    if (!options.json) {
        fmt::print("{}{}", narrowed(output::text_of(curve)), frequency.text(none));
        return done;
    }
    auto json = output::Json{{"stated_curve", output::json_of(curve)}};
    frequency.add_to(json, std::string(si_symbol(curve.dimension)), none);
    fmt::print("{}\n", json.dump(2));
    return done;
}

}  // namespace overturn::cli
