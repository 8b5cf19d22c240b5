#include "cli/fit_tables.hpp"

#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "cli/command_line.hpp"
#include "core/wrapped.hpp"
#include "output/curve_tables.hpp"
#include "output/curve_text.hpp"
#include "output/fit_json.hpp"
#include "output/frequency_text.hpp"
#include "output/summary_tables.hpp"

namespace overturn::cli {
namespace {

output::Json json_of(TableFit const& fit, TableFrequency const& frequency, double confidence) {
    std::vector<MeasuredFragility> const fits{fit.measured};
    auto tables = fit.tables;
    std::ranges::move(output::curve_tables({.body = "", .confidence = confidence}, fits), std::back_inserter(tables));
    auto json = output::json_of(tables);
    frequency.add_to(json, fit.axis.unit, confidence);
    json.update(fit.json);
    json["not_understood"] = fit.unread;
    json["warnings"] = output::warnings_json("", fits, confidence);
    return json;
}

}  // namespace

TableFrequency::TableFrequency(HazardCurve curve, BodyFrequency frequency, std::string name)
    : hazard(std::move(curve)), of{std::move(frequency)} {
    of.front().body = std::move(name);
    of.front().limit = overturning_limit;
}

std::string TableFrequency::text(double confidence) const {
    return hazard ? output::frequency_text(of, *hazard, confidence) : std::string();
}

void TableFrequency::add_to(output::Json& json, std::string const& unit, double confidence) const {
    if (hazard) {
        json.update(output::json_of(output::frequency_tables(unit, of, *hazard, confidence)));
        json["hazard_notes"] = hazard->remarks();
    }
}

FragilityRequest request_of(FitOptions const& options) {
    constexpr double usual = 0.95;
    FragilityRequest request;
    request.confidence = options.confidence.value_or(usual);
    request.beta_u = options.beta_u.value_or(0);
    return request;
}

std::string unit_of(TableAxis const& axis) { return axis.unit.empty() ? "1" : axis.unit; }

int print_fit(FitOptions const& options, FragilityRequest const& request, TableFit fit) {
    fit.measured.label = fit.axis.column;
    fit.measured.units = unit_of(fit.axis);
    fit.measured.shown_in = {"1"};  // its column names the unit
    TableFrequency frequency;
    if (!options.hazard.empty()) {
        auto hazard = hazard_of_table(options, fit.axis);
        auto found = frequency_of(fit.measured.fit, fit.data, hazard, request.confidence, 0);
        frequency = {std::move(hazard), std::move(found), fit.axis.column};
    }
    if (options.json) {
        fmt::print("{}\n", json_of(fit, frequency, request.confidence).dump(2));
        return done;
    }
    fmt::print("{}{}{}{}{}", fit.above, narrowed(output::fragility_table({fit.measured}, request.confidence)),
               fit.remark, frequency.text(request.confidence), fit.below);
    for (auto const& line : fit.unread) {
        fmt::print("not understood, {}\n", line);
    }
    return done;
}

}  // namespace overturn::cli
