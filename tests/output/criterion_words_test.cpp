// Requirement: what speaks for the energy criterion and against it stands under its own heading, with its
// numbers.
#include "output/detail/criterion_words.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace overturn::output {
namespace {

using Lines = std::vector<std::string>;

Share share(std::int64_t count, std::int64_t of) { return {count, of, clopper_pearson(count, of, 0.95)}; }

MeasuredFragility curve(char const* measure, double median, double beta, double rank) {
    MeasuredFragility m;
    m.measure = measure_named(measure);
    m.label = measure;
    m.fit.state = FragilityState::fitted;
    m.fit.line = ProbitLine{-std::log(median) / beta, 1 / beta};
    m.rank_area = rank;
    return m;
}

/// 41 trials said safe and uplifted, one that did not; six of eight alarms false; V_WES beside PGA.
BodyAnalysis judged(Safety safety) {
    BodyAnalysis body;
    CriterionStudy study;
    study.safe_but_overturned = share(0, 42);
    study.safe_uplifted_but_overturned = share(0, 41);
    study.waves_safe_uplifted_but_overturned = share(0, 41);
    study.unsafe_but_stood = share(6, 8);
    study.at_overturning = RatioQuantiles{.count = 2, .lowest = 2.2};
    body.criterion.push_back({measure_named("v_wes"), RadiusUnit::centimetre, study});
    body.fragility = {curve("pga", 5, 0.4, 0.8), curve("v_wes", 1, 0.2, 0.9)};
    body.verdict = CriterionVerdict{.safety = safety, .false_alarms = Speaks::neither, .beside = {}};
    return body;
}

bool holds(Lines const& lines, std::string_view part) {
    return std::ranges::any_of(lines, [&](auto const& line) { return line.find(part) != std::string::npos; });
}

TEST(CriterionWords, SafetyIsReportedUnderItsHeading) {
    auto const good = words_on(judged(Safety::conservative), 0.95);
    EXPECT_EQ(
        good.supports,
        (Lines{"conservative here: no false-safe prediction in 41 trials that uplifted (1 that did not uplift are "
               "excluded) in 41 waves: false-safe rate < 8.61 % of waves (95 %)",
               "the lowest V_WES / V_Ereq at which a trial overturned is 2.2 (of these waves: more may go below)"}));
    auto const few = words_on(judged(Safety::few_waves), 0.95);
    EXPECT_TRUE(few.supports.empty());
    EXPECT_TRUE(holds(few.open, "too few waves to call it conservative: no false-safe prediction in 41 trials"));
    EXPECT_TRUE(holds(few.open, "the lowest V_WES / V_Ereq at which"));

    auto none = judged(Safety::nothing_overturned);
    none.criterion[0].study.at_overturning.reset();
    auto const open = words_on(none, 0.95).open;
    EXPECT_EQ(open.at(0).find("no false-safe prediction in 41 trials"), 0U) << open.at(0);
    EXPECT_TRUE(holds(open, "nothing overturned: these trials do not show how conservative V_WES is"));
}

TEST(CriterionWords, FalseSafeOnesSpeakAgainst) {
    auto body = judged(Safety::false_safe);
    body.criterion[0].study.safe_uplifted_but_overturned = share(1, 42);
    body.criterion[0].study.waves_safe_uplifted_but_overturned = share(1, 41);
    auto const words = words_on(body, 0.95);
    EXPECT_EQ(words.against,
              (Lines{"not conservative: 1 of 42 trials that uplifted and were predicted safe overturned (2.38 %; 95 %: "
                     "0.0602 % to 12.6 %), in 1 of 41 waves"}));
    EXPECT_TRUE(words.supports.empty());
}

TEST(CriterionWords, SafetyThatWasNotTriedIsOpen) {
    EXPECT_TRUE(
        holds(words_on(judged(Safety::none_predicted_safe), 0.95).open, "not tested: V_WES predicted no trial safe"));
    EXPECT_TRUE(holds(words_on(judged(Safety::none_uplifted), 0.95).open,
                      "not tested: no uplift in any of the 42 trials that"));
}

TEST(CriterionWords, FalseAlarmsAreWeighedByHalf) {
    auto body = judged(Safety::conservative);
    body.criterion[0].study.first_overturning = RatioQuantiles{.lowest = 1.2, .p05 = 1.7, .median = 2.4};
    auto const open = words_on(body, 0.95).open;
    EXPECT_TRUE(holds(open,
                      "perhaps half of its alarms at these levels are false (too few trials): of 8 trials "
                      "predicted unsafe, 6 did not overturn (75 %; 95 %: 34.9 % to 96.9 %)"));
    EXPECT_TRUE(holds(open, "first overturning of each wave: lowest 1.2, 5th percentile 1.7, median 2.4"));
    body.verdict->false_alarms = Speaks::against;
    EXPECT_TRUE(holds(words_on(body, 0.95).against, "more than half of its alarms at these levels are false: of 8"));
    body.verdict->false_alarms = Speaks::in_favour;
    EXPECT_TRUE(holds(words_on(body, 0.95).supports, "fewer than half of its alarms at these levels are false: of 8"));
}

TEST(CriterionWords, TheOtherUnitOfRIsReported) {
    auto body = judged(Safety::conservative);
    body.criterion.push_back({measure_named("v_wes_other_unit"), RadiusUnit::metre, body.criterion[0].study});
    EXPECT_TRUE(holds(words_on(body, 0.95).open,
                      "unit of R: with R in m in T0 and T1, 0 of 42 trials predicted safe overturned"));
}

TEST(CriterionWords, OtherMeasuresStandBesideIt) {
    auto body = judged(Safety::conservative);
    body.verdict->beside = {
        {.curve = 0, .beta_ratio = Interval{0.3, 0.8}, .dispersion = Speaks::in_favour, .rank = Speaks::neither}};
    auto const words = words_on(body, 0.95);
    EXPECT_TRUE(holds(words.supports,
                      "dispersion: beta is 0.2 over V_WES and 0.4 over pga, ratio 0.5 [0.3, 0.8] with waves resampled "
                      "in pairs"));
    EXPECT_TRUE(holds(words.open,
                      "rank: V_WES is higher for the trial that overturned in 90 % of pairs, pga in 80 % (no "
                      "significant difference)"));
    // A beta of a curve that the data reject is said to be one.
    body.fragility[0].fit.flags |= bit(FragilityFlag::poor_fit);
    EXPECT_TRUE(holds(words_on(body, 0.95).supports, "; the curve over pga does not describe the data"));
    body.fragility[1].fit.flags |= bit(FragilityFlag::poor_fit);
    EXPECT_TRUE(holds(words_on(body, 0.95).supports, "; neither curve describes the data"));
    body.fragility[0].fit.flags = 0;
    EXPECT_TRUE(holds(words_on(body, 0.95).supports, "; the curve over V_WES does not describe the data"));

    body.verdict->beside.clear();
    body.one_spectrum = true;
    EXPECT_TRUE(holds(words_on(body, 0.95).open, "cannot be assessed: all waves share one target spectrum"));
    body.fragility[1].fit.line.reset();
    EXPECT_TRUE(holds(words_on(body, 0.95).open, "no curve over V_WES: its dispersion cannot be compared"));
}

TEST(CriterionWords, AGridIsNoSample) {
    BodyAnalysis body;
    body.grid = GridMap{};
    EXPECT_TRUE(words_on(body, 0.95).open.empty()) << "no energies, no criterion";
    body.criterion.push_back({});
    EXPECT_EQ(
        words_on(body, 0.95).open,
        (Lines{"waves on a grid of frequencies are not a random sample: shares and ranks are not probabilities"}));
}

}  // namespace
}  // namespace overturn::output
