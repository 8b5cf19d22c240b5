// Requirement R-713: a history says at every instant how far a body is to each side and what is left of the room.
#include "campaign/site_path.hpp"

#include <array>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "campaign/judged.hpp"
#include "campaign/kept_history.hpp"

namespace overturn {
namespace {

using testing::campaign_from;
using testing::height_m;
using testing::Keeper;
using testing::Kept;
using testing::slides;
using testing::with_site;

std::array const planar{Channel{"time_s"}, Channel{"rotation_rad"}, Channel{"slip_m"}};
std::array const spatial{Channel{"time_s"},  Channel{"tilt_rad"}, Channel{"azimuth_rad"},
                         Channel{"yaw_rad"}, Channel{"x_m"},      Channel{"y_m"}};

TrialRow row_of(CampaignSpec const& spec, Verdict verdict = Verdict::slid) {
    TrialRow row;
    row.verdict = verdict;
    row.centre_height_m = spec.bodies[0].body.centre_height_m();
    return row;
}

/// What one instant adds to a history.
Kept shown(CampaignSpec const& spec, std::span<Channel const> channels, std::vector<double> const& values,
           OtherCask const* other = nullptr) {
    Kept kept;
    Keeper keeper(kept);
    SitePath path(spec.site, spec.bodies[0], row_of(spec), &keeper, other);
    path.begin(channels);
    path.at(values);
    return kept;
}

// closed form in the plane: the edge goes with slip, the top H sin theta further, the other edge is drawn in.
TEST(SitePath, InThePlane) {
    double const b = 0.45;
    double const theta = 0.2;
    auto const spec = campaign_from(with_site("wall='2 m'\nedge={minus_x='1 m'}\nwidth='1 m'\n"));
    auto const right = shown(spec, planar, {0, theta, 0.1});
    EXPECT_DOUBLE_EQ(right.least("edge_plus_x_m"), 0.1);
    EXPECT_DOUBLE_EQ(right.least("edge_minus_x_m"), -0.1 - 2 * b * (1 - std::cos(theta)));
    EXPECT_DOUBLE_EQ(right.least("reach_plus_x_m"), 0.1 + 0.05 + height_m * std::sin(theta));
    EXPECT_DOUBLE_EQ(right.least("clearance_m"), 2 - 0.15 - height_m * std::sin(theta));
    EXPECT_DOUBLE_EQ(right.least("edge_margin_m"), 1.1 + 2 * b * (1 - std::cos(theta)));
    auto const left = shown(spec, planar, {0, -theta, 0.1});
    EXPECT_DOUBLE_EQ(left.least("edge_plus_x_m"), 0.1 - 2 * b * (1 - std::cos(theta)));
    EXPECT_DOUBLE_EQ(left.least("edge_minus_x_m"), -0.1);
    EXPECT_DOUBLE_EQ(left.least("clearance_m"), 2 + 0.1 - 0.05 - height_m * std::sin(theta));
    EXPECT_DOUBLE_EQ(left.least("reach_plus_y_m"), 0.05);
    auto const sloped = campaign_from(with_site("wall='2 m'\n", slides + "slope='2 deg'\n"));
    auto const falls = shown(sloped, planar, {0, 0, 0});
    EXPECT_DOUBLE_EQ(falls.least("reach_plus_x_m"), height_m * std::sin(2 * pi / 180)) << "it leans towards the valley";
    EXPECT_DOUBLE_EQ(falls.least("reach_minus_x_m"), 0);
    EXPECT_EQ(falls.columns.count("edge_margin_m"), 0U) << "no edge was stated";
}

// closed form in space: a square turned by 45 deg, a tilt across it, a round one.
TEST(SitePath, InSpace) {
    double const b = 0.45;
    double const tilt = 0.1;
    auto const square = campaign_from(with_site("wall='2 m'\nedge='1 m'\n", testing::square_slides));
    auto const turned = shown(square, spatial, {0, 0, 0, pi / 4, 0.2, -0.1});
    EXPECT_NEAR(turned.least("edge_plus_x_m"), 0.2 + b * (std::sqrt(2.0) - 1), 1e-12);
    EXPECT_NEAR(turned.least("edge_minus_y_m"), 0.1 + b * (std::sqrt(2.0) - 1), 1e-12);
    EXPECT_NEAR(turned.least("edge_margin_m"), 1 - 0.2 - b * (std::sqrt(2.0) - 1), 1e-12);
    auto const leans = shown(square, spatial, {0, tilt, pi / 2, 0, 0, 0});
    EXPECT_NEAR(leans.least("edge_plus_x_m"), 0, 1e-12);
    EXPECT_NEAR(leans.least("edge_plus_y_m"), -b * (1 - std::cos(tilt)), 1e-12);
    EXPECT_NEAR(leans.least("reach_plus_y_m"), height_m * std::sin(tilt) - b * (1 - std::cos(tilt)), 1e-12);
    EXPECT_NEAR(leans.least("reach_minus_y_m"), -b * (1 - std::cos(tilt)), 1e-12);
    EXPECT_NEAR(leans.least("reach_plus_x_m"), 0, 1e-12);
    auto const round = campaign_from(with_site("wall='2 m'\n", slides + "base={shape='round'}\n"));
    auto const oblique = shown(round, spatial, {0, tilt, pi / 4, 1, 0.1, 0});
    double const sine = std::sin(tilt) * std::sqrt(0.5);
    EXPECT_NEAR(oblique.least("edge_plus_x_m"), 0.1 + b * (std::sqrt(1 - sine * sine) - 1), 1e-12);
    EXPECT_NEAR(oblique.least("reach_plus_x_m"), oblique.least("edge_plus_x_m") + height_m * sine, 1e-12);
    EXPECT_NEAR(oblique.least("reach_minus_x_m"), oblique.least("edge_minus_x_m"), 1e-12);
}

// closed form in space: corners that differ, turned from x towards y.
TEST(SitePath, APolygonTurnsFromXTowardsY) {
    auto const spec = campaign_from(with_site(
        "wall='2 m'\n",
        "[[bodies]]\nname='p'\nmass='12.6 t'\nbase_width='0.6 m'\ncentre_height='1 m'\ninertia='uniform-block'\n"
        "friction=0.3\nbase={shape='polygon',corners=[[0.5,0.4],[-0.3,0.4],[-0.3,-0.4],[0.5,-0.4]]}\n"));
    auto const quarter = shown(spec, spatial, {0, 0, 0, pi / 2, 0, 0});
    EXPECT_NEAR(quarter.least("edge_plus_x_m"), 0.4 - 0.5, 1e-12);
    EXPECT_NEAR(quarter.least("edge_minus_x_m"), 0.4 - 0.3, 1e-12);
    EXPECT_NEAR(quarter.least("edge_plus_y_m"), 0.5 - 0.4, 1e-12);
    EXPECT_NEAR(quarter.least("edge_minus_y_m"), 0.3 - 0.4, 1e-12);
}

// two bodies over time: the other cask is where it is at that instant; one like the body itself moves along.
TEST(SitePath, TheOtherCaskIsWhereItIsAtThatTime) {
    auto const spec = campaign_from(with_site("cask={plus_x='1 m'}\n"));
    auto const moves = [](SitePath& path) {
        path.begin(planar);
        path.at(std::vector{1.0, 0.0, -0.1});
        path.at(std::vector{2.0, 0.0, -0.4});
        path.at(std::vector{3.0, 0.0, 0.2});
    };
    auto const beside = [&](SitePath const& other, double time_s) {
        OtherCask const cask{other};
        return shown(spec, planar, {time_s, 0, 0.3}, &cask).least("clearance_m");
    };
    SitePath other(spec.site, spec.bodies[0], row_of(spec));
    auto const left_at = [&](double time_s) { return beside(other, time_s); };
    EXPECT_DOUBLE_EQ(left_at(1), 0.7) << "it is at rest";
    moves(other);
    EXPECT_DOUBLE_EQ(left_at(0.5), 0.6);
    EXPECT_DOUBLE_EQ(left_at(1), 0.6);
    EXPECT_DOUBLE_EQ(left_at(1.5), 0.3) << "of both instants the nearer one";
    EXPECT_DOUBLE_EQ(left_at(2.5), 0.3);
    EXPECT_DOUBLE_EQ(left_at(9), 0.9);
    SitePath fails(spec.site, spec.bodies[0], row_of(spec, Verdict::failed));
    EXPECT_TRUE(std::isnan(beside(fails, 1))) << "nobody saw it";
    moves(fails);
    EXPECT_DOUBLE_EQ(beside(fails, 2.5), 0.3);
    EXPECT_TRUE(std::isnan(beside(fails, 9))) << "it has no verdict";
    auto flies_away = row_of(spec, Verdict::overturned);
    flies_away.contact_lost_s = 2;
    SitePath flies(spec.site, spec.bodies[0], flies_away);
    moves(flies);
    EXPECT_DOUBLE_EQ(beside(flies, 2), 0.3);
    EXPECT_TRUE(std::isnan(beside(flies, 2.5)));
    EXPECT_TRUE(std::isnan(beside(flies, 9)));
    auto const sloped = campaign_from(with_site("cask={minus_x='1 m'}\n", slides + "slope='2 deg'\n"));
    SitePath const rests(sloped.site, sloped.bodies[0], row_of(sloped));
    OtherCask const uphill{rests};
    EXPECT_NEAR(shown(sloped, planar, {1, 0, 0}, &uphill).least("clearance_m"), 1 - height_m * std::sin(2 * pi / 180),
                1e-12)
        << "it leans towards the valley";
}

// of a cask like the body itself it is not known when it moves: it counts as far as the body ever went.
TEST(SitePath, ALikeMayComeAtAnyTime) {
    auto const left = [](std::string const& side, Verdict verdict, double slip_m, double contact_lost_s = never) {
        auto const spec = campaign_from(with_site("cask={" + side + "='1 m'}\n"));
        auto row = row_of(spec, verdict);
        row.contact_lost_s = contact_lost_s;
        SitePath itself(spec.site, spec.bodies[0], row);
        itself.begin(planar);
        itself.at(std::vector{1.0, 0.0, -0.4});
        itself.at(std::vector{2.0, 0.0, 0.1});
        OtherCask const like{itself, true};
        return shown(spec, planar, {2, 0, slip_m}, &like).least("clearance_m");
    };
    EXPECT_DOUBLE_EQ(left("plus_x", Verdict::slid, 0.1), 1 - 0.1 - 0.4);
    EXPECT_DOUBLE_EQ(left("minus_x", Verdict::slid, 0.1), 1 + 0.1 - 0.4);
    EXPECT_DOUBLE_EQ(left("plus_y", Verdict::slid, 0.1), 1) << "in a plane nothing moves across it";
    EXPECT_TRUE(std::isnan(left("plus_x", Verdict::failed, 0.1))) << "nobody knows how far it goes after that";
    EXPECT_TRUE(std::isnan(left("plus_x", Verdict::overturned, 0.1, 1.5))) << "nor how far it flew";
    auto const wide = campaign_from(with_site("cask={plus_x='1 m'}\nwidth='1.1 m'\n"));
    SitePath const rests(wide.site, wide.bodies[0], row_of(wide));
    OtherCask const like{rests, true};
    EXPECT_DOUBLE_EQ(shown(wide, planar, {2, 0, 0.3}, &like).least("clearance_m"), 1 - (0.1 + 0.3) - 0.1);
    auto const alone = campaign_from(with_site("cask='1 m'\n"));
    EXPECT_TRUE(std::isnan(shown(alone, planar, {2, 0, 0}).least("clearance_m"))) << "nobody followed the other one";
}

// where nobody followed the body the history says nothing of the room, as the row does not.
TEST(SitePath, WhatWasNotFollowedIsNotKnown) {
    auto const spec = campaign_from(with_site("wall='1 m'\nedge='1 m'\n"));
    auto const left_at = [&](TrialRow const& row, double time_s) {
        Kept kept;
        Keeper keeper(kept);
        SitePath path(spec.site, spec.bodies[0], row, &keeper);
        path.begin(planar);
        path.at(std::vector{time_s, 0.0, 0.3});
        EXPECT_EQ(std::isnan(kept.columns.at("clearance_m")[0]), std::isnan(kept.columns.at("edge_margin_m")[0]));
        return kept.columns.at("clearance_m")[0];
    };
    auto row = row_of(spec);
    EXPECT_DOUBLE_EQ(left_at(row, 3), 0.7);
    row.required = mask_of(Effect::sliding);
    EXPECT_TRUE(std::isnan(left_at(row, 3))) << "it may have slipped";
    row.effects = mask_of(Effect::sliding);
    EXPECT_DOUBLE_EQ(left_at(row, 3), 0.7);
    row.contact_lost_s = 2;
    EXPECT_DOUBLE_EQ(left_at(row, 2), 0.7);
    EXPECT_TRUE(std::isnan(left_at(row, 3))) << "it flew";
}

}  // namespace
}  // namespace overturn
