#include "cli/rare_waves_json.hpp"

#include <span>
#include <vector>

#include <nlohmann/json.hpp>

#include "cli/json_values.hpp"

namespace overturn::cli {

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
