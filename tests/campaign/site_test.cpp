// Requirement R-713: what is round a body is a distance by direction; a trial says how much of it slip and tilt
// together leave at least, never more than there was, and limit states of that come with it.
#include "campaign/site.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "campaign/judged.hpp"
#include "campaign/trial.hpp"
#include "support/expect_input_error.hpp"

namespace overturn {
namespace {

using testing::campaign_from;
using testing::expect_input_error;
using testing::height_m;
using testing::with_site;

// the limit states come with the site; a trial that fell has passed them, and they join with others.
TEST(Site, ItsLimitsAreThere) {
    auto const spec = campaign_from(with_site("cask='60 cm'\nedge='40 cm'\n")
                                    + "[[limits]]\nname='bad'\nany=['touches','leaves-the-pad']\n"
                                      "[[limits]]\nname='close'\nquantity='least_clearance'\nbelow='10 cm'\n");
    ASSERT_EQ(spec.limits.size(), 5U);
    EXPECT_EQ(definition_of(spec.limits[1], spec.limits), "least_clearance < 0");
    EXPECT_EQ(definition_of(spec.limits[2], spec.limits), "edge_margin < 0");
    EXPECT_EQ(definition_of(spec.limits[4], spec.limits), "least_clearance < 10 cm");
    ModelSelector const selector(spec.effects, spec.accuracy);
    LimitJudge const judge(spec.limits, selector);
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

// What a trial says of its own under this name; NaN: its model says nothing.
double own(CampaignSpec const& spec, TrialRows const& trials, std::string_view name, std::size_t i = 0) {
    ModelSelector const selector(spec.effects, spec.accuracy);
    for (auto const& [traits, offset] : selector.extra_parts()) {
        auto const field = std::ranges::find(traits->fields, name, &Field::name);
        if (traits->number == trials.rows[i].model && field != traits->fields.end()) {
            return real_at(std::span(trials.extra).subspan(i * selector.extra_bytes() + offset), *field);
        }
    }
    return never;
}

// a rigid trial says how far either edge of its base went, of which the farther is its slip; one without
// friction stays where it stands, and one that should have slipped and may not does not know.
TEST(Site, RigidTrialsSayHowFarEachEdgeWent) {
    double const b = 0.45;
    auto const of = [](CampaignSpec const& spec) {
        PhaseSeconds seconds;
        return run_trial(spec, prepare_wave(spec, Plan(spec), 1, seconds), 0, 1);
    };
    for (std::string const side : {"plus_x", "minus_x"}) {
        auto const spec = campaign_from(with_site("edge={" + side + "='2 m'}\n")
                                        + "[[limits]]\nname='far'\nquantity='edge_x_most'\nabove='46 cm'\n");
        auto const trials = of(spec);
        auto const& row = trials.rows.front();
        double const right = own(spec, trials, "edge_x_most") - b;
        double const left = -own(spec, trials, "edge_x_least") - b;
        ASSERT_GT(row.peak_slip_m, 0.02);
        EXPECT_NEAR(std::max(right, left), row.peak_slip_m, 1e-12);
        EXPECT_GT(std::abs(right - left), 1e-3);
        EXPECT_NEAR(row.edge_margin_m, 2 - (side == "plus_x" ? right : left), 1e-12);
        EXPECT_NEAR(own(spec, trials, "residual_x"), row.residual_slip_m, 1e-15);
        LimitJudge const judge(spec.limits, ModelSelector(spec.effects, spec.accuracy));
        EXPECT_EQ(judge.judge(row, trials.extra).has_passed(3), right > 0.01);
    }
    auto const holds = campaign_from(with_site("edge='2 m'\n", testing::type_b));
    EXPECT_EQ(own(holds, of(holds), "edge_x_most"), b);
    EXPECT_EQ(own(holds, of(holds), "edge_x_least"), -b);
    auto const may_not = campaign_from(testing::quick_waves + testing::slides + testing::levels("values=[4,8]\n")
                                       + "[effects]\nmode='none'\n");
    EXPECT_TRUE(std::isnan(own(may_not, of(may_not), "edge_x_most")));
}

// with another body as the other cask a trial alone, and among all of its waves, says the same: gap less both.
TEST(Site, TheOtherCaskIsOfTheSameWaveAndLevel) {
    std::string const bodies = testing::slides + testing::type_a + "friction=0.2\n";
    auto const spec = campaign_from(with_site("cask='90 cm'\ncask_body='type-a'\n", bodies));
    Plan const plan(spec);
    PhaseSeconds seconds;
    std::vector<PreparedWave> waves;
    for (std::int64_t wave = 0; wave < 3; ++wave) {
        waves.push_back(prepare_wave(spec, plan, wave, seconds));
    }
    TrialRows all;
    ASSERT_TRUE(append_trials(spec, plan, std::span(waves).first(1), all, seconds));
    ASSERT_TRUE(append_trials(spec, plan, std::span(waves).subspan(1), all, seconds)) << "behind rows of before";
    ASSERT_EQ(all.rows.size(), 12U);
    for (std::size_t i = 0; i < all.rows.size(); ++i) {
        auto const& row = all.rows[i];
        auto const& other = all.rows[i / 4 * 4 + 2 + i % 2];
        ASSERT_EQ(other.body, 1);
        auto const slip = [&](std::size_t place, bool right) {
            double const b = all.rows[place].body == 0 ? 0.45 : 0.68;
            return right ? own(spec, all, "edge_x_most", place) - b : -own(spec, all, "edge_x_least", place) - b;
        };
        auto const j = i / 4 * 4 + 2 + i % 2;
        double const both = 2 * std::max(slip(i, true), slip(i, false));  // it is as far to either side
        double const apart = i == j ? both : std::max(slip(i, true) + slip(j, false), slip(i, false) + slip(j, true));
        double const leans = height_m * (std::sin(row.peak_rotation_rad) + std::sin(other.peak_rotation_rad));
        EXPECT_NEAR(row.least_clearance_m, 0.9 - apart - leans, 1e-12) << i;
        auto const alone = run_trial(spec, waves[i / 4], row.body, row.level).rows.front();
        EXPECT_EQ(alone.least_clearance_m, row.least_clearance_m) << i;
    }
    EXPECT_NE(all.rows[1].peak_slip_m, all.rows[3].peak_slip_m) << "they differ";
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
    refuse(with_site("wall='1 m'\nheight='1 m'\n"), "site.height", "below the centre of gravity of");
    refuse(with_site("wall='1 m'\ncask_body='type-b'\n"), "site.cask_body", "without cask");
    refuse(with_site("cask='1 m'\ncask_body='type-c'\n"), "site.cask_body", "Did you mean 'type-b'");
    refuse(with_site("wall='1 m'\nwidth='0 m'\n"), "site.width", "above 0");
    refuse(with_site("edge='1 m'\n") + least + "below='1 cm'\n", "quantity", "without cask or wall in [site]");
    refuse(with_site("wall='1 m'\n") + least + "above='1 cm'\n", "quantity", "State below");
    refuse(with_site("wall='1 m'\n") + "[[limits]]\nname='touches'\nquantity='peak_slip'\nabove='1 cm'\n", "name",
           "comes with [site]");
}

}  // namespace
}  // namespace overturn
