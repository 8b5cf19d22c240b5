#include "cli/trial_history.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include <nlohmann/json.hpp>

#include "body/response_velocity.hpp"
#include "campaign/rocking_band.hpp"
#include "campaign/site_path.hpp"
#include "cli/json_values.hpp"
#include "core/error.hpp"
#include "core/units.hpp"
#include "report/figure.hpp"
#include "spectra/band_rule.hpp"
#include "spectra/window_energy.hpp"

namespace overturn::cli {
namespace {

// Of every so many instants one: of what is drawn over time the value that is farthest from zero, so that no peak is
// lost; of a pose, and of time, the first, so that its parts are of one instant.
enum class Kept { first, farthest };

Json thinned(std::span<double const> values, std::size_t most, Kept kept, double factor = 1) {
    auto const each = std::max<std::size_t>(1, (values.size() + most - 1) / most);
    auto list = Json::array();
    for (std::size_t begin = 0; begin < values.size(); begin += each) {
        auto const some = values.subspan(begin, std::min(each, values.size() - begin));
        auto const farthest =
            std::ranges::max_element(some, {}, [](double value) { return std::isnan(value) ? -1 : std::abs(value); });
        list.push_back(factor * (kept == Kept::first ? some.front() : *farthest));
    }
    return list;
}

Json series(std::span<double const> values, double step_s, double factor, std::size_t most) {
    std::vector<double> times(values.size());
    for (std::size_t i = 0; i < times.size(); ++i) {
        times[i] = static_cast<double>(i) * step_s;
    }
    return {{"time_s", thinned(times, most, Kept::first)}, {"values", thinned(values, most, Kept::farthest, factor)}};
}

Json outline_of(BodySpec const& body) {
    auto outline = Json::array();
    double const b = body.body.half_width_m();
    auto const& base = body.footing.base;
    switch (base.shape) {
        case BaseShape::square:
            for (auto const& [x, y] : {std::pair{b, b}, {-b, b}, {-b, -b}, {b, -b}}) {
                outline.push_back({x, y});
            }
            break;
        case BaseShape::round:
            for (int i = 0, count = base.continuous() ? BasePlan::points_around : base.points; i < count; ++i) {
                double const angle = 2 * pi * i / count;
                outline.push_back({b * std::cos(angle), b * std::sin(angle)});
            }
            break;
        case BaseShape::polygon:
            for (auto const& [x, y] : base.corners_m) {
                outline.push_back({x, y});
            }
            break;
    }
    return outline;
}

// At an impact on rigid ground the contact force is a blow, for which both its sides have 0: not known.
std::vector<double> without_blows(KeptHistory const& history, std::size_t force) {
    auto values = history.columns()[force];
    auto const column = [&](std::string_view key) {
        return static_cast<std::size_t>(std::ranges::find(history.keys(), key) - history.keys().begin());
    };
    auto const rotation = column("rotation_rad");
    if (rotation == history.keys().size() || column("crush_m") < history.keys().size()) {
        return values;  // on points it is a force at every instant
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (values[i] == 0 && history.columns()[rotation][i] == 0) {
            values[i] = std::numeric_limits<double>::quiet_NaN();
        }
    }
    return values;
}

Json channels_of(KeptHistory const& history, RigidBody const& body, std::size_t most) {
    auto channels = Json::object();
    for (std::size_t i = 0; i < history.keys().size(); ++i) {
        auto const& key = history.keys()[i];
        if (SitePath::adds(key) || key.starts_with("edge_") || key.starts_with("top_")) {
            continue;  // not drawn
        }
        auto const& values = history.columns()[i];
        bool const of_a_pose = key == "time_s" || key == "x_m" || key == "y_m" || key == "yaw_rad";
        bool const force = key == "contact_force_over_weight";
        channels[key] =
            thinned(force ? without_blows(history, i) : values, most, of_a_pose ? Kept::first : Kept::farthest);
        if (key == "rotation_rad" || key == "tilt_rad") {
            std::vector<double> v_resp;
            v_resp.reserve(values.size());
            for (double const tilt : values) {
                v_resp.push_back(response_velocity(body, tilt));
            }
            channels["v_resp_mps"] = thinned(v_resp, most, Kept::farthest);
        }
    }
    return channels;
}

Json wave_of(GroundMotion const& motion, double scale, std::size_t most) {
    auto components = Json::array();
    for (auto const& [name, values] : {std::pair{"horizontal", &motion.horizontal_mps2},
                                       {"transverse", &motion.transverse_mps2},
                                       {"vertical", &motion.vertical_mps2}}) {
        if (!values->empty()) {
            components.push_back(series(*values, motion.time_step_s, scale, most));
            components.back()["name"] = name;
        }
    }
    return components;
}

}  // namespace

void KeptHistory::begin(std::span<Channel const> channels) {
    for (auto const& channel : channels) {
        keys_.emplace_back(channel.key);
    }
    columns_.resize(keys_.size());
    if (next_ != nullptr) {
        next_->begin(channels);
    }
}

void KeptHistory::at(std::span<double const> values) {
    for (std::size_t i = 0; i < values.size(); ++i) {
        columns_[i].push_back(values[i]);
    }
    if (next_ != nullptr) {
        next_->at(values);
    }
}

Json history_data(KeptHistory const& history, HistoryOf const& of, std::size_t most) {
    OVERTURN_EXPECT(!history.empty());
    Json data{{"title", of.title},
              {"alpha", of.body.alpha_rad()},
              {"v_ereq_mps", of.body.limit_velocity_mps()},
              {"outline", outline_of(of.spec)},
              {"channels", channels_of(history, of.body, most)},
              {"wave", wave_of(of.motion, of.scale, most)}};
    if (of.measures != nullptr) {
        auto const band = rocking_band(of.body, of.measures->radius_unit);
        auto const energy = window_energy(of.motion.horizontal_mps2, of.motion.time_step_s, band,
                                          {.reading = of.measures->window,
                                           .smoothed = true,
                                           .keep_history = true,
                                           .panel_phase_rad = of.measures->panel_phase_rad});
        data["v_wes"] = series(energy.v_wes_mps, of.motion.time_step_s, std::abs(of.scale), most);
    }
    return data;
}

void draw_history(KeptHistory const& history, HistoryOf const& of, nlohmann::ordered_json const& units,
                  std::string const& output) {
    validate(!history.empty(), "{}: nothing to draw (no model ran {}). Choose another trial", output, of.title);
    auto data = history_data(history, of, for_a_file);
    data["units"] = units;
    report::draw_figure("history_figure.py", data, output);
}

}  // namespace overturn::cli
