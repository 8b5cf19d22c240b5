#include "cli/fit_json.hpp"

#include <cmath>

#include <nlohmann/json.hpp>

#include "core/error.hpp"

namespace overturn::cli {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
Json ends(Interval const& interval) { return Json::array({number(interval.lower), number(interval.upper)}); }
// An intensity's lower end 0 says that nothing bounds it from below.
Json intensity_ends(Interval const& interval) {
    return Json::array({interval.lower > 0 ? number(interval.lower) : Json(nullptr), number(interval.upper)});
}
Json or_null(bool known, Json value) { return known ? std::move(value) : Json(nullptr); }

Json intervals_json(FragilityFit::Intervals const& i) {
    return {{"median_interval", intensity_ends(i.median)},
            {"beta_interval", ends(i.beta)},
            {"hclpf_interval", intensity_ends(i.hclpf)}};
}

Json isotonic_json(FragilityFit const& fit) {
    Json list = Json::array();
    for (auto const& block : fit.isotonic) {
        list.push_back({{"from", block.from},
                        {"to", block.to},
                        {"trials", block.trials},
                        {"overturned", block.overturned},
                        {"probability", block.probability()}});
    }
    return list;
}

char const* source_name(QuotedProbability::Source source) {
    switch (source) {
        case QuotedProbability::Source::curve:
            return "curve";
        case QuotedProbability::Source::stripe:
            return "stripe";
        case QuotedProbability::Source::none:
            break;
    }
    return "none";
}

Json quotes_json(MeasuredFragility const& measured) {
    Json list = Json::array();
    for (auto const& q : measured.fit.quotes) {
        bool const bounded = q.source != QuotedProbability::Source::none;
        list.push_back({{"of", measured.quote_base},
                        {"multiple", q.quote.multiple},
                        {"amplitude", q.quote.intensity},
                        {"probability", q.probability ? Json(*q.probability) : Json(nullptr)},
                        {"curve_probability", q.curve ? Json(*q.curve) : Json(nullptr)},
                        {"lower", or_null(bounded, q.bounds.lower)},
                        {"upper", or_null(bounded, q.bounds.upper)},
                        {"bounds_from", source_name(q.source)},
                        {"trials", q.trials},
                        {"overturned", q.overturned},
                        {"observed", or_null(q.trials > 0, q.trials > 0 ? q.overturned / q.trials : 0)},
                        {"observed_interval", or_null(q.trials > 0, ends(q.seen))},
                        {"outside_data", q.outside_data},
                        {"in_tail", q.in_tail}});
    }
    return list;
}

Json bound_json(FragilityFit const& fit) {
    if (!fit.bound) {
        return nullptr;
    }
    bool const none = fit.state == FragilityState::none_overturned;
    return {{"from", fit.bound->from},
            {"to", fit.bound->to},
            {"units", fit.bound->units},
            {"lower", or_null(!none, fit.bound->probability.lower)},
            {"upper", or_null(none, fit.bound->probability.upper)}};
}

Json goodness_json(FragilityFit const& fit) {
    if (!fit.goodness) {
        return nullptr;
    }
    return {{"deviance", fit.goodness->deviance},
            {"degrees_of_freedom", fit.goodness->degrees_of_freedom},
            {"p_value", or_null(fit.goodness->degrees_of_freedom > 0, fit.goodness->p_value)}};
}

Json line_json(std::optional<ProbitLine> const& line) {
    return line ? Json{{"median", std::exp(line->log_median())}, {"beta", line->beta()}} : Json(nullptr);
}

void add_curve(Json& json, FragilityFit const& fit) {
    bool const known = fit.identifiable();
    json["median"] = or_null(known, known ? std::exp(fit.line->log_median()) : 0);
    json["beta"] = or_null(known, known ? fit.line->beta() : 0);
    json["median_interval"] = or_null(known, known ? intensity_ends(fit.intervals().median) : Json());
    json["beta_interval"] = or_null(known, known ? ends(fit.intervals().beta) : Json());
    json["hclpf"] = or_null(known, known ? fit.hclpf() : 0);
    json["hclpf_interval"] = or_null(known, known ? intensity_ends(fit.intervals().hclpf) : Json());
    json["one_percent_point"] = or_null(known, known ? fit.one_percent_point() : 0);
    json["flags"] = names_of(fit.flags);
    json["state"] = name_of(fit.state);
    json["interval_method"] = or_null(
        known, fit.method == FragilityFit::Method::bootstrap_by_waves ? "bootstrap-by-waves" : "profile-likelihood");
    json["beta_r"] = or_null(known, known ? fit.beta_r() : 0);
    json["beta_u"] = fit.beta_u;
    json["profile"] = fit.profile ? intervals_json(*fit.profile) : Json(nullptr);
    json["bootstrap"] = fit.bootstrap ? intervals_json(*fit.bootstrap) : Json(nullptr);
    if (fit.bootstrap) {
        json["bootstrap"]["replicates"] = fit.replicates;
        json["bootstrap"]["without_curve"] = fit.replicates_without_curve;
    }
}

Json share_json(Share const& share) {
    bool const any = share.of > 0;
    return {{"count", share.count},
            {"of", share.of},
            {"share", or_null(any, any ? share.value() : 0)},
            {"lower", or_null(any, share.interval.lower)},
            {"upper", or_null(any, share.interval.upper)}};
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

Json stripe_json(std::string const& body, std::size_t level, Stripe const& stripe, double confidence) {
    auto const interval = stripe.interval(confidence);
    return {{"body", body},
            {"level", level},
            {"amplitude", stripe.amplitude},
            {"trials", stripe.trials},
            {"overturned", stripe.overturned},
            {"failed", stripe.failed},
            {"probability", number(stripe.probability())},
            {"lower", interval.lower},
            {"upper", interval.upper}};
}

Json fragility_json(std::string const& body, MeasuredFragility const& measured, double confidence) {
    auto const& fit = measured.fit;
    Json json{{"body", body}, {"measure", measured.name}, {"identifiable", fit.identifiable()}};
    add_curve(json, fit);
    json["units"] = measured.units;
    json["confidence"] = confidence;
    json["trials"] = fit.trials;
    json["overturned"] = fit.overturned;
    json["undecided"] = fit.undecided;
    json["waves"] = or_null(fit.waves > 0, fit.waves);
    json["data_range"] = or_null(fit.trials > 0, Json::array({fit.lowest, fit.highest}));
    json["lowest_proportion"] = or_null(fit.lowest_proportion > 0, fit.lowest_proportion);
    json["goodness_of_fit"] = goodness_json(fit);
    json["monotone_p_value"] = or_null(fit.monotone.degrees_of_freedom > 0, fit.monotone.p_value);
    json["isotonic"] = isotonic_json(fit);
    json["isotonic_median"] = or_null(fit.trials > 0, intensity_ends(fit.isotonic_median));
    json["penalised"] = line_json(fit.penalised);
    json["bound"] = bound_json(fit);
    json["probabilities"] = quotes_json(measured);
    json["rank_area"] = number(measured.rank_area);
    json["rank_interval"] = or_null(std::isfinite(measured.rank_area), ends(measured.rank_interval));
    json["drawn"] = Json::array();
    for (std::size_t k = 0; measured.split && k < measured.split->per_score.size(); ++k) {
        json["drawn"].push_back({{"quantity", measured.drawn.at(k)},
                                 {"log_median_per_deviation", measured.split->per_score[k]},
                                 {"standard_error", measured.split->per_score_error[k]}});
    }
    json["band"] = Json::array();
    for (auto const& at : fit.band) {
        json["band"].push_back({{"amplitude", at.intensity},
                                {"probability", at.probability},
                                {"lower", at.bounds.lower},
                                {"upper", at.bounds.upper}});
    }
    json["warnings"] = warnings_of(fit, measured.units, confidence);
    return json;
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

Json fit_json(Statistics const& statistics, std::vector<BodyAnalysis> const& analysis, double confidence) {
    Json json{{"stripes", Json::array()},
              {"fragility", Json::array()},
              {"criterion", Json::array()},
              {"response", Json::array()},
              {"verdict", Json::array()}};
    for (auto const& body : statistics.bodies()) {
        for (std::size_t l = 0; l < body.stripes.size(); ++l) {
            json["stripes"].push_back(stripe_json(body.body, l, body.stripes[l], confidence));
        }
    }
    for (auto const& body : analysis) {
        for (auto const& measured : body.fragility) {
            json["fragility"].push_back(fragility_json(body.body, measured, confidence));
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
