#include "output/fit_json.hpp"

#include <algorithm>
#include <iterator>

#include "campaign/cautions.hpp"
#include "output/campaign_tables.hpp"
#include "output/detail/criterion_words.hpp"
#include "output/detail/fit_words.hpp"
#include "output/records_table.hpp"
#include "output/stated_curve.hpp"
#include "output/stripe_tables.hpp"
#include "output/summary_tables.hpp"
#include "output/typed_columns.hpp"

namespace overturn::output {
Json warnings_json(std::string const& body, std::span<MeasuredFragility const> fits, double confidence,
                   WarningUnits units) {
    auto list = Json::array();
    for (auto const& fit : fits) {
        auto const unit = units == WarningUnits::si ? IntensityUnit{fit.units} : fit.shown_in;
        for (auto const& text : warnings_of(fit.fit, unit, confidence)) {
            list.push_back({{"body", body}, {"limit", fit.limit}, {"measure", fit.name}, {"text", text}});
        }
    }
    return list;
}

Json fit_json(CampaignSpec const& spec, Statistics const& statistics, std::span<BodyAnalysis const> analysis,
              double confidence, WarningUnits units) {
    Json json{{"variability", spec.source->about().variability}, {"waves_alike", spec.source->about().shared.most}};
    auto tables = campaign_tables(spec, statistics, analysis, confidence);
    give_typed_units(tables, spec);
    json.update(json_of(tables));
    json["cautions"] = cautions_of(spec);
    json["warnings"] = Json::array();
    json["verdict"] = Json::array();
    for (auto const& body : analysis) {
        for (std::size_t limit = 0; limit < spec.limits.size(); ++limit) {
            auto const warnings = warnings_json(body.body, body.curves_of(limit), confidence, units);
            json["warnings"].insert(json["warnings"].end(), warnings.begin(), warnings.end());
        }
        auto const words = words_on(body, confidence);
        json["verdict"].push_back(
            {{"body", body.body}, {"supports", words.supports}, {"against", words.against}, {"open", words.open}});
    }
    return json;
}

std::vector<Table> json_tables(Printed const& of) {
    auto const& answered = of.answered;
    auto const& spec = answered.spec;
    std::vector<Table> tables{answer_table(answered), records_table(spec, of.few),
                              telling_trial_table(spec, of.telling), hand_check_table(spec, of.by_hand)};
    if (!of.pairs.empty()) {
        tables.push_back(two_measure_table(of.pairs, answered.confidence));
    }
    if (of.hazard != nullptr) {
        std::ranges::move(frequency_tables(spec.levels.units(), answered.frequencies, *of.hazard, answered.confidence),
                          std::back_inserter(tables));
    }
    return tables;
}

std::vector<Table> empty_json_tables(CampaignSpec const& spec) {
    Statistics const none(spec);
    HazardCurve const hazard({{1, 1}, {2, 0.5}});
    auto tables = json_tables({.answered = {.spec = spec, .statistics = none, .analysis = {}}, .hazard = &hazard});
    tables.push_back(two_measure_table({}, spec.confidence));
    tables.push_back(capacities_table({}, ""));
    tables.push_back(stated_curve_table({}));
    return tables;
}

}  // namespace overturn::output
