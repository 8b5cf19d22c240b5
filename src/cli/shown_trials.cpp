#include "cli/shown_trials.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "campaign/trial.hpp"
#include "response/registry.hpp"

namespace overturn::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_bodies = 12;
constexpr std::size_t most_instants = 1500;

/// Keeps all instants of a trial.
class Kept : public Observer {
  public:
    void begin(std::span<Channel const> channels) override {
        for (auto const& channel : channels) {
            keys.emplace_back(channel.key);
        }
        columns.resize(keys.size());
    }
    void at(std::span<double const> values) override {
        for (std::size_t i = 0; i < values.size(); ++i) {
            columns[i].push_back(values[i]);
        }
    }

    std::vector<std::string> keys;
    std::vector<std::vector<double>> columns;
};

// Every so many instants: of what is drawn over time the value that is farthest from zero, so that no peak is lost; of
// a pose its parts at one instant.
Json thinned(std::vector<double> const& values, bool of_a_pose) {
    auto const each = (values.size() + most_instants - 1) / most_instants;
    auto kept = Json::array();
    for (std::size_t begin = 0; begin < values.size(); begin += each) {
        double farthest = values[begin];
        for (std::size_t i = begin; !of_a_pose && i < std::min(begin + each, values.size()); ++i) {
            farthest = std::abs(values[i]) > std::abs(farthest) ? values[i] : farthest;
        }
        kept.push_back(farthest);
    }
    return kept;
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
            for (int i = 0; i < base.points; ++i) {
                double const angle = 2 * pi * i / base.points;
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

// The highest peak that stood on compliant points, of each body.
std::vector<std::optional<std::int64_t>> nearest_misses(CampaignSpec const& spec, Plan const& plan,
                                                        store::ResultsReader const& file) {
    std::vector<std::optional<std::int64_t>> nearest(spec.bodies.size());
    std::vector<double> highest(spec.bodies.size(), 0);
    auto const ends = file.integers("trials/verdict");
    auto const peaks = file.reals("trials/peak_rotation_ratio");
    auto const effects = file.integers("trials/effects");
    for (std::size_t t = 0; t < ends.size(); ++t) {
        auto const& end = entry_of(static_cast<Verdict>(ends[t]));
        auto const body = static_cast<std::size_t>(plan.trial(static_cast<std::int64_t>(t)).body);
        bool const on_points = has(static_cast<EffectMask>(effects[t]), Effect::contact);
        if (on_points && end.moved && end.decided && !end.fell && peaks[t] > highest[body]) {
            highest[body] = peaks[t];
            nearest[body] = static_cast<std::int64_t>(t);
        }
    }
    return nearest;
}

}  // namespace

Json shown_trials(CampaignSpec const& spec, Plan const& plan, store::ResultsReader const& file) {
    auto shown = Json::array();
    auto const nearest = nearest_misses(spec, plan, file);
    for (std::size_t b = 0; b < nearest.size() && shown.size() < most_bodies; ++b) {
        if (!nearest[b]) {
            continue;
        }
        auto const [wave, body, level] = plan.trial(*nearest[b]);
        PhaseSeconds ignored;
        Kept kept;
        auto const trial = run_trial(spec, prepare_wave(spec, plan, wave, ignored), body, level, &kept);
        auto const& row = trial.rows.front();
        auto channels = Json::object();
        for (std::size_t i = 0; i < kept.keys.size(); ++i) {
            auto const& key = kept.keys[i];
            bool const of_a_pose = key == "time_s" || key == "x_m" || key == "y_m" || key == "yaw_rad";
            channels[key] = thinned(kept.columns[i], of_a_pose);
        }
        shown.push_back({{"body", spec.bodies[b].name},
                         {"title", fmt::format("{}, trial {}: wave {} at {}, {}", spec.bodies[b].name, *nearest[b],
                                               wave, spec.levels.text(row.amplitude), entry_of(row.verdict).name)},
                         {"alpha", spec.bodies[b].body.alpha_rad()},
                         {"outline", outline_of(spec.bodies[b])},
                         {"channels", std::move(channels)}});
    }
    return shown;
}

}  // namespace overturn::cli
