#include <array>
#include <cmath>

#include <nlohmann/json.hpp>

#include "cost/study_output.hpp"

namespace overturn::cost {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json spread_json(Spread const& spread) {
    return {{"count", spread.count},
            {"median", number(spread.median)},
            {"p95", number(spread.p95)},
            {"worst", number(spread.worst)}};
}

Json step_error_json(StepError const& error) {
    Json quantities = Json::array();
    for (auto const& quantity : error.quantities) {
        quantities.push_back({{"name", quantity.name},
                              {"step", spread_json(quantity.step)},
                              {"rounding", spread_json(quantity.rounding)}});
    }
    return {{"trials", error.trials},
            {"step_flips", error.step_flips},
            {"rounding_flips", error.rounding_flips},
            {"quantities", quantities}};
}

Json row_json(Measured const& row, bool here) {
    return {{"label", row.setting.label},
            {"settings", row.setting.settings},
            {"here", here},
            {"on_front", row.on_front},
            {"cpu_s", row.seconds},
            {"error", spread_json(row.error)},
            {"trials", row.trials},
            {"flips", row.flips},
            {"overturning_flips", row.overturning_flips},
            {"probability_error", number(row.probability_error)},
            {"ks_distance", number(row.ks)}};
}

Json knob_json(KnobResult const& result) {
    Json rows = Json::array();
    for (std::size_t i = 0; i < result.rows.size(); ++i) {
        rows.push_back(row_json(result.rows[i], result.knob.here && *result.knob.here == i));
    }
    return {{"name", result.knob.name},   {"title", result.knob.title},
            {"error", result.knob.error}, {"timed", result.knob.timed},
            {"units", result.units},      {"floor", result.floor},
            {"advice", result.advice},    {"settings", rows}};
}

Json waves_json(Study const& study) {
    Json subsets = Json::array();
    for (auto const& point : study.sampling.subsets) {
        subsets.push_back({{"waves", point.waves},
                           {"cpu_s", point.seconds},
                           {"width", point.width},
                           {"root_n_width", point.root_n_width}});
    }
    return {{"stripes", study.sampling.stripes},
            {"confidence", study.confidence},
            {"probability", study.sampling.probability},
            {"campaign_waves", study.campaign_waves},
            {"campaign_half_width", study.sampling.half_width},
            {"campaign_cpu_s", study.sampling.seconds},
            {"subsets", subsets}};
}

Json rare_json(RareCost const& rare) {
    Json points = Json::array();
    for (auto const& point : rare.points) {
        points.push_back({{"method", name_of(point.method)},
                          {"effort", point.effort},
                          {"cpu_s", point.seconds},
                          {"waves", point.waves},
                          {"cov", point.cov > 0 ? Json(point.cov) : Json(nullptr)},
                          {"foretold", point.foretold},
                          {"reason", point.reason.empty() ? Json(nullptr) : Json(point.reason)}});
    }
    return {{"body", rare.body},
            {"amplitude", rare.amplitude},
            {"probability", rare.probability ? Json(*rare.probability) : Json(nullptr)},
            {"points", points}};
}

}  // namespace

Json study_json(Study const& study) {
    static constexpr std::array dominates{"sampling", "numerical", "unknown"};
    Json json{{"title", study.title},
              {"waves", study.waves},
              {"trials", study.trials},
              {"campaign_trials", study.campaign_trials},
              {"reference_cpu_s", study.reference_seconds},
              {"rounding",
               {{"error", spread_json(study.rounding.peak)},
                {"trials", study.rounding.trials},
                {"flips", study.rounding.flips},
                {"ks_distance", number(study.rounding.ks)}}},
              {"step_error", step_error_json(study.step_error)},
              {"knobs", Json::array()},
              {"sampling", study.is_grid ? Json(nullptr) : waves_json(study)}};
    for (auto const& result : study.knobs) {
        json["knobs"].push_back(knob_json(result));
    }
    if (study.rare) {
        json["rare"] = rare_json(*study.rare);
    }
    if (study.is_grid) {
        json["balance"] = {{"dominates", nullptr},
                           {"numerical", study.balance.numerical},
                           {"numerical_is_bound", study.balance.is_bound},
                           {"sampling", nullptr},
                           {"factor", nullptr},
                           {"sentence", study.sentence}};
        return json;
    }
    json["balance"] = {{"dominates", dominates.at(static_cast<std::size_t>(study.balance.dominates))},
                       {"numerical", study.balance.numerical},
                       {"numerical_is_bound", study.balance.is_bound},
                       {"sampling", study.balance.sampling},
                       {"factor", number(study.balance.factor)},
                       {"sentence", study.sentence}};
    return json;
}

}  // namespace overturn::cost
