#include "output/detail/few_waves_text.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "campaign/limit_state.hpp"
#include "output/answer.hpp"
#include "response/registry.hpp"

namespace overturn::output {
namespace {

std::string number_or_dash(double value) { return std::isnan(value) ? std::string("-") : fmt::format("{:.3g}", value); }

// "1.3 touches": the response nearest to its limit, over that limit, and the limit's name. Of limits that only some
// models' own columns tell nothing is known here. What fell passed them all, but those that leave it out.
std::string nearest_limit(CampaignSpec const& spec, LimitJudge const& judge, TrialRow const& row) {
    if (entry_of(row.verdict).fell) {
        return "fell";
    }
    double most = -1;
    std::size_t which = 0;
    for (std::size_t limit = 1; limit < spec.limits.size(); ++limit) {
        double const near = judge.nearness(limit, row, {});
        if (near > most) {
            most = near;
            which = limit;
        }
    }
    return which == 0 ? std::string("-") : fmt::format("{:.3g} {}", most, said_name(spec.limits[which], spec.limits));
}

}  // namespace

std::string few_waves_text(CampaignSpec const& spec, std::span<TrialRow const> trials) {
    if (trials.empty()) {
        return {};
    }
    LimitJudge const judge(spec.limits, ModelSelector(spec.effects, spec.accuracy));
    std::size_t record = 6, body = 4;
    for (auto const& row : trials) {
        record = std::max(record, spec.source->name(row.wave).size());
        body = std::max(body, spec.bodies[row.body].name.size());
    }
    auto const levels = answer_levels(spec.levels);
    bool const limits = spec.limits.size() > 1;
    auto text = fmt::format("{:<{}}  {:<{}}  {:>12}  {:<12} {:>9} {:>10}  {:<8}{}\n", "record", record, "body", body,
                            spec.levels.measure_label(), "verdict", "slip [mm]", "tilt [deg]", "model",
                            limits ? "  response / limit" : "");
    for (auto const& row : trials) {
        if (std::ranges::find(levels, static_cast<std::size_t>(row.level)) == levels.end()) {
            continue;
        }
        auto const& of = spec.bodies[row.body];
        constexpr double millimetres = 1e3;
        text += fmt::format("{:<{}}  {:<{}}  {:>12}  {:<12} {:>9} {:>10}  {:<8}{}\n", spec.source->name(row.wave),
                            record, of.name, body, spec.levels.text(row.amplitude), entry_of(row.verdict).name,
                            of.friction ? number_or_dash(millimetres * row.peak_slip_m) : "-",
                            entry_of(row.verdict).fell ? "fell" : number_or_dash(row.peak_rotation_rad * 180 / pi),
                            row.model == unknown_category ? "unknown" : model_categories()[model_place(row.model)].name,
                            limits ? "  " + nearest_limit(spec, judge, row) : std::string());
    }
    return text;
}

}  // namespace overturn::output
