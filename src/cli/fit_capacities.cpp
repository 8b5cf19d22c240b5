#include <algorithm>
#include <filesystem>
#include <iterator>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/capacity_csv.hpp"
#include "cli/command_line.hpp"
#include "cli/fit_tables.hpp"
#include "core/input_files.hpp"
#include "core/wrapped.hpp"
#include "output/curve_tables.hpp"
#include "output/curve_text.hpp"
#include "output/fit_json.hpp"
#include "output/frequency_text.hpp"
#include "output/json.hpp"
#include "output/summary_tables.hpp"
#include "results/hazard_frequency.hpp"

namespace overturn::cli {
namespace {

std::int64_t not_reached(CapacityTable const& table) {
    return std::ranges::count(table.capacities, false, &Capacity::reached);
}

std::string head_of(CapacityTable const& table) {
    auto const unit = IntensityUnit{table.unit, 1};
    auto text = fmt::format("{} {}, {} to {}; {} not reached\n", table.capacities.size(),
                            table.capacities.size() == 1 ? "capacity" : "capacities",
                            unit.text(table.capacities.front().intensity), unit.text(table.capacities.back().intensity),
                            not_reached(table));
    if (auto const moments = moments_of(table.capacities)) {
        text +=
            moments->beta == 0
                ? fmt::format("  moments: all capacities equal {}: no spread\n", unit.text(moments->median))
                : fmt::format("  moments: median {}, beta {:.4g} (n - 1)\n", unit.text(moments->median), moments->beta);
    }
    return text;
}

output::Json head_json(CapacityTable const& table) {
    output::Json json{{"count", table.capacities.size()},
                      {"not_reached", not_reached(table)},
                      {"units", table.unit},
                      {"moments_median", nullptr},
                      {"moments_beta", nullptr}};
    if (auto const moments = moments_of(table.capacities)) {
        json["moments_median"] = moments->median;
        json["moments_beta"] = moments->beta;
    }
    return json;
}

MeasuredFragility fitted(CapacityTable const& table, FragilityRequest const& request) {
    MeasuredFragility measured;
    measured.name = "capacity";
    measured.label = table.column;
    measured.units = table.unit.empty() ? "1" : table.unit;
    measured.shown_in = {"1"};  // its column names the unit
    measured.fit = fragility_of(table.capacities, request);
    return measured;
}

}  // namespace

int fit_capacities(FitOptions const& options) {
    InputFiles files(std::filesystem::path("."));
    auto const table = parse_capacities(files.read(options.capacities), options.capacities);
    constexpr double usual = 0.95;
    FragilityRequest request;
    request.confidence = options.confidence.value_or(usual);
    request.beta_u = options.beta_u.value_or(0);
    auto const measured = fitted(table, request);
    std::optional<HazardCurve> hazard;
    std::vector<BodyFrequency> frequencies;
    if (!options.hazard.empty()) {
        hazard = hazard_of_table(options, {.option = "--capacities",
                                           .column = table.column,
                                           .measure = table.measure,
                                           .unit = table.unit,
                                           .lowest = table.capacities.front().intensity,
                                           .highest = table.capacities.back().intensity});
        auto const stripes = FragilityData::of_stripes(stripes_of(table.capacities));
        frequencies.push_back(frequency_of(measured.fit, stripes, *hazard, request.confidence, 0));
        frequencies.back().body = table.column;
        frequencies.back().limit = overturning_limit;
    }
    if (!options.json) {
        fmt::print("{}\n{}{}", head_of(table), narrowed(output::fragility_table({measured}, request.confidence)),
                   hazard ? output::frequency_text(frequencies, *hazard, request.confidence) : std::string());
        print_unread(table.unread);
        return done;
    }
    std::vector<MeasuredFragility> const fits{measured};
    auto tables = output::curve_tables({.body = "", .confidence = request.confidence}, fits);
    if (hazard) {
        std::ranges::move(output::frequency_tables(table.unit, frequencies, *hazard, request.confidence),
                          std::back_inserter(tables));
    }
    auto json = output::json_of(tables);
    json["capacities"] = head_json(table);
    json["not_understood"] = table.unread;
    if (hazard) {
        json["hazard_notes"] = hazard->remarks();
    }
    json["warnings"] = output::warnings_json("", fits, request.confidence);
    fmt::print("{}\n", json.dump(2));
    return done;
}

}  // namespace overturn::cli
