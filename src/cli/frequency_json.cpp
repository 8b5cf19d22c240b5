#include "cli/frequency_json.hpp"

#include <nlohmann/json.hpp>

#include "cli/json_values.hpp"

namespace overturn::cli {

nlohmann::ordered_json frequency_json(std::vector<BodyFrequency> const& frequencies, HazardCurve const& hazard) {
    Json list = Json::array();
    for (auto const& f : frequencies) {
        Json one{{"body", f.body},          {"limit", f.limit},
                 {"mean", nullptr},         {"interval", nullptr},
                 {"fractiles", nullptr},    {"stripes_alone", Json::array({f.seen.lower, f.seen.upper})},
                 {"parts", Json::array()},  {"shares", nullptr},
                 {"beyond_curve", nullptr}, {"hazard_points", hazard.points().size()}};
        if (f.mean) {
            one["mean"] = f.mean->annual + f.mean->beyond_least;
            one["interval"] = Json::array({f.interval.lower, f.interval.upper});
            one["poor_fit"] = f.poor;
            for (auto const& part : f.mean->parts) {
                one["parts"].push_back({{"from", part.from}, {"to", part.to}, {"annual", part.annual}});
            }
            one["beyond_curve"] = Json::array({f.mean->beyond_least, f.mean->beyond_most});
        }
        if (f.fractiles) {
            one["fractiles"] = {{"5", f.fractiles->low}, {"50", f.fractiles->median}, {"95", f.fractiles->high}};
        }
        if (f.shares) {
            one["shares"] = {
                {"below_levels", f.shares->below}, {"within", f.shares->between}, {"above_levels", f.shares->above}};
        }
        list.push_back(std::move(one));
    }
    return list;
}

}  // namespace overturn::cli
