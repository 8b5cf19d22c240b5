#include "cli/fit_json.hpp"

#include <array>
#include <cstddef>

#include "cli/assumptions_told.hpp"
#include "cli/json_values.hpp"
#include "cli/together_json.hpp"
#include "core/error.hpp"
#include "response/registry.hpp"
#include "results/schema.hpp"

namespace overturn::cli {
namespace {

Json share_json(Share const& share) {
    bool const any = share.of > 0;
    return {{"count", share.count},
            {"of", share.of},
            {"share", or_null(any, any ? share.value() : 0)},
            {"lower", any ? number(share.interval.lower) : nullptr},
            {"upper", any ? number(share.interval.upper) : nullptr}};
}

Json quantiles_json(std::optional<RatioQuantiles> const& q) {
    if (!q) {
        return nullptr;
    }
    return {{"count", q->count},   {"lowest", q->lowest}, {"p05", q->p05}, {"p25", q->p25},
            {"median", q->median}, {"p75", q->p75},       {"p95", q->p95}, {"highest", q->highest}};
}

}  // namespace

void check_fit_options(double beta_u, std::optional<double> confidence) {
    validate(beta_u >= 0 && std::isfinite(beta_u),
             "--beta-u: {} (must be 0 or above). It is a lognormal standard deviation", beta_u);
    validate(!confidence || (*confidence > 0 && *confidence < 1),
             "--confidence: {} (must lie between 0 and 1). State e.g. 0.95", confidence.value_or(0));
}

Json stripe_json(std::string const& body, std::size_t level, Stripe const& stripe, double confidence,
                 std::string const& limit) {
    auto const interval = stripe.interval(confidence);
    return {{"body", body},
            {"level", level},
            {"amplitude", stripe.amplitude},
            {"trials", stripe.trials},
            {limit == overturning_limit ? "overturned" : "exceeded", stripe.overturned},
            {"failed", stripe.failed},
            {"probability", number(stripe.probability())},
            {"lower", interval.lower},
            {"upper", interval.upper},
            {"limit", limit},
            {"undecided", stripe.undecided}};
}

Json criterion_json(std::string const& body, MeasuredCriterion const& criterion) {
    auto const& s = criterion.study;
    return {{"body", body},
            {"measure", fragility_measure_names()[static_cast<std::size_t>(criterion.measure)]},
            {"false_safe", s.counts.false_safe},
            {"false_alarm", s.counts.false_alarm},
            {"true_safe", s.counts.true_safe},
            {"true_overturn", s.counts.true_overturn},
            {"radius_unit", name_of(criterion.radius_unit)},
            {"safe_but_overturned", share_json(s.safe_but_overturned)},
            {"overturned_said_safe", share_json(s.overturned_said_safe)},
            {"unsafe_but_stood", share_json(s.unsafe_but_stood)},
            {"stood_said_unsafe", share_json(s.stood_said_unsafe)},
            {"waves_safe_but_overturned", share_json(s.waves_safe_but_overturned)},
            {"safe_uplifted_but_overturned", share_json(s.safe_uplifted_but_overturned)},
            {"waves_safe_uplifted_but_overturned", share_json(s.waves_safe_uplifted_but_overturned)},
            {"ratio_at_overturning", quantiles_json(s.at_overturning)},
            {"ratio_at_first_overturning", quantiles_json(s.first_overturning)},
            {"ratio_at_highest_standing", quantiles_json(s.highest_standing)}};
}

Json response_json(std::string const& body, ResponseBin const& bin) {
    return {{"body", body},
            {"v_wes_ratio", Json::array({bin.from, number(bin.to)})},
            {"overturned", bin.overturned},
            {"v_resp_ratio_without_slip", quantiles_json(bin.without_slip)},
            {"v_resp_ratio_with_slip", quantiles_json(bin.with_slip)}};
}

Json verdict_json(std::string const& body, CriterionVerdict const& verdict) {
    return {{"body", body}, {"supports", verdict.supports}, {"against", verdict.against}, {"open", verdict.open}};
}

Json telling_json(CampaignSpec const& spec, std::vector<TellingTrial> const& trials) {
    Json list = Json::array();
    for (auto const& t : trials) {
        list.push_back({{"body", spec.bodies[static_cast<std::size_t>(t.body)].name},
                        {"kind", telling_kinds.at(static_cast<std::size_t>(t.kind))},
                        {"trial", t.trial},
                        {"wave", t.wave},
                        {"level", t.level},
                        {"amplitude", t.amplitude},
                        {"verdict", entry_of(t.verdict).name},
                        {"peak_rotation_ratio", number(t.peak_rotation_ratio)},
                        {"peak_slip_m", number(t.peak_slip_m)},
                        {"overturned_at", number(t.overturned_at)}});
    }
    return list;
}

Json quantiles_json(std::string const& body, LevelQuantiles const& at) {
    Json json{{"body", body},         {"quantity", at.quantity},   {"units", at.units},
              {"level", at.level},    {"amplitude", at.amplitude}, {"trials", at.trials},
              {"unknown", at.unknown}};
    static constexpr std::array names{"median", "p84", "p95"};
    for (std::size_t q = 0; q < names.size(); ++q) {
        auto const& quantile = at.quantiles.at(q);
        json[names.at(q)] = {{"value", number(quantile.value)},
                             {"lower", quantile.lower ? Json(*quantile.lower) : Json(nullptr)},
                             {"upper", quantile.upper ? Json(*quantile.upper) : Json(nullptr)}};
    }
    return json;
}

namespace {

// One frequency of a grid: amplitudes in SI, null where none that was tried did it.
Json grid_json(BodySpec const& body, LevelSpec const& levels, GridMap const& map, GridLine const& line) {
    Json json{{"body", body.name},
              {"wave", line.wave},
              {"period_s", line.period_s},
              {"frequency_hz", 1 / line.period_s},
              {"uplift", number(map.value(line.uplift))},
              {"overturning", number(map.value(line.least.front()))},
              {"standing", number(map.value(line.standing))},
              {"undecided", line.undecided},
              {"limits", Json::object()},
              {"ends", Json::array()},
              {"steady_rotation_ratio", Json::array()}};
    for (double const level : map.levels) {
        json["steady_rotation_ratio"].push_back(number(steady_rotation_ratio(levels, level, line.period_s, body.body)));
    }
    for (std::size_t limit = 1; limit < map.limits.size(); ++limit) {
        json["limits"][map.limits[limit]] = number(map.value(line.least.at(limit)));
    }
    for (auto const end : line.ends) {
        json["ends"].push_back(entry_of(end).name);
    }
    return json;
}

Json sigma_json(std::optional<AchievedSigma> const& sigma) {
    if (!sigma) {
        return nullptr;
    }
    Json json{{"waves", sigma->waves},
              {"independent", sigma->independent},
              {"independent_are", sigma->of_events ? "events" : "targets"},
              {"missed_match_tolerance", sigma->missed},
              {"measures", Json::array()}};
    for (auto const& m : sigma->measures) {
        json["measures"].push_back({{"measure", m.name},
                                    {"label", m.label},
                                    {"period_s", m.period_s},
                                    {"stated", m.stated ? Json(*m.stated) : Json(nullptr)},
                                    {"achieved", m.achieved},
                                    {"standard_error", m.error}});
    }
    return json;
}

Json limits_json(CampaignSpec const& spec) {
    Json list = Json::array();
    for (auto const& limit : spec.limits) {
        list.push_back({{"name", limit.name}, {"definition", definition_of(limit, spec.limits)}});
        if (!limit.quantity.name.empty()) {
            list.back()["quantity"] = limit.quantity.name;
            list.back()["units"] = limit.quantity.units;
            list.back()["side"] = limit.rule == LimitState::Rule::above ? "above" : "below";
            list.back()["threshold"] = limit.threshold;
        }
    }
    return list;
}

Json all_stripes_json(CampaignSpec const& spec, Statistics const& statistics, double confidence) {
    Json list = Json::array();
    for (std::size_t limit = 0; limit < spec.limits.size(); ++limit) {
        for (auto const& body : statistics.bodies()) {
            auto const& stripes = body.stripes_of(limit);
            for (std::size_t l = 0; l < stripes.size(); ++l) {
                list.push_back(stripe_json(body.body, l, stripes[l], confidence, spec.limits[limit].name));
                auto& stripe = list.back();
                stripe["measure"] = spec.levels.measure_name();
                stripe["units"] = spec.levels.units();
                if (!body.grid.empty()) {  // no sample of anything
                    stripe["probability"] = stripe["lower"] = stripe["upper"] = nullptr;
                }
                if (limit == 0) {
                    stripe["fell_after_record"] = body.fell_after_record[l];
                    stripe["peaked_after_record"] = body.peaked_after_record[l];
                }
                for (std::size_t v = 0; limit == 0 && v < verdicts().size(); ++v) {
                    stripe["ends"][column_of(verdicts()[v])] = body.ends[v][l];
                }
            }
        }
    }
    return list;
}

Json all_fragility_json(std::vector<BodyAnalysis> const& analysis, double confidence, WarningUnits units) {
    Json list = Json::array();
    for (auto const& body : analysis) {
        for (auto const& measured : body.fragility) {
            list.push_back(fragility_json(body.body, measured, confidence, units));
        }
    }
    for (auto const& body : analysis) {
        for (auto const& limit : body.limits) {
            for (auto const& measured : limit.fragility) {
                list.push_back(fragility_json(body.body, measured, confidence, units));
            }
        }
    }
    return list;
}

}  // namespace

Json fit_json(CampaignSpec const& spec, Statistics const& statistics, std::vector<BodyAnalysis> const& analysis,
              double confidence, WarningUnits units) {
    Json json{{"variability", spec.source->variability()},
              {"sigma", sigma_json(statistics.achieved_sigma())},
              {"waves_alike", spec.source->waves_alike()},
              {"limits", limits_json(spec)},
              {"stripes", all_stripes_json(spec, statistics, confidence)},
              {"fragility", all_fragility_json(analysis, confidence, units)},
              {"together", together_json(spec, bodies_together(spec, statistics), confidence)},
              {"grid", Json::array()},
              {"quantiles", Json::array()},
              {"criterion", Json::array()},
              {"response", Json::array()},
              {"verdict", Json::array()},
              {"assumptions", assumptions_json(spec)}};
    for (std::size_t b = 0; b < analysis.size(); ++b) {
        auto const& body = analysis[b];
        for (std::size_t line = 0; body.grid && line < body.grid->lines.size(); ++line) {
            json["grid"].push_back(grid_json(spec.bodies[b], spec.levels, *body.grid, body.grid->lines[line]));
        }
        for (auto const& at : body.quantiles) {
            json["quantiles"].push_back(quantiles_json(body.body, at));
        }
        for (auto const& criterion : body.criterion) {
            json["criterion"].push_back(criterion_json(body.body, criterion));
        }
        for (auto const& bin : body.response) {
            json["response"].push_back(response_json(body.body, bin));
        }
        json["verdict"].push_back(verdict_json(body.body, body.verdict));
    }
    return json;
}

}  // namespace overturn::cli
