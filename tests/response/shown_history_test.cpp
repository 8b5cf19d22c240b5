// Requirement R-607: the history of a trial, of every model: where it ends, and the place of base and top.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "response/model_selector.hpp"

namespace overturn {
namespace {

RigidBody const body({.mass_kg = 1000,
                      .half_width_m = 0.68,
                      .centre_height_m = 1.045,
                      .inertia_kgm2 = 1000 * (0.68 * 0.68 + 1.045 * 1.045) / 3,
                      .restitution = 0.5538});

Footing with(BasePlan const& base) {
    Footing footing;
    footing.stated = true;
    footing.base = base;
    footing.pad.match_restitution = false;
    return footing;
}
Footing const& on_bed() {
    static Footing const footing = with({.corner_share = 0.4});
    return footing;
}
Footing const& on_rim() {
    static Footing const footing = with({.shape = BaseShape::round, .points = 0});
    return footing;
}

// on points and in space too a history ends where the body lies: at 90 degrees, when it overturned, and towards
// where it fell.
TEST(ShownHistory, EndsWhereTheBodyLies) {
    struct Last : Observer {
        void begin(std::span<Channel const> /*channels*/) override {}
        void at(std::span<double const> values) override {
            before = std::move(last);
            last.assign(values.begin(), values.end());
        }
        std::vector<double> before, last;
    };
    std::vector<double> push(400, 0.0);
    for (std::size_t i = 0; i < 200; ++i) {
        push[i] = 12 * std::sin(pi * 0.01 * static_cast<double>(i));
    }
    for (double const sign : {1.0, -1.0}) {
        GroundMotion motion;
        motion.time_step_s = 0.01;
        motion.horizontal_mps2 = push;
        for (auto const* const footing : {&on_bed(), &on_rim()}) {
            Scene const scene{body, std::nullopt, *footing};
            SceneTrial const trial{scene, motion, sign};
            ModelSelector const selector({EffectMode::automatic, 0});
            auto const response = selector.respond(trial);
            ASSERT_EQ(response.verdict, Verdict::overturned);
            Last seen;
            selector.show(trial, response, seen);
            EXPECT_NEAR(std::abs(seen.last[1]), pi / 2, 1e-12);
            EXPECT_LE(seen.last[0], response.overturn_time_s);  // the end of the step in which it passed
            EXPECT_NEAR(seen.last[0], response.overturn_time_s, 1e-3);
            for (std::size_t i = 2; i < seen.last.size(); ++i) {
                EXPECT_NEAR(seen.last[i], seen.before[i], 0.05) << "channel " << i;
            }
        }
    }
}

// of every model a history has the base's edges and the top at each instant; the row has their extremes.
// A history on points begins in motion, some micrometres from rest.
TEST(ShownHistory, ReachesAsFarAsItsRow) {
    struct Extremes : Observer {
        std::vector<std::string> keys;
        std::vector<double> most, least;
        void begin(std::span<Channel const> channels) override {
            for (auto const& channel : channels) {
                keys.emplace_back(channel.key);
            }
            most.assign(keys.size(), -1e300);
            least.assign(keys.size(), 1e300);
        }
        void at(std::span<double const> values) override {
            for (std::size_t i = 0; i < values.size(); ++i) {
                most[i] = std::max(most[i], values[i]);
                least[i] = std::min(least[i], values[i]);
            }
        }
        [[nodiscard]] std::size_t place(std::string_view key) const {
            return static_cast<std::size_t>(std::ranges::find(keys, key) - keys.begin());
        }
    };
    GroundMotion motion;
    motion.time_step_s = 0.01;
    for (std::size_t i = 0; i < 400; ++i) {
        motion.horizontal_mps2.push_back(i < 50 ? std::sin(pi * 0.02 * static_cast<double>(i)) : 0.0);
    }
    for (Footing const* const footing : {&Scene::on_corners(), &on_bed(), &on_rim()}) {
        for (double const friction : {2.0, 0.4}) {
            for (double const scale : {9.0, -9.0}) {
                Scene const scene{body, Friction{friction, friction}, *footing};
                SceneTrial const trial{scene, motion, scale};
                ModelSelector const selector({EffectMode::automatic, 0});
                std::vector<std::byte> own(selector.extra_bytes());
                auto const response = selector.respond(trial, own);
                ASSERT_NE(response.verdict, Verdict::at_rest);
                ASSERT_NE(response.verdict, Verdict::overturned);
                Extremes seen;
                selector.show(trial, response, seen);
                auto const row = [&](char const* name) { return selector.extra_value(response, name, own); };
                EXPECT_NEAR(seen.most[seen.place("edge_x_most_m")], row("edge_x_most"), 1e-5) << response.model;
                EXPECT_NEAR(seen.least[seen.place("edge_x_least_m")], row("edge_x_least"), 1e-5) << response.model;
                double const top = std::max(seen.most[seen.place("top_x_m")], -seen.least[seen.place("top_x_m")]);
                EXPECT_LE(top, row("peak_top") + 1e-6) << response.model;
                EXPECT_GT(top, 0.9 * row("peak_top")) << response.model;  // a rigid body's row adds its peaks
            }
        }
    }
}

}  // namespace
}  // namespace overturn
