// Requirement R-904: before a run, what it will cost is estimated from a few of its waves, spread over the
// campaign.
#include "runner/probe.hpp"

#include <numeric>

#include "cli/plan_ranks.hpp"
#include "results/curves.hpp"
#include "support/campaigns.hpp"

namespace overturn {
namespace {

using testing::campaign_from;

std::string const twelve = "values=[1,2,3,4,5,6,7,8,9,10,11,12]\n";

std::int64_t answered(ProbedCost const& cost) {
    return std::accumulate(cost.models.models.begin(), cost.models.models.end(), std::int64_t{0},
                           [](std::int64_t sum, ModelCost const& model) { return sum + model.trials; });
}

// A cheap campaign is probed with all its levels: those that were thinned for a first look are back.
TEST(PlanProbe, AnswersAllLevelsOfACheapCampaign) {
    auto spec = campaign_from(testing::quick_waves + testing::type_b + testing::levels(twelve));
    auto const levels = spec.levels.levels.size();
    Plan const plan(spec);

    auto const cost = probe(spec, plan);

    EXPECT_EQ(levels, 12U);
    EXPECT_EQ(spec.levels.levels.size(), levels);
    EXPECT_EQ(cost.waves.waves, 3);
    EXPECT_EQ(cost.refused_per_wave, 0);
    EXPECT_GE(answered(cost), 3 * 12);
    EXPECT_GT(cost.generation_s, 0);
    EXPECT_GT(cost.trials_s, 0);
    EXPECT_NEAR(cost.wave_s(), cost.generation_s + cost.measures_s + cost.trials_s, 1e-12);
    EXPECT_EQ(cost.counted_wave_s(), cost.wave_s());
}

// Bodies of which some trials have no verdict: under a vertical motion above 1 g one leaves the ground, the other does
// not feel it.
TEST(PlanProbe, FindsTheBodiesWithUndecidedTrials) {
    auto const vertical = [](std::string const& ratio) { return "[waves.vertical]\nratio=" + ratio + "\n"; };
    auto const undecided = [&](std::string const& ratio) {
        auto spec =
            campaign_from(testing::quick_waves + vertical(ratio) + testing::type_a + "axes=1\n" + testing::type_b
                          + "axes=3\n" + testing::levels("values=[4,6]\n") + "[effects]\ninclude=['vertical']\n");
        return probe(spec, Plan(spec)).undecided_bodies;
    };

    EXPECT_EQ(undecided("4"), 0.5);
    EXPECT_EQ(undecided("0.1"), 0);
}

// A curve with undecided trials is fitted three times: as decided, with all of these fallen, and with none.
TEST(PlanProbe, CountsThreeFitsWhereTrialsAreUndecided) {
    auto const spec = campaign_from(testing::quick_waves + testing::type_b + testing::levels(twelve));
    Plan const plan(spec);
    auto const merge_s = [&](double undecided_bodies) {
        cli::ForecastSeconds seconds;
        seconds.undecided_bodies = undecided_bodies;
        return cli::estimate_ranks(spec, plan, seconds, 1).merge_s;
    };
    constexpr double each_s = 0.025 + 3 * 2.5e-4;  // of three waves

    EXPECT_NEAR(merge_s(1) - merge_s(0), 2 * static_cast<double>(count_curves(spec)) * each_s, 1e-3);
    EXPECT_NEAR(merge_s(0.5), (merge_s(0) + merge_s(1)) / 2, 1e-12);
}

// Waves that a rule refuses cost what making them takes, and no trial.
TEST(PlanProbe, CountsWavesDrawnInVain) {
    ProbedCost cost;
    cost.generation_s = 2;
    cost.measures_s = 1;
    cost.trials_s = 7;
    cost.refused_per_wave = 3;

    EXPECT_EQ(cost.counted_wave_s(), 10 + 3 * 3);
}

}  // namespace
}  // namespace overturn
