// Requirement R-706: limit states are fitted as overturning is, have targets of their own, and are refused where they
// are wrong or cannot be passed.
#include <algorithm>
#include <cmath>
#include <span>

#include <gtest/gtest.h>

#include "campaign/limit_state.hpp"
#include "campaign/trial.hpp"
#include "campaign/warnings.hpp"
#include "response/registry.hpp"
#include "results/analysis.hpp"
#include "results/statistics.hpp"
#include "support/expect_input_error.hpp"
#include "support/limited_campaigns.hpp"

namespace overturn {
namespace {

using testing::row_of;
using testing::sliding_body;
using testing::tilts;
using testing::touches;
using testing::with_limits;

/// A threshold on the rotation that only a fall passes is overturning by another name: the same fits, to the bit.
TEST(LimitState, IsFittedAsOverturningIs) {
    auto const spec = with_limits("[[limits]]\nname='fell'\nquantity='peak_rotation_ratio'\nabove=1.5\n");
    Statistics statistics(spec);
    for (int w = 0; w < 40; ++w) {
        WaveRow wave;
        wave.id = w;
        wave.pga_mps2 = 2;
        wave.pgv_mps = 0.5 + 0.01 * w;
        statistics.add(wave, std::vector<MeasureRow>(1));
        for (int level = 0; level < 3; ++level) {
            bool const falls = level >= 1 + w % 3 - (w % 7 == 0 ? 1 : 0);
            auto row = row_of(falls ? Verdict::overturned : Verdict::rocked, 0, falls ? 2.5 : 0.3);
            row.wave = w;
            row.level = level;
            row.amplitude = spec.levels.levels[static_cast<std::size_t>(level)].value;
            row.scale = row.amplitude / 2;
            row.v_wes_mps = 0.3 * row.scale * (1 + 0.01 * w);
            row.ou_v_e_mps = 2 * row.v_wes_mps;
            row.v_ereq_mps = 1.35;
            statistics.add(row);
        }
    }
    auto const body = analyse(spec, statistics, {}).at(0);
    auto const& own = body.limits.at(0).fragility;

    ASSERT_EQ(own.size(), body.fragility.size());
    for (std::size_t m = 0; m < own.size(); ++m) {
        ASSERT_TRUE(own[m].fit.identifiable());
        EXPECT_EQ(own[m].limit, "fell");
        EXPECT_EQ(own[m].fit.passing, Passing::exceeded);
        EXPECT_EQ(own[m].fit.line->log_median(), body.fragility[m].fit.line->log_median());
        EXPECT_EQ(own[m].fit.five_percent_point(), body.fragility[m].fit.five_percent_point());
        EXPECT_EQ(own[m].fit.intervals().median.upper, body.fragility[m].fit.intervals().median.upper);
        EXPECT_EQ(own[m].rank_area, body.fragility[m].rank_area);
    }
    EXPECT_EQ(body.quantiles.back().quantity, "peak_rotation_ratio");
    EXPECT_EQ(body.quantiles.back().quantiles[2].value, body.quantiles.back().fallen) << "nearly all fell there";
}

/// Half of forty trials fell: the median rotation is a fall, and no mean of a rotation and pi/2; the median slip
/// likewise.
TEST(LimitState, AFallLiesBeyondEveryRotation) {
    auto const spec = with_limits("");
    Statistics statistics(spec);
    for (int w = 0; w < 40; ++w) {
        WaveRow wave;
        wave.id = w;
        statistics.add(wave, std::vector<MeasureRow>(1));
        auto row = row_of(w < 20 ? Verdict::rocked : Verdict::overturned, 0.01 * (w + 1), w < 20 ? 0.2 : 2.7);
        row.wave = w;
        row.amplitude = spec.levels.levels[0].value;
        statistics.add(row);
    }
    auto const quantiles = analyse(spec, statistics, {}).at(0).quantiles;
    double const fallen = pi / 2 / spec.bodies[0].body.alpha_rad();

    ASSERT_EQ(quantiles.size(), 6U) << "slip and rotation at three levels";
    EXPECT_TRUE(std::isinf(quantiles[0].quantiles[0].value)) << "nor is it a slip";
    EXPECT_EQ(quantiles[0].overturned, 20);
    EXPECT_EQ(quantiles[3].quantity, "peak_rotation_ratio");
    EXPECT_EQ(quantiles[3].quantiles[0].value, fallen);
    EXPECT_EQ(quantiles[3].quantiles[2].value, fallen);
    EXPECT_EQ(quantiles[3].trials, 40);
    EXPECT_EQ(quantiles[4].trials, 0);
}

/// Of fewer than five waves there is no median, of fewer than 20 no 95th percentile: the lowest and the highest are.
TEST(LimitState, FewWavesHaveNoPercentile) {
    auto const spec = with_limits("");
    for (int const waves : {4, 5, 6, 7, 19, 20}) {
        Statistics statistics(spec);
        for (int w = 0; w < waves; ++w) {
            WaveRow wave;
            wave.id = w;
            statistics.add(wave, std::vector<MeasureRow>(1));
            auto row = row_of(Verdict::rocked, 0.01 * (w + 1), 0.2);
            row.wave = w;
            row.amplitude = spec.levels.levels[0].value;
            statistics.add(row);
        }
        auto const slip = analyse(spec, statistics, {}).at(0).quantiles.at(0);
        EXPECT_EQ(std::isnan(slip.quantiles[0].value), waves < 5) << waves;
        EXPECT_EQ(std::isnan(slip.quantiles[1].value), waves < 7) << waves;
        EXPECT_EQ(std::isnan(slip.quantiles[2].value), waves < 20) << waves;
        EXPECT_EQ(slip.least, 0.01);
        EXPECT_EQ(slip.most, 0.01 * waves);
    }
}

/// Targets of [statistics] hold for every limit state that states none of its own.
TEST(LimitState, TargetsAreEachLimitStatesOwn) {
    auto const spec =
        with_limits(touches + "target_half_width=0.05\n" + tilts, "[statistics]\ntarget_half_width=0.1\n");

    EXPECT_EQ(spec.limits[0].target.half_width, 0.1);
    EXPECT_EQ(spec.limits[1].target.half_width, 0.05);
    EXPECT_EQ(spec.limits[2].target.half_width, 0.1);
    EXPECT_TRUE(with_limits(touches + "target_median_half_width=0.05\n").has_target());
    EXPECT_FALSE(with_limits(touches).has_target());
}

TEST(LimitState, BadOnesAreRefusedWhereTheyAreWrong) {
    auto const refuse = [](std::string const& limits, std::string const& part, std::string const& more = "") {
        testing::expect_input_error([&] { (void)with_limits(limits, more); }, part);
    };
    refuse("[[limits]]\nname='a'\n", "none of quantity, any and all in 'a'");
    refuse("[[limits]]\nname='a'\nquantity='peak_slip'\nabove=1\nany=['overturning']\n", "quantity and any");
    refuse("[[limits]]\nname='a'\nquantity='peak_slp'\nabove=1\n", "Did you mean 'peak_slip'?");
    refuse("[[limits]]\nname='a'\nquantity='overturn_time'\nabove=1\n", "no stored response");
    refuse("[[limits]]\nname='a'\nquantity='peak_slip'\n", "above");
    refuse("[[limits]]\nname='a'\nquantity='peak_slip'\nabove='3 kine'\n", "above");
    refuse("[[limits]]\nname='a'\nquantity='peak_slip'\nabove=1\nbelow=2\n", "beside above");
    refuse("[[limits]]\nname='a'\nquantity='peak_slip'\nabove=-1\n", "above");
    refuse("[[limits]]\nname='a'\nquantity='peak_slip'\nabove=1\nunits='m'\n", "units");
    refuse("[[limits]]\nname='overturning'\nquantity='peak_slip'\nabove=1\n", "is always there");
    refuse(touches + touches, "'touches' twice");
    refuse("[[limits]]\nname='a/b'\nquantity='peak_slip'\nabove=1\n", "without '/'");
    refuse("[[limits]]\nname='a'\nany=['b']\n", "no limit state stated before this one");
    refuse("[[limits]]\nname='a'\nany=['a']\n", "no limit state stated before this one");
    refuse("[[limits]]\nname='a'\nany=[]\n", "empty");
    refuse(touches, "'peak_slip' needs the effect sliding", "[effects]\nmode='none'\n");
    refuse("[[limits]]\nname='a'\nquantity='peak_crush'\nabove='1 mm'\n", "'peak_crush' needs the effect contact",
           "[effects]\ninclude=['sliding']\n");
}

// a limit that no body can pass as it is stated is refused; a body among others that cannot is reported.
TEST(LimitState, WhatNoBodyCanPassIsRefused) {
    auto const campaign = [](std::string const& bodies, std::string const& limit) {
        return testing::campaign_from(testing::quick_waves + bodies + testing::levels("values=[3]\n") + limit);
    };
    testing::expect_input_error([&] { (void)campaign(testing::type_a, touches); }, "limits[0].quantity",
                                "which has no friction", "State its friction");
    auto const crushed = "[[limits]]\nname='crushed'\nquantity='peak_crush'\nabove='1 mm'\n";
    testing::expect_input_error([&] { (void)campaign(testing::type_a, crushed); }, "limits[0].quantity",
                                "whose pad has no strength", "State pad.strength");
    EXPECT_NO_THROW((void)campaign(testing::type_a + "pad={strength='30 MPa'}\n", crushed));

    auto const both = campaign(sliding_body + testing::type_b, touches);
    auto const lines = warnings_of(both);
    EXPECT_EQ(std::ranges::count_if(lines, [](auto const& l) { return l.find("limit 'touches': 'peak_slip'") == 0; }),
              1);
}

// metres where millimetres were meant are reported.
TEST(LimitState, AbsurdThresholdsAreReported) {
    auto const told = [](std::string const& above) {
        auto const lines =
            warnings_of(with_limits("[[limits]]\nname='t'\nquantity='peak_slip'\nabove=" + above + "\n"));
        return std::ranges::any_of(
            lines, [](auto const& l) { return l.find("limit 't': peak_slip above 300 m (bodies slide") == 0; });
    };
    EXPECT_TRUE(told("300"));
    EXPECT_FALSE(told("'300 mm'"));
}

}  // namespace
}  // namespace overturn
