#include "cli/rare_json.hpp"

#include <nlohmann/json.hpp>

namespace overturn::cli {

nlohmann::ordered_json rare_json(CampaignSpec const& spec, std::span<RareBody const> bodies) {
    using Json = nlohmann::ordered_json;
    Json list = Json::array();
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        for (auto const& e : bodies[b].estimates) {
            list.push_back({{"body", spec.bodies[b].name},
                            {"amplitude", e.factor},
                            {"probability", e.probability ? Json(*e.probability) : Json(nullptr)},
                            {"interval_95", Json::array({e.interval_95.lower, e.interval_95.upper})},
                            {"method", name_of(e.method)},
                            {"state", name_of(e.state)},
                            {"reason", e.reason.empty() ? Json(nullptr) : Json(e.reason)},
                            {"runs", e.runs},
                            {"crude_runs", e.probability ? Json(e.crude_runs) : Json(nullptr)}});
        }
    }
    return list;
}

}  // namespace overturn::cli
