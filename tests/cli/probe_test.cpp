// Requirement R-904: before a run, what it will cost is estimated from a few of its waves, spread over the
// campaign.
#include "runner/probe.hpp"

#include <numeric>

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
