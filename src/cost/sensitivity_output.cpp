#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "cost/sensitivity.hpp"

namespace overturn::cost {
namespace {

using Json = nlohmann::ordered_json;

std::string percent(double ratio) { return std::isinf(ratio) ? "inf" : fmt::format("{:+.1f}", 100 * (ratio - 1)); }

// "-8.1 % [-9.0, -7.2]"
std::string median_text(Shift const& shift) {
    if (!shift.median_ratio) {
        return "-";
    }
    auto const& ends = *shift.median_interval;
    bool const open = ends.lower == 0 || std::isinf(ends.upper);
    return fmt::format(
        "{} % {}", percent(*shift.median_ratio),
        open ? std::string("[too few waves]")
             : fmt::format("[{}, {}]{}", percent(ends.lower), percent(ends.upper), shift.resolved() ? " *" : ""));
}

std::string share_text(Counts const& counts) {
    auto const share = counts.share();
    return share ? fmt::format("{:.3g}", *share) : std::string("-");
}

std::string design_text(Shift const& shift) {
    return fmt::format("{} (+{} -{}, p {:.2g})", share_text(shift.at_design_basis), shift.design_passed,
                       shift.design_no_longer, shift.design_p_value);
}

void append_row(std::string& text, Sensitivity const& study, SensitivityRow const& row) {
    auto const& input = study.inputs[row.input];
    for (std::size_t end = 0; end < input.ends.size(); ++end) {
        auto const name = end == 0 ? fmt::format("{}", fmt::join(input.keys, ", ")) : "";
        text += fmt::format("  {:<34} {:>14} {:>14}", name, end == 0 ? input.value : "", input.ends.at(end));
        if (auto const& shift = row.ends.at(end)) {
            text += fmt::format("  {:<28} {:>13}{}\n", median_text(*shift),
                                fmt::format("+{} -{} of {}", shift->passed, shift->no_longer, shift->compared),
                                study.design_basis ? "  " + design_text(*shift) : "");
        } else {
            text += fmt::format("  refused: {}\n", input.refused.at(end));
        }
    }
}

bool moves_nothing(SensitivityRow const& row) {
    return std::ranges::all_of(
        row.ends, [](auto const& end) { return end && end->flips() == 0 && end->median_ratio.value_or(1) == 1; });
}

std::string at_level(Sensitivity const& study, double value) {
    return fmt::format("{:.4g} {}", value / study.shown_si, study.shown_units == "1" ? "" : study.shown_units);
}

Json counts_json(Counts const& counts) {
    auto const share = counts.share();
    return {{"decided", counts.decided}, {"passed", counts.passed}, {"probability", share ? Json(*share) : Json()}};
}

Json end_json(VariedInput const& input, std::size_t end, std::optional<Shift> const& shift, bool has_design) {
    Json json{{"value", input.ends.at(end)},
              {"refused", input.refused.at(end).empty() ? Json() : Json(input.refused.at(end))}};
    if (!shift) {
        return json;
    }
    auto const known = [](double value) { return std::isfinite(value) && value > 0 ? Json(value) : Json(); };
    json["median_ratio"] = shift->median_ratio ? Json(*shift->median_ratio) : Json();
    json["median_ratio_interval"] =
        shift->median_interval
            ? Json::array({known(shift->median_interval->lower), known(shift->median_interval->upper)})
            : Json();
    json["resolved"] = shift->resolved();
    json["compared"] = shift->compared;
    json["newly_passed"] = shift->passed;
    json["no_longer_passed"] = shift->no_longer;
    if (has_design) {
        json["design_basis"] = counts_json(shift->at_design_basis);
        json["design_basis"]["newly_passed"] = shift->design_passed;
        json["design_basis"]["no_longer_passed"] = shift->design_no_longer;
        json["design_basis"]["p_value"] = shift->design_p_value;
    }
    return json;
}

}  // namespace

std::string sensitivity_table(Sensitivity const& study) {
    auto text = fmt::format(
        "{}\nwhat assumed numbers decide: each moved alone, to its range or by {:.0f} %, under the same {} waves of "
        "{}\n"
        "change of the median over {} with its {:g} % interval by resampled waves (*: more than these waves make of "
        "nothing); verdicts that changed (newly passed, no longer passed){}\n",
        study.title, 100 * usual_share, study.waves, study.campaign_waves, study.measure, 100 * study.confidence,
        study.design_basis ? "; P at the design basis (waves that changed it, exact p of so uneven a split)" : "");
    for (auto const& unmoved : study.unmoved) {
        text += fmt::format("\n{}, {}: median {}", study.bodies[unmoved.body], study.limits[unmoved.limit],
                            unmoved.median ? at_level(study, *unmoved.median) : "-");
        if (study.design_basis) {
            text +=
                fmt::format(", P {} at {}", share_text(unmoved.at_design_basis), at_level(study, *study.design_basis));
        }
        text += "\n";
        std::string nothing;
        for (auto const& row : study.rows) {
            if (row.body != unmoved.body || row.limit != unmoved.limit) {
                continue;
            }
            if (moves_nothing(row)) {
                nothing +=
                    fmt::format("{}{}", nothing.empty() ? "" : ", ", fmt::join(study.inputs[row.input].keys, ", "));
            } else {
                append_row(text, study, row);
            }
        }
        text += nothing.empty() ? "" : fmt::format("  no verdict changed by: {}\n", nothing);
    }
    for (auto const& input : study.unvaried) {
        text += fmt::format("not moved: {} = {} ({})\n", input.key, input.value, input.why);
    }
    if (study.inputs.empty()) {
        text += "No number is said to be assumed: state basis = \"assumed\" where one is.\n";
    }
    return text;
}

Json sensitivity_json(Sensitivity const& study) {
    Json json{{"title", study.title},
              {"waves", study.waves},
              {"campaign_waves", study.campaign_waves},
              {"confidence", study.confidence},
              {"measure", study.measure},
              {"units", study.units},
              {"stated_unit", study.shown_units},
              {"stated_unit_si", study.shown_si},
              {"design_basis", study.design_basis ? Json(*study.design_basis) : Json()},
              {"unmoved", Json::array()},
              {"rows", Json::array()},
              {"not_moved", Json::array()}};
    for (auto const& unmoved : study.unmoved) {
        json["unmoved"].push_back(
            {{"body", study.bodies[unmoved.body]},
             {"limit", study.limits[unmoved.limit]},
             {"median", unmoved.median ? Json(*unmoved.median) : Json()},
             {"all", counts_json(unmoved.all)},
             {"design_basis", study.design_basis ? counts_json(unmoved.at_design_basis) : Json()}});
    }
    for (auto const& row : study.rows) {
        auto const& input = study.inputs[row.input];
        json["rows"].push_back({{"body", study.bodies[row.body]},
                                {"limit", study.limits[row.limit]},
                                {"keys", input.keys},
                                {"value", input.value},
                                {"source", input.source.empty() ? Json() : Json(input.source)},
                                {"range_stated", input.range_stated},
                                {"low", end_json(input, 0, row.ends[0], study.design_basis.has_value())},
                                {"high", end_json(input, 1, row.ends[1], study.design_basis.has_value())}});
    }
    for (auto const& input : study.unvaried) {
        json["not_moved"].push_back({{"key", input.key}, {"value", input.value}, {"why", input.why}});
    }
    return json;
}

}  // namespace overturn::cost
