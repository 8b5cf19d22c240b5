#include "cli/rare_json.hpp"

#include <cmath>
#include <span>
#include <vector>

#include <nlohmann/json.hpp>

#include "cli/json_values.hpp"

namespace overturn::cli {

nlohmann::ordered_json rare_json(CampaignSpec const& spec, std::span<RareBody const> bodies) {
    Json list = Json::array();
    for (auto const& body : bodies) {
        for (auto const& e : body.estimates) {
            Json health = Json::array();
            for (auto const& check : e.health) {
                health.push_back({{"check", check.name},
                                  {"value", std::isfinite(check.value) ? Json(check.value) : Json(nullptr)},
                                  {"limit", check.limit},
                                  {"passed", check.passed}});
            }
            list.push_back({{"body", spec.bodies[body.body].name},
                            {"limit", spec.limits[body.limit].name},
                            {"amplitude", e.factor},
                            {"probability", e.probability ? Json(*e.probability) : Json(nullptr)},
                            {"interval_95", Json::array({e.interval_95.lower, e.interval_95.upper})},
                            {"method", name_of(e.method)},
                            {"state", name_of(e.state)},
                            {"reason", e.reason.empty() ? Json(nullptr) : Json(e.reason)},
                            {"runs", e.runs},
                            {"crude_runs", e.probability ? Json(e.crude_runs) : Json(nullptr)},
                            {"cov", e.probability ? Json(e.cov) : Json(nullptr)},
                            {"tried", e.tried},
                            {"replicates", e.probability ? Json(e.replicates) : Json::array()},
                            {"health", std::move(health)}});
        }
    }
    return list;
}

namespace {

Json thinned(std::span<double const> values) {
    constexpr std::size_t most = 3000;
    auto list = Json::array();
    for (std::size_t i = 0, every = 1 + values.size() / most; i < values.size(); i += every) {
        list.push_back(values[i]);
    }
    return list;
}

Json history_json(GroundMotion const& motion) {
    std::vector<double> time(motion.samples());
    for (std::size_t i = 0; i < time.size(); ++i) {
        time[i] = motion.time_step_s * static_cast<double>(i);
    }
    return {{"time_s", thinned(time)}, {"acceleration_mps2", thinned(motion.horizontal_mps2)}};
}

}  // namespace

Json rare_waves_json(RareWaves const& waves) {
    Json json{{"pulses", Json::array()}, {"failing", nullptr}};
    for (auto const& pulse : waves.pulses) {
        auto one = history_json(pulse.motion);
        one["share"] = pulse.share;
        one["factor"] = pulse.factor;
        json["pulses"].push_back(std::move(one));
    }
    if (waves.failing) {
        auto one = history_json(waves.failing->motion);
        one["row"] = waves.failing->row;
        one["factor"] = waves.failing->factor;
        one["tilt_time_s"] = thinned(waves.failing->tilt_time_s);
        one["tilt_rad"] = thinned(waves.failing->tilt_rad);
        json["failing"] = std::move(one);
    }
    return json;
}

}  // namespace overturn::cli
