// Requirement R-713: a trial says how much of the room round its body slip and tilt together leave at least, never more
// than there was.
#include "campaign/site_judge.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "campaign/judged.hpp"
#include "contact/cases.hpp"

namespace overturn {
namespace {

using testing::height_m;
using testing::Judged;
using testing::slides;
using testing::square_slides;

// closed form: slip alone, a turn about a corner alone (the top of the leading side goes H sin theta), both.
TEST(Site, WhatSlipAndTiltLeave) {
    Judged const judged("wall='1 m'\nedge='0.5 m'\n");
    EXPECT_DOUBLE_EQ(judged.filled(0.2, 0).least_clearance_m, 0.8);
    EXPECT_DOUBLE_EQ(judged.filled(0.2, 0).edge_margin_m, 0.3);
    EXPECT_DOUBLE_EQ(judged.filled(0, 0.1).least_clearance_m, 1 - height_m * std::sin(0.1));
    EXPECT_DOUBLE_EQ(judged.filled(0, 0.1).edge_margin_m, 0.5);
    EXPECT_DOUBLE_EQ(judged.filled(0.2, 0.1).least_clearance_m, 1 - 0.2 - height_m * std::sin(0.1));
    EXPECT_DOUBLE_EQ(judged.filled(0.1, pi / 2).least_clearance_m, 1 - 0.1 - height_m) << "it lies";
}

// another cask may come as far; the nearer of several counts; across the plane nothing moves.
TEST(Site, ANeighbourMovesToo) {
    EXPECT_DOUBLE_EQ(Judged("cask='1 m'\n").filled(0.2, 0).least_clearance_m, 0.6);
    EXPECT_DOUBLE_EQ(Judged("cask='1 m'\nwall='0.7 m'\n").filled(0.2, 0).least_clearance_m, 0.5);
    EXPECT_DOUBLE_EQ(Judged("wall={plus_y='9 m', minus_x='50 cm'}\n").filled(0.25, 0).least_clearance_m, 0.25);
    EXPECT_DOUBLE_EQ(Judged("wall={plus_y='1 cm'}\n").filled(0.3, 0.2).least_clearance_m, 0.01);
    EXPECT_TRUE(std::isnan(Judged("wall='1 m'\n").filled(0.3, 0).edge_margin_m)) << "no edge was stated";
}

// the height is what is stated, else of the parts, else twice that of the centre of gravity.
TEST(Site, TheTopIsThatOfTheBody) {
    auto const lean = [](Judged const& judged) { return 9 - judged.filled(0, pi / 2).least_clearance_m; };
    EXPECT_DOUBLE_EQ(lean(Judged("wall='9 m'\nheight='2.5 m'\n")), 2.5);
    std::string const parts =
        "[[bodies]]\nname='p'\nbase_width='1.4 m'\nfriction=0.3\n"
        "parts=[{kind='box',mass='2 t',width='1.4 m',height='0.3 m'},"
        "{kind='cylinder',mass='10 t',diameter='0.8 m',height='1.9 m',bottom='0.3 m'}]\n";
    EXPECT_DOUBLE_EQ(lean(Judged("wall='9 m'\n", parts)), 2.2);
}

// what reaches beyond the base is nearer from the first: parts that are wider, or a stated width.
TEST(Site, WhatReachesBeyondTheBaseIsNearer) {
    std::string const parts =
        "[[bodies]]\nname='p'\nbase_width='1.4 m'\nfriction=0.3\n"
        "parts=[{kind='cylinder',mass='10 t',diameter='1.6 m',height='1.9 m'},"
        "{kind='box',mass='1 t',width='1.5 m',height='0.3 m'},{kind='point',mass='1 t',height='1 m'}]\n";
    EXPECT_DOUBLE_EQ(Judged("wall='9 m'\n", parts).filled(0.2, 0).least_clearance_m, 9 - 0.1 - 0.2);
    EXPECT_DOUBLE_EQ(Judged("cask='9 m'\n", parts).filled(0.2, 0).least_clearance_m, 9 - 2 * 0.3) << "both do";
    EXPECT_DOUBLE_EQ(Judged("edge='9 m'\n", parts).filled(0.2, 0).edge_margin_m, 9 - 0.2) << "it stands on its base";
    EXPECT_DOUBLE_EQ(Judged("wall='9 m'\nwidth='1.7 m'\n", parts).filled(0.2, 0).least_clearance_m, 9 - 0.15 - 0.2);
    EXPECT_DOUBLE_EQ(Judged("wall='9 m'\nwidth='1 m'\n", parts).filled(0.2, 0).least_clearance_m, 9 - 0.2)
        << "the base itself is wider";
}

Judged leaning(std::string const& side, std::string const& placed) {
    return Judged("wall={" + side + "='9 m'}\n", testing::type_b + "friction=0.3\n" + placed);
}

// Of a body whose corners differ: it came as near to falling as this share of alpha.
double lost(Judged const& judged, double share) {
    auto row = judged.moved(0, share * judged.spec.bodies[0].body.alpha_rad());
    row.peak_rotation_ratio = share;
    return 9 - judged.filled(row).least_clearance_m;
}

// on a slope a body leans towards the valley before it moves: the wall there is nearer, the one behind is not.
TEST(Site, OnASlopeItLeansFromTheFirst) {
    double const slope = 2 * pi / 180;
    double const base_angle = std::atan(0.45 / 1.045);
    auto const downhill = [&](double share) { return height_m * std::sin(share * (base_angle - slope) + slope); };
    EXPECT_NEAR(lost(leaning("plus_x", "slope='2 deg'\n"), 0), height_m * std::sin(slope), 1e-12);
    EXPECT_NEAR(lost(leaning("plus_x", "slope='2 deg'\n"), 0.5), downhill(0.5), 1e-12);
    EXPECT_NEAR(lost(leaning("minus_x", "slope='-2 deg'\n"), 0.5), downhill(0.5), 1e-12);
    EXPECT_NEAR(lost(leaning("minus_x", "slope='2 deg'\n"), 0.5), height_m * std::sin(0.5 * (base_angle + slope)),
                1e-12)
        << "over the corner uphill it may have turned further than the row has";
    EXPECT_NEAR(9 - leaning("plus_x", "slope='2 deg'\n").filled(0, pi / 2).least_clearance_m, height_m, 1e-12);
}

// of corners that differ each may have turned as near to its own alpha as the trial came to falling.
TEST(Site, CornersThatDifferTurnEachByItsOwn) {
    auto const turned = [](double half_width_m) { return height_m * std::sin(0.5 * std::atan(half_width_m / 1.045)); };
    EXPECT_NEAR(lost(leaning("plus_x", "offset='0.1 m'\n"), 0.5), turned(0.35), 1e-12);
    EXPECT_NEAR(lost(leaning("minus_x", "offset='0.1 m'\n"), 0.5), turned(0.55), 1e-12);
    auto const judged = leaning("minus_x", "offset='0.1 m'\n");
    auto row = judged.moved(0, 0.1);
    row.peak_rotation_ratio = 0.5;
    row.centre_height_m = 0.9;  // as drawn
    double const drawn = 2 * 0.9 * std::sin(0.5 * std::atan(0.55 / 0.9));
    EXPECT_NEAR(9 - judged.filled(row).least_clearance_m, drawn, 1e-12);
}

// the other cask is another body of the campaign: it comes as its own trial says, and no farther.
TEST(Site, TheOtherCaskMovesAsInItsTrial) {
    std::string const bodies = slides + "[[bodies]]\nname='low'\nmass='9 t'\nbase_width='1.2 m'\ncentre_height='0.5 m'\n"
                                        "inertia='uniform-block'\nfriction=0.4\n";
    Judged const judged("cask='1 m'\ncask_body='low'\n", bodies);
    EXPECT_EQ(judged.judge.neighbour_of(0), 1U);
    EXPECT_FALSE(judged.judge.neighbour_of(1)) << "it is like itself";
    auto row = judged.moved(0.2, 0.05);
    auto other = judged.moved(0.1, 0.2, 1);
    double const own_way = 0.2 + height_m * std::sin(0.05);
    judged.judge.fill(row, {row, judged.extra}, SiteJudge::Trial{other, judged.extra});
    EXPECT_DOUBLE_EQ(row.least_clearance_m, 1 - own_way - (0.1 + 1.0 * std::sin(0.2)));

    row = judged.moved(0.2, 0.05);
    other.verdict = Verdict::failed;
    judged.judge.fill(row, {row, judged.extra}, SiteJudge::Trial{other, judged.extra});
    EXPECT_TRUE(std::isnan(row.least_clearance_m)) << "nobody knows how far that one came";
}

// in space each side has its own way, of the base's edge beyond where it stood.
TEST(Site, InSpaceEachSideCountsForItself) {
    double const b = 0.45;
    double const circle = b * std::sqrt(2.0);
    double const lean = height_m * std::sin(0.05);
    double const lift = circle * (1 - std::cos(0.05));
    auto const to = [](Judged judged, double tilt_rad, std::array<double, 4> const& edges_m) {
        return judged.in_space(tilt_rad, 0, edges_m);
    };
    std::array const edges{circle + 0.1, circle + 0.3, circle, circle + 0.2};
    auto const row =
        to(Judged("wall={plus_x='1 m', minus_y='1 m'}\nedge={minus_x='1 m'}\n", square_slides), 0.05, edges);
    EXPECT_NEAR(row.least_clearance_m, 1 - 0.2 - lean - 2 * lift, 1e-12);
    EXPECT_NEAR(row.edge_margin_m, 0.7 - 2 * lift, 1e-12);
    auto const across = to(Judged("wall={plus_y='1 m'}\n", square_slides), 0.05, edges);
    EXPECT_NEAR(across.least_clearance_m, 1 - lean - 2 * lift, 1e-12) << "a tilt may be that way too";
    auto const still = to(Judged("wall='1 m'\nedge='1 m'\n", square_slides), 0, {circle, circle, circle, circle});
    EXPECT_NEAR(still.least_clearance_m, 1, 1e-12) << "the circle round a square reaches beyond it";
    EXPECT_NEAR(still.edge_margin_m, 1, 1e-12);
    auto const round = to(Judged("edge='1 m'\n", slides + "base={shape='round'}\n"), 0.3, {b + 0.1, b, b, b});
    EXPECT_NEAR(round.edge_margin_m, 0.9, 1e-12) << "of a round base the circle is the edge";
}

// in a plane each side has its own way too; only points tell to which side the body tilted, and a body that fell
// reaches its neighbour with its whole height.
TEST(Site, InAPlaneEachSideCountsForItself) {
    double const b = 0.45;
    auto const left = [&](std::string const& site, double tilt_rad) {
        return Judged(site).sliding(tilt_rad, {b + 0.3, b + 0.1});
    };
    EXPECT_NEAR(left("wall={plus_x='1 m'}\n", 0).least_clearance_m, 0.7, 1e-12);
    EXPECT_NEAR(left("wall={minus_x='1 m'}\n", 0).least_clearance_m, 0.9, 1e-12);
    EXPECT_NEAR(left("edge={minus_x='0.2 m'}\n", 0.2).edge_margin_m, 0.1, 1e-12);
    EXPECT_NEAR(left("wall={minus_x='1 m'}\n", 0.2).least_clearance_m, 0.9 - height_m * std::sin(0.2), 1e-12);
    EXPECT_NEAR(left("cask={minus_x='1 m'}\n", 0).least_clearance_m, 1 - 0.1 - 0.3, 1e-12)
        << "the like may be mirrored";
    auto const back = Judged("edge={plus_x='0.2 m'}\n").sliding(0, {b - 0.1, b + 0.4});
    EXPECT_NEAR(back.edge_margin_m, 0.2, 1e-12) << "never farther from it than it stood";

    auto const tilted = [&](std::string const& site) {
        return 3 - Judged(site).on_points({b + 0.1, b}, {0.3, 0.05}).least_clearance_m;
    };
    EXPECT_NEAR(tilted("wall={plus_x='3 m'}\n"), 0.1 + height_m * std::sin(0.3), 1e-12);
    EXPECT_NEAR(tilted("wall={minus_x='3 m'}\n"), height_m * std::sin(0.05), 1e-12);
    auto const fallen = [&](std::string const& site) {
        return 3 - Judged(site).on_points({b + 0.1, b}, {pi / 2, 0.05}).least_clearance_m;
    };
    EXPECT_NEAR(fallen("wall={plus_x='3 m'}\n"), 0.1 + height_m, 1e-12);
    EXPECT_NEAR(fallen("wall={minus_x='3 m'}\n"), height_m * std::sin(0.05), 1e-12);
    EXPECT_NEAR(3 - Judged("wall={minus_x='3 m'}\n").sliding(pi / 2, {b, b}).least_clearance_m, height_m, 1e-12)
        << "a rigid body does not say to which side it fell";
}

// a square that turns about its axis reaches out with its corners, at most with the circle round it.
TEST(Site, ATurnReachesOutWithTheCorners) {
    double const b = 0.45;
    double const circle = b * std::sqrt(2.0);
    auto const gone = [&](double yaw_rad) {
        Judged judged("edge='1 m'\n", square_slides);
        return 1 - judged.in_space(0, yaw_rad, {circle, circle, circle, circle}).edge_margin_m;
    };
    EXPECT_NEAR(gone(0.2), b * (std::cos(0.2) + std::sin(0.2)) - b, 1e-12);
    EXPECT_NEAR(gone(pi / 4), circle - b, 1e-12);
    EXPECT_NEAR(gone(2), circle - b, 1e-12) << "it has passed that on its way";
    std::string const oblong =
        "[[bodies]]\nname='p'\nmass='12.6 t'\nbase_width='0.6 m'\ncentre_height='1 m'\ninertia='uniform-block'\n"
        "friction=0.3\nbase={shape='polygon',corners=[[0.5,0.4],[-0.3,0.4],[-0.3,-0.4],[0.5,-0.4]]}\n";
    Judged polygon("edge='1 m'\n", oblong);
    double const far = std::hypot(0.5, 0.4);
    EXPECT_NEAR(polygon.in_space(0, 0, {far, far, far, far}).edge_margin_m, 1, 1e-12);
    double const quarter = polygon.in_space(0, pi / 2, {far, far, far, far}).edge_margin_m;
    EXPECT_NEAR(quarter, 1 - (far - 0.4), 1e-12) << "its far corner may point along y";
    double const half = polygon.in_space(0, pi, {far, far, far, far}).edge_margin_m;
    EXPECT_NEAR(half, 1 - (far - 0.3), 1e-12) << "its far corner may point to where the near edge was";
}

// a neighbour comes the other way: what went to -x only is what its like at +x may do.
TEST(Site, ANeighbourComesTheOtherWay) {
    double const b = 0.45;
    auto const left = [&](std::string const& site, std::array<double, 4> const& edges_m) {
        return Judged(site, slides + "base={shape='round'}\n").in_space(0, 0, edges_m).least_clearance_m;
    };
    EXPECT_NEAR(left("cask={plus_x='1 m'}\n", {b, b + 0.3, b, b}), 0.7, 1e-12);
    EXPECT_NEAR(left("cask={plus_x='1 m'}\n", {b + 0.3, b, b, b}), 0.4, 1e-12) << "the like may be mirrored";
    EXPECT_NEAR(left("cask={minus_y='1 m'}\n", {b, b, b + 0.2, b + 0.1}), 0.7, 1e-12);
}

// what effects that were called for and left out decide is not known, nor what has no verdict, nor where a rigid
// body fell through the air.
TEST(Site, WhatWasNotFollowedIsNotKnown) {
    Judged const judged("wall='1 m'\nedge='1 m'\n");
    auto const unknown = [&](TrialRow const& row) {
        auto const filled = judged.filled(row);
        return std::isnan(filled.least_clearance_m) && std::isnan(filled.edge_margin_m);
    };
    auto row = judged.moved(0.1, 0.1);
    EXPECT_FALSE(unknown(row));
    row.required = mask_of(Effect::sliding);
    EXPECT_TRUE(unknown(row));
    row.effects = mask_of(Effect::sliding);
    EXPECT_FALSE(unknown(row));
    row.verdict = Verdict::contact_lost;
    EXPECT_TRUE(unknown(row));
    row = judged.moved(0.1, pi / 2);
    EXPECT_FALSE(unknown(row));
    row.contact_lost_s = 3;
    EXPECT_TRUE(unknown(row));
    row.effects = mask_of(Effect::contact);
    EXPECT_FALSE(unknown(row)) << "points follow it through the air";
}

// no point of a body that slides and rocks comes nearer, at any instant, than the trial says.
TEST(Site, TheBoundHoldsAtEveryInstant) {
    auto const body = testing::body_b();
    auto const block = testing::on_corners(body, 0.35);
    Judged const judged("wall='3 m'\n");
    for (double const amplitude : {5.0, 6.0, 7.0}) {
        testing::ContactHistory history;
        auto const out = testing::shaken(block, testing::sine(amplitude, 1.2, 3, 2), 1e-3, {}, &history);
        auto const row = judged.filled(out.peak_slip_m, out.peak_rotation_rad);
        double furthest = 0;
        for (auto const& at : history.instants) {
            double const sine = std::sin(at.rotation_rad);
            double const cosine = std::cos(at.rotation_rad);
            for (double const side : {-0.45, 0.45}) {
                for (double const height : {0.0, height_m}) {
                    double const x = at.sway_m + cosine * side + sine * (height - 1.045);
                    furthest = std::max(furthest, std::abs(x) - 0.45);
                }
            }
        }
        EXPECT_GT(furthest, 0.01) << amplitude;
        EXPECT_LE(furthest, 3 - row.least_clearance_m) << amplitude;
    }
}

}  // namespace
}  // namespace overturn
