// Requirement R-905: what a report's page says in sentences is written with the program's other sentences.
#include "output/page_text.hpp"

#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/campaigns.hpp"

namespace overturn {
namespace {

constexpr auto* block =
    "[[bodies]]\nname='block'\nmass='12.6 t'\nbase_width='0.9 m'\ncentre_height='1.045 m'\n"
    "inertia='uniform-block'\nfriction=0.5\n";

// 40 waves at four levels, of which so many overturned the body; a few of them after the record.
struct Counted {
    CampaignSpec spec;
    Statistics statistics;
    std::vector<BodyAnalysis> analysis;

    explicit Counted(std::vector<int> const& overturned, bool after_the_record = false)
        : spec(testing::campaign_from(
            testing::quick_waves + block
            + testing::levels("values=['300 gal','600 gal','900 gal','1200 gal']\ndesign_basis='600 gal'\n"))),
          statistics(spec) {
        for (std::int64_t wave = 0; wave < 40; ++wave) {
            WaveRow row;
            row.id = wave;
            row.pga_mps2 = 3;
            statistics.add(row, std::vector<MeasureRow>(1));
            for (std::size_t l = 0; l < spec.levels.levels.size(); ++l) {
                TrialRow trial;
                trial.wave = wave;
                trial.level = static_cast<std::int64_t>(l);
                trial.amplitude = spec.levels.levels[l].value;
                trial.verdict = wave < overturned.at(l) ? Verdict::overturned : Verdict::rocked;
                trial.peak_rotation_ratio = 0.01;
                trial.time_of_peak_s = after_the_record && l == 0 && wave < 3 ? 1e4 : 0;
                statistics.add(trial);
            }
        }
        analysis = analyse(spec, statistics, {});
    }
    [[nodiscard]] output::Answered answered() const {
        return {.spec = spec, .statistics = statistics, .analysis = analysis};
    }
};

// 0 of 40: the exact upper end is 1 - 0.025^(1/40) = 0.0881, rounded up.
TEST(PageText, AHeadlineHoldsTheDesignBasisAndTheCurve) {
    Counted const rising({0, 4, 20, 38});
    auto const lines = output::headlines(rising.answered());
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_TRUE(
        lines[0].starts_with("block: at the design basis (600 gal) 4 of 40 trials overturned, P between 0.027 "
                             "and 0.24; half overturn at "))
        << lines[0];
    EXPECT_NE(lines[0].find(" gal ("), std::string::npos) << "the median in the levels' unit";
    EXPECT_NE(lines[0].find(", 5 % point >= "), std::string::npos);
    EXPECT_NE(lines[0].find("(flagged: no-beta-u)"), std::string::npos);
    EXPECT_EQ(lines[0].find("times a year"), std::string::npos);

    Counted const none({0, 0, 0, 0});
    auto const safe = output::headlines(none.answered());
    EXPECT_NE(safe.at(0).find("0 of 40 trials overturned, P between 0 and 0.089; nothing overturned: no curve"),
              std::string::npos)
        << safe[0];
}

// what a reader copies first of the curve's lower tail is its safe end, rounded down.
TEST(PageText, LowPointsBeginWithTheirSafeEnd) {
    Counted stated({0, 4, 20, 38});
    stated.analysis = analyse(stated.spec, stated.statistics, {.beta_u = 0.3});
    auto const& curve = stated.analysis.front().fragility.front();
    auto const& ends = curve.fit.intervals();
    auto const gal = [](double mps2) { return fmt::format("{:g} gal", std::floor(mps2 * 100)); };
    auto const hclpf = fmt::format(">= {} (estimate {})", gal(ends.hclpf->lower), gal(*curve.fit.hclpf()));
    auto const five =
        fmt::format(">= {} (estimate {})", gal(ends.five_percent_point.lower), gal(*curve.fit.five_percent_point()));
    ASSERT_LT(std::floor(ends.hclpf->lower * 100), std::floor(*curve.fit.hclpf() * 100)) << "two numbers";
    auto const line = output::headlines(stated.answered()).at(0);
    EXPECT_NE(line.find(", 5 % point " + five + ", HCLPF " + hclpf), std::string::npos) << line << hclpf;
    auto const points = output::low_points(stated.answered());
    ASSERT_EQ(points.size(), stated.analysis.front().fragility.size());
    EXPECT_EQ(points[0].at("five_percent_point"), five);
    EXPECT_EQ(points[0].at("hclpf"), hclpf);

    auto const unstated = output::low_points(Counted({0, 4, 20, 38}).answered());
    EXPECT_EQ(unstated[0].at("hclpf"), "unknown: needs beta_U");
    EXPECT_TRUE(unstated[0].at("five_percent_point").get<std::string>().starts_with(">= "));
    auto const none = output::low_points(Counted({0, 0, 0, 0}).answered());
    EXPECT_TRUE(none[0].at("five_percent_point").get<std::string>().starts_with("no curve (")) << none[0];
}

// A remark for each quoted probability, in the order of the table; a bound says from which trials it comes.
TEST(PageText, EachQuotedProbabilityHasARemark) {
    Counted const rising({0, 0, 20, 38});
    auto const remarks = output::quote_remarks(rising.answered());
    auto const& curves = rising.analysis.front().fragility;
    std::size_t quotes = 0;
    for (auto const& curve : curves) {
        quotes += curve.fit.quotes.size();
    }
    ASSERT_EQ(remarks.size(), quotes);
    ASSERT_GE(quotes, 4U);
    EXPECT_EQ(remarks[0].at("measure"), "pga");
    EXPECT_EQ(remarks[0].at("text"), "0 of 40 trials there, in the tail");
    EXPECT_EQ(remarks[1].at("text"), "20 of 40 trials there") << "1.5 times: no comma first";
    EXPECT_EQ(remarks[2].at("text"), "38 of 40 trials there");
    EXPECT_NE(remarks[3].at("text").get<std::string>().find("outside the data"), std::string::npos);
}

//
TEST(PageText, TrialsThatOutliveTheRecordAreCounted) {
    EXPECT_TRUE(output::cut_short_lines(Counted({0, 4, 20, 38}).answered()).empty());
    auto const lines = output::cut_short_lines(Counted({0, 4, 20, 38}, true).answered());
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_TRUE(
        lines[0].starts_with("block: 3 trials were still rocking at the end of the record (0 overturned and 3 reached"))
        << lines[0];
}

TEST(PageText, WhatIsWholeNeedsNoWords) {
    EXPECT_EQ(output::histories_text(3, 3, {}), "");
    EXPECT_EQ(output::histories_text(3, 5, {}).substr(0, 29), "Histories are of 3 of 5 bodie");
    EXPECT_EQ(output::histories_text(3, 3, {"type-a", "type-b"}),
              "No history at the design basis: type-a, type-b did not move there under any wave.");
    EXPECT_EQ(output::ran_text(40, 40), "40");
    EXPECT_EQ(output::ran_text(32, 64).substr(0, 16), "32 of 64 planned");
    EXPECT_EQ(output::wave_title(7, false), "Wave 7");
    EXPECT_NE(output::wave_title(7, true), "Wave 7");
    EXPECT_EQ(output::cost_text(2, 3, 1, 100, "x.json").find(" in 1 runs"), std::string::npos);
    EXPECT_NE(output::cost_text(2, 3, 2, 100, "x.json").find(" in 2 runs"), std::string::npos);
}

}  // namespace
}  // namespace overturn
