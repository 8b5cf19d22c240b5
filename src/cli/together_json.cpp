#include "cli/together_json.hpp"

#include "cli/json_values.hpp"

namespace overturn::cli {
namespace {

Json phi_json(std::optional<double> const& phi) { return phi ? Json(*phi) : Json(nullptr); }

Json estimate_json(Estimate const& estimate) {
    return {{"value", estimate.value}, {"interval", ends(estimate.interval)}};
}

}  // namespace

Json together_json(CampaignSpec const& spec, std::vector<BodiesTogether> const& together, double confidence) {
    Json list = Json::array();
    for (auto const& of : together) {
        Json json{{"limit", of.limit}, {"any", Json::array()}, {"pairs", Json::array()}};
        for (std::size_t l = 0; l < of.joint.any.size(); ++l) {
            auto const& any = of.joint.any[l];
            auto const interval = any.interval(confidence);
            json["any"].push_back({{"amplitude", any.amplitude},
                                   {"waves", any.trials},
                                   {of.passing == Passing::exceeded ? "exceeded" : "overturned", any.overturned},
                                   {"undecided", any.undecided},
                                   {"probability", number(any.probability())},
                                   {"lower", interval.lower},
                                   {"upper", interval.upper},
                                   {"if_independent", number(of.joint.if_independent[l])}});
        }
        for (auto const& pair : of.joint.pairs) {
            Json phis = Json::array();
            for (auto const& phi : pair.phi) {
                phis.push_back(phi_json(phi));
            }
            json["pairs"].push_back({{"bodies", {spec.bodies[pair.first].name, spec.bodies[pair.second].name}},
                                     {"phi", phis},
                                     {"phi_pooled", phi_json(pair.pooled)}});
        }
        list.push_back(std::move(json));
    }
    return list;
}

Json hand_check_json(CampaignSpec const& spec, std::vector<HandCheck> const& checks) {
    Json list = Json::array();
    for (std::size_t b = 0; b < checks.size(); ++b) {
        auto const& check = checks[b];
        list.push_back({{"body", check.body},
                        {"method", "reserve energy, as ASCE/SEI 43-05 Appendix A (from recollection)"},
                        {"waves", check.waves},
                        {"left_out", check.left_out},
                        {"demand_fractile", 0.84},
                        {"overturning_level", check.overturning_level},
                        {"rotation_ratio", check.rocking.rotation_rad / spec.bodies[b].body.alpha_rad()},
                        {"frequency_hz", check.rocking.frequency_hz},
                        {"damping", check.rocking.damping},
                        {"sliding_m", check.sliding_m ? Json(*check.sliding_m) : Json(nullptr)}});
    }
    return list;
}

Json two_measures_json(std::vector<TwoMeasures> const& fits, double confidence) {
    Json list = Json::array();
    for (auto const& of : fits) {
        Json json{{"body", of.body},
                  {"limit", of.limit},
                  {"measures", of.names},
                  {"identifiable", of.fit.has_value()},
                  {"confidence", confidence}};
        if (of.fit) {
            json["constant"] = estimate_json(of.fit->constant);
            json["slopes"] = Json::array({estimate_json(of.fit->slopes[0]), estimate_json(of.fit->slopes[1])});
            json["beta"] = estimate_json(of.fit->beta);
            json["better_alone"] = of.names.at(of.fit->better);
            json["deviance_gain"] = of.fit->deviance_gain;
            json["trials"] = of.fit->trials;
            json["waves"] = of.fit->waves;
        }
        list.push_back(std::move(json));
    }
    return list;
}

}  // namespace overturn::cli
