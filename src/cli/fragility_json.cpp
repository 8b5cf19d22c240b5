#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "cli/fit_json.hpp"
#include "cli/json_values.hpp"

namespace overturn::cli {
namespace {

// The contract's name of the count, and that of other limit states.
char const* passed_key(FragilityFit const& fit) { return fit.passing == Passing::exceeded ? "exceeded" : "overturned"; }

Json intervals_json(FragilityFit::Intervals const& i) {
    return {{"median_interval", intensity_ends(i.median)},
            {"beta_interval", ends(i.beta)},
            {"five_percent_point_interval", intensity_ends(i.five_percent_point)},
            {"hclpf_interval", i.hclpf ? intensity_ends(*i.hclpf) : Json(nullptr)}};
}

Json isotonic_json(FragilityFit const& fit) {
    Json list = Json::array();
    for (auto const& block : fit.isotonic) {
        list.push_back({{"from", block.from},
                        {"to", block.to},
                        {"trials", block.trials},
                        {passed_key(fit), block.overturned},
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
        case QuotedProbability::Source::neighbours:
            return "neighbours";
        case QuotedProbability::Source::none:
            break;
    }
    return "none";
}

// Why there is a bound in place of a probability.
Json seen_json(QuotedProbability const& q, FragilityFit const& fit) {
    if (!q.bound) {
        return nullptr;
    }
    auto const why = fmt::format("P is below {:.2g}, a tenth of one in the trials there or next above", q.least);
    return {{"from", q.bound->from},   {"to", q.bound->to},
            {"units", q.bound->units}, {passed_key(fit), q.bound->overturned},
            {"upper", q.bounds.upper}, {"reason", why}};
}

Json neighbours_json(QuotedProbability const& q, FragilityFit const& fit) {
    if (!q.neighbours) {
        return nullptr;
    }
    auto const stripe = [&](SeenBound const& seen) -> Json {
        if (seen.units == 0) {  // none were tried on that side
            return nullptr;
        }
        return {{"amplitude", seen.from},
                {"to", seen.to},
                {"trials", seen.units},
                {passed_key(fit), seen.overturned},
                {"observed_interval", ends(seen.probability)}};
    };
    return {{"below", stripe(q.neighbours->below)}, {"above", stripe(q.neighbours->above)}};
}

// Several stripes together, if P does not fall: at most `upper` at `from`, at least `lower` at `to`.
Json pooled_json(std::optional<SeenBound> const& pooled, FragilityFit const& fit) {
    if (!pooled) {
        return nullptr;
    }
    return {{"from", pooled->from},
            {"to", pooled->to},
            {"trials", pooled->units},
            {passed_key(fit), pooled->overturned},
            {"lower", pooled->probability.lower},
            {"upper", pooled->probability.upper}};
}

Json quotes_json(MeasuredFragility const& measured) {
    Json list = Json::array();
    for (auto const& q : measured.fit.quotes) {
        bool const bounded = q.source != QuotedProbability::Source::none;
        list.push_back({{"of", measured.quote_base},
                        {"multiple", q.quote.multiple},
                        {"amplitude", q.quote.intensity},
                        {"probability", q.probability ? Json(*q.probability) : Json(nullptr)},
                        {"curve_probability", q.curve && !q.bound ? Json(*q.curve) : Json(nullptr)},
                        {"lower", or_null(bounded, q.bounds.lower)},
                        {"upper", or_null(bounded, q.bounds.upper)},
                        {"bounds_from", source_name(q.source)},
                        {"trials", q.trials},
                        {passed_key(measured.fit), q.overturned},
                        {"observed", or_null(q.trials > 0, q.trials > 0 ? q.overturned / q.trials : 0)},
                        {"observed_interval", or_null(q.trials > 0, ends(q.seen))},
                        {"pooled", pooled_json(q.pooled, measured.fit)},
                        {"neighbours", neighbours_json(q, measured.fit)},
                        {"outside_data", q.outside_data},
                        {"in_tail", q.in_tail},
                        {"bound", seen_json(q, measured.fit)}});
    }
    return list;
}

Json bound_json(FragilityFit const& fit) {
    if (!fit.bound) {
        return nullptr;
    }
    bool const none = fit.state == FragilityState::none_overturned;
    bool const all = fit.state == FragilityState::all_overturned;
    return {{"from", fit.bound->from},
            {"to", fit.bound->to},
            {"units", fit.bound->units},
            {"lower", or_null(!none, fit.bound->probability.lower)},
            {"upper", or_null(!all, fit.bound->probability.upper)}};
}

Json goodness_json(FragilityFit const& fit) {
    if (!fit.goodness) {
        return nullptr;
    }
    return {{"deviance", fit.goodness->deviance},
            {"degrees_of_freedom", fit.goodness->degrees_of_freedom},
            {"p_value", or_null(fit.goodness->degrees_of_freedom > 0, fit.goodness->p_value)},
            {"stripe_p_value", fit.goodness->stripe_p_value}};
}

Json line_json(std::optional<ProbitLine> const& line) {
    return line ? Json{{"median", std::exp(line->log_median())}, {"beta", line->beta()}} : Json(nullptr);
}

Json number_or_null(std::optional<double> const& value) { return value ? Json(*value) : Json(nullptr); }

Json confidence_curves_json(FragilityFit const& fit) {
    Json list = Json::array();
    for (double const confidence : told_confidences) {
        if (fit.identifiable() && fit.beta_u_known) {
            list.push_back(
                {{"confidence", confidence}, {"median", *fit.median_at(confidence)}, {"beta", fit.beta_r()}});
        }
    }
    return list;
}

void add_low_points(Json& json, FragilityFit const& fit) {
    bool const five = fit.identifiable() && fit.five_percent_point();
    bool const known = fit.identifiable() && fit.hclpf();
    json["five_percent_point"] = five ? number_or_null(fit.five_percent_point()) : Json(nullptr);
    json["five_percent_point_interval"] = five ? intensity_ends(fit.intervals().five_percent_point) : Json(nullptr);
    json["hclpf"] = known ? number_or_null(fit.hclpf()) : Json(nullptr);
    json["hclpf_interval"] = known && fit.intervals().hclpf ? intensity_ends(*fit.intervals().hclpf) : Json(nullptr);
    json["one_percent_point"] = known ? number_or_null(fit.one_percent_point()) : Json(nullptr);
    json["confidence_curves"] = confidence_curves_json(fit);
}

void add_curve(Json& json, FragilityFit const& fit) {
    bool const known = fit.identifiable();
    json["median"] = or_null(known, known ? std::exp(fit.line->log_median()) : 0);
    json["beta"] = or_null(known, known ? fit.line->beta() : 0);
    json["median_interval"] = or_null(known, known ? intensity_ends(fit.intervals().median) : Json());
    json["beta_interval"] = or_null(known, known ? ends(fit.intervals().beta) : Json());
    add_low_points(json, fit);
    json["flags"] = names_of(fit.flags, fit.passing);
    json["state"] = name_of(fit.state, fit.passing);
    json["interval_method"] = or_null(
        known, fit.method == FragilityFit::Method::bootstrap_by_waves ? "bootstrap-by-waves" : "profile-likelihood");
    json["beta_r"] = or_null(known, known ? fit.beta_r() : 0);
    json["beta_u"] = fit.beta_u;
    json["beta_u_drawn"] = fit.beta_u_drawn;
    json["profile"] = fit.profile ? intervals_json(*fit.profile) : Json(nullptr);
    json["bootstrap"] = fit.bootstrap ? intervals_json(*fit.bootstrap) : Json(nullptr);
    if (fit.bootstrap) {
        json["bootstrap"]["replicates"] = fit.replicates;
        json["bootstrap"]["without_curve"] = fit.replicates_without_curve;
    }
}

}  // namespace

Json fragility_json(std::string const& body, MeasuredFragility const& measured, double confidence, WarningUnits units) {
    auto const& fit = measured.fit;
    Json json{{"body", body},
              {"limit", measured.limit},
              {"measure", measured.name},
              {"label", measured.label},
              {"depends_on_levels", !measured.of_levels},
              {"identifiable", fit.identifiable()}};
    add_curve(json, fit);
    json["units"] = measured.units;
    json["confidence"] = confidence;
    json["trials"] = fit.trials;
    json[passed_key(fit)] = fit.overturned;
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
    json["pooled"] = pooled_json(fit.pooled, fit);
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
    json["warnings"] =
        warnings_of(fit, units == WarningUnits::si ? IntensityUnit{measured.units} : measured.told, confidence);
    return json;
}

}  // namespace overturn::cli
