// Requirement R-713: what is round a body is a distance by direction; a trial says how much of it slip and tilt
// together leave at least, never more than there was, and limit states of that come with it.
#include "campaign/site.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include <gtest/gtest.h>

#include "campaign/trial.hpp"
#include "contact/cases.hpp"
#include "response/registry.hpp"
#include "spatial/spatial_model.hpp"
#include "support/campaigns.hpp"
#include "support/expect_input_error.hpp"

namespace overturn {
namespace {

using testing::campaign_from;
using testing::expect_input_error;

std::string const slides = testing::type_b + "friction=0.3\n";

std::string with_site(std::string const& site, std::string const& bodies = slides) {
    return testing::quick_waves + bodies + testing::levels("values=[4,8]\n") + "[site]\n" + site;
}

class Judged {
  public:
    explicit Judged(std::string const& site, std::string const& bodies = slides)
        : spec(campaign_from(with_site(site, bodies))),
          ladder(spec.effects, spec.accuracy),
          judge(spec.site, spec.bodies, ladder),
          own(ladder.own_bytes()) {
        ladder.put_nothing(own);
    }

    // Of a body that slid so far and tilted so far in a plane.
    [[nodiscard]] TrialRow filled(double slip_m, double tilt_rad) const {
        TrialRow row;
        row.verdict = tilt_rad >= pi / 2 ? Verdict::overturned : Verdict::slid_and_rocked;
        row.peak_slip_m = slip_m;
        row.peak_rotation_rad = tilt_rad;
        row.centre_height_m = spec.bodies[0].body.centre_height_m();
        judge.fill(row, 0, own);
        return row;
    }

    CampaignSpec spec;
    Ladder ladder;
    SiteJudge judge;
    std::vector<std::byte> own;
};

constexpr double height_m = 2 * 1.045;

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

// in space each side has its own way, of the base's edge beyond where it stood.
TEST(Site, InSpaceEachSideCountsForItself) {
    Judged judged("wall={plus_x='1 m', minus_y='1 m'}\nedge={minus_x='1 m'}\n", slides + "base={shape='square'}\n");
    TrialRow row = judged.filled(0.4, 0.05);
    row.rung = spatial_traits().number;
    double const b = 0.45;
    for (auto const& [traits, offset] : judged.ladder.own_parts()) {
        for (auto const& [name, value] : {std::pair{"edge_x_most", b + 0.1}, std::pair{"edge_x_least", -b - 0.3},
                                          std::pair{"edge_y_most", b}, std::pair{"edge_y_least", -b - 0.2}}) {
            auto const field = std::ranges::find(traits->fields, name, &Field::name);
            if (traits->number == spatial_traits().number) {
                ASSERT_NE(field, traits->fields.end());
                std::memcpy(judged.own.data() + offset + field->offset, &value, sizeof value);
            }
        }
    }
    judged.judge.fill(row, 0, judged.own);
    EXPECT_NEAR(row.least_clearance_m, 1 - 0.2 - height_m * std::sin(0.05), 1e-12);
    EXPECT_NEAR(row.edge_margin_m, 0.7, 1e-12);
}

// what effects that were called for and left out decide is not known.
TEST(Site, WhatWasNotSimulatedIsNotKnown) {
    Judged const judged("wall='1 m'\nedge='1 m'\n");
    TrialRow row;
    row.called = mask_of(Effect::sliding);
    judged.judge.fill(row, 0, judged.own);
    EXPECT_TRUE(std::isnan(row.least_clearance_m));
    EXPECT_TRUE(std::isnan(row.edge_margin_m));
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
        constexpr double give_m = 1e-4;  // by which points slip before the corner counts as slipped
        EXPECT_LE(furthest, 3 - row.least_clearance_m + give_m) << amplitude;
    }
}

// the limit states come with the site; a trial that fell has passed them, and they join with others.
TEST(Site, ItsLimitsAreThere) {
    auto const spec = campaign_from(with_site("cask='60 cm'\nedge='40 cm'\n")
                                    + "[[limits]]\nname='bad'\nany=['touches','leaves-the-pad']\n"
                                      "[[limits]]\nname='close'\nquantity='least_clearance'\nbelow='10 cm'\n");
    ASSERT_EQ(spec.limits.size(), 5U);
    EXPECT_EQ(definition_of(spec.limits[1], spec.limits), "least_clearance < 0 m");
    EXPECT_EQ(definition_of(spec.limits[2], spec.limits), "edge_margin < 0 m");
    EXPECT_EQ(definition_of(spec.limits[4], spec.limits), "least_clearance < 10 cm");
    Ladder const ladder(spec.effects, spec.accuracy);
    LimitJudge const judge(spec.limits, ladder);
    TrialRow row;
    row.verdict = Verdict::slid;
    row.least_clearance_m = -0.3;  // of less than 0 no more than of little: it is no magnitude
    row.edge_margin_m = 0.2;
    auto const outcomes = judge.judge(row, {});
    EXPECT_TRUE(outcomes.has_passed(1) && !outcomes.has_passed(2) && outcomes.has_passed(3) && outcomes.has_passed(4));
    EXPECT_GT(judge.nearness(1, row, {}), 1);
    EXPECT_LT(judge.nearness(2, row, {}), 1);
    row.verdict = Verdict::overturned;
    EXPECT_TRUE(judge.judge(row, {}).has_passed(2)) << "a fall passes it";
}

// trials of a campaign hold what their own slip and tilt leave.
TEST(Site, TrialsHaveTheirColumns) {
    auto const spec = campaign_from(with_site("wall='50 cm'\nedge='2 m'\n"));
    PhaseSeconds seconds;
    auto const wave = prepare_wave(spec, Plan(spec), 1, seconds);
    auto const row = run_trial(spec, wave, 0, 1).rows.front();
    ASSERT_GT(row.peak_slip_m, 0);
    EXPECT_DOUBLE_EQ(row.least_clearance_m, 0.5 - row.peak_slip_m - height_m * std::sin(row.peak_rotation_rad));
    EXPECT_DOUBLE_EQ(row.edge_margin_m, 2 - row.peak_slip_m);
}

// what says nothing, or cannot be meant, is refused at its key.
TEST(Site, WhatCannotBeMeantIsRefused) {
    auto const refuse = [](std::string const& text, std::string const& where, std::string const& why) {
        expect_input_error([&] { (void)campaign_from(text); }, where, why);
    };
    std::string const least = "[[limits]]\nname='x'\nquantity='least_clearance'\n";
    refuse(with_site(""), "site", "State cask, wall or edge");
    refuse(with_site("wall={}\n"), "site.wall", "no direction");
    refuse(with_site("wall='-1 m'\n"), "site.wall", "above 0");
    refuse(with_site("wall={up='1 m'}\n"), "site.wall.up", "unknown key");
    refuse(with_site("edge='1 m'\n") + least + "below='1 cm'\n", "quantity", "without cask or wall in [site]");
    refuse(with_site("wall='1 m'\n") + least + "above='1 cm'\n", "quantity", "State below");
    refuse(with_site("wall='1 m'\n") + "[[limits]]\nname='touches'\nquantity='peak_slip'\nabove='1 cm'\n", "name",
           "comes with [site]");
}

}  // namespace
}  // namespace overturn
