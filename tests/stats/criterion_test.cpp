// Requirement R-708: the criterion is judged by counts with exact intervals, over trials and over waves, and by where
// it stood when bodies fell.
#include "stats/criterion.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace overturn {
namespace {

/// \param together so many trials count as one
void expect_share(Share const& share, std::int64_t count, std::int64_t of, double together = 1) {
    EXPECT_EQ(share.count, count);
    EXPECT_EQ(share.of, of);
    auto const groups = static_cast<std::int64_t>(static_cast<double>(of) / together);
    auto const counted = static_cast<double>(count) / together;
    EXPECT_EQ(share.interval.lower, clopper_pearson(static_cast<std::int64_t>(counted), groups, 0.95).lower);
    EXPECT_EQ(share.interval.upper,
              clopper_pearson(std::min(groups, static_cast<std::int64_t>(std::ceil(counted))), groups, 0.95).upper);
}

TEST(CriterionStudy, CountsTrialsAndWaves) {
    // Wave 1 falls twice while said safe, wave 2 stands while said unsafe, wave 3 does as predicted.
    std::vector<CriterionTrial> const trials{{0.5, 1, false}, {0.8, 1, true},  {0.9, 1, true},  {0.7, 2, false},
                                             {1.0, 2, false}, {1.4, 2, false}, {0.6, 3, false}, {1.3, 3, true}};
    auto const study = study_criterion(trials, 0.95);

    // Waves give 3, 1 and 1 of the safe trials, and 2 and 1 of those that fell: 11 / 5 and 5 / 3 count as one.
    expect_share(study.safe_but_overturned, 2, 5, 11.0 / 5);
    expect_share(study.overturned_predicted_safe, 2, 3, 5.0 / 3);
    expect_share(study.unsafe_but_stood, 2, 3, 5.0 / 3);  // at exactly 1 it is not called safe
    expect_share(study.stood_predicted_unsafe, 2, 5, 11.0 / 5);
    expect_share(study.waves_safe_but_overturned, 1, 3);
    EXPECT_EQ(study.at_overturning->count, 3);
    EXPECT_TRUE(std::isnan(study.at_overturning->median)) << "of two waves";
    EXPECT_EQ(study.first_overturning->count, 2);
    EXPECT_EQ(study.first_overturning->lowest, 0.8);
    EXPECT_EQ(study.first_overturning->highest, 1.3);
    EXPECT_EQ(study.highest_standing->highest, 1.4);
}

/// A body that stands again at a higher level, or whose levels come in another order, stood at the highest of them.
TEST(CriterionStudy, TheHighestStandingOfAWaveIsNotTheLast) {
    std::vector<CriterionTrial> const trials{{0.9, 1, false}, {1.2, 1, false}, {0.4, 1, false}, {1.5, 1, true}};

    EXPECT_EQ(study_criterion(trials, 0.95).highest_standing->highest, 1.2);
}

/// Trials that never left the ground put no criterion to the test: they are not counted, nor are waves that have no
/// others.
TEST(CriterionStudy, CountsWhatUplifted) {
    std::vector<CriterionTrial> const trials{{0.2, 1, false, false}, {0.6, 1, false, true},  {0.9, 1, true, true},
                                             {0.2, 2, false, false}, {0.7, 2, false, false}, {0.8, 3, false, true},
                                             {1.2, 4, true, true}};
    auto const study = study_criterion(trials, 0.95);

    expect_share(study.safe_but_overturned, 1, 6, 14.0 / 6);  // of waves with 3, 2 and 1
    expect_share(study.safe_uplifted_but_overturned, 1, 3, 5.0 / 3);
    expect_share(study.waves_safe_but_overturned, 1, 3);
    expect_share(study.waves_safe_uplifted_but_overturned, 1, 2);
}

// of waves that share what was drawn each is a wave, with its own first overturning; intervals count groups.
TEST(CriterionStudy, WavesThatShareADrawAreWavesStill) {
    std::vector<CriterionTrial> trials;
    for (std::int64_t wave = 0; wave < 40; ++wave) {
        trials.push_back({0.9, wave, false});
        trials.push_back({2 + 0.01 * static_cast<double>(wave), wave, true});
    }
    auto const alone = study_criterion(trials, 0.95);
    auto const grouped = study_criterion(trials, 0.95, 8);
    EXPECT_EQ(grouped.first_overturning->count, 40);
    EXPECT_EQ(grouped.first_overturning->median, alone.first_overturning->median);
    EXPECT_EQ(grouped.waves_safe_uplifted_but_overturned.of, 40);
    EXPECT_EQ(grouped.waves_safe_uplifted_but_overturned.interval.upper, clopper_pearson(0, 5, 0.95).upper);
}

// 100 waves whose ten trials end alike hold no more than 100 trials, and those of a wave each hold all.
TEST(CriterionStudy, TrialsOfOneWaveAreNotIndependent) {
    std::vector<CriterionTrial> alike;
    std::vector<CriterionTrial> single;
    for (std::int64_t wave = 0; wave < 100; ++wave) {
        for (int level = 0; level < 10; ++level) {
            alike.push_back({0.9, wave, wave < 7});
            single.push_back({0.9, 10 * wave + level, wave < 7});
        }
    }
    auto const of_waves = study_criterion(alike, 0.95);
    expect_share(of_waves.safe_but_overturned, 70, 1000, 10);
    EXPECT_EQ(of_waves.safe_but_overturned.interval.upper, of_waves.waves_safe_but_overturned.interval.upper);
    expect_share(study_criterion(single, 0.95).safe_but_overturned, 70, 1000);
}

// As everywhere (fewest_for_quantile): a median needs five values, 25 and 75 % no more, 5 and 95 % twenty.
TEST(CriterionStudy, FewValuesHaveNoPercentiles) {
    auto const of = [](std::size_t count, std::optional<double> independent = {}) {
        std::vector<double> ratios(count);
        for (std::size_t i = 0; i < count; ++i) {
            ratios[i] = 1 + static_cast<double>(i);
        }
        return ratio_quantiles(std::move(ratios), independent).value();
    };
    auto const four = of(4);
    EXPECT_TRUE(std::isnan(four.median) && std::isnan(four.p25) && std::isnan(four.p05));
    EXPECT_EQ(four.lowest, 1);
    EXPECT_EQ(four.highest, 4);
    EXPECT_EQ(of(5).median, 3);
    EXPECT_EQ(of(5).p75, 4);
    EXPECT_TRUE(std::isnan(of(19).p05) && std::isnan(of(19).p95));
    EXPECT_DOUBLE_EQ(of(20).p05, 1.95);
    EXPECT_DOUBLE_EQ(of(20).p95, 19.05);
    EXPECT_TRUE(std::isnan(of(20, 4).median)) << "of four waves";

    // Twenty trials of four waves are four.
    std::vector<CriterionTrial> trials;
    for (std::int64_t wave = 0; wave < 4; ++wave) {
        for (int level = 0; level < 5; ++level) {
            trials.push_back({.ratio = 1 + 0.1 * level, .wave = wave, .overturned = true});
        }
    }
    auto const study = study_criterion(trials, 0.95);
    EXPECT_EQ(study.at_overturning->count, 20);
    EXPECT_TRUE(std::isnan(study.at_overturning->p05));
    EXPECT_TRUE(std::isnan(study.first_overturning->median));
}

TEST(CriterionStudy, NothingOverturnedHasNoQuantiles) {
    auto const study = study_criterion(std::vector<CriterionTrial>{{0.5, 1, false}}, 0.95);

    EXPECT_FALSE(study.at_overturning);
    EXPECT_EQ(study.unsafe_but_stood.of, 0);
    EXPECT_EQ(study.overturned_predicted_safe.interval.upper, 1) << "nothing tried says nothing";
}

}  // namespace
}  // namespace overturn
