// Requirement R-106, R-1001: the waves that count are the lowest numbers that meet the rule, whatever else was
// computed.
#include "campaign/accepted_waves.hpp"

#include <random>

#include "support/campaigns.hpp"

namespace overturn {
namespace {

using testing::campaign_from;

CampaignSpec ruled(int count, int most_drawn, bool independent = false) {
    auto waves = testing::quick_waves;
    waves.replace(waves.find("match='none'"), 12, "acceptance='japan'\nmost_drawn=" + std::to_string(most_drawn));
    waves.replace(waves.find("count=3"), 7, "count=" + std::to_string(count));
    return campaign_from(waves + testing::type_b
                         + testing::levels(independent ? "values=[3,6]\nwaves='independent'\n" : "values=[3,6]\n"));
}

std::vector<WaveRow> rows_of(Plan const& plan, std::int64_t block, auto const& is_accepted) {
    auto const [first, count] = plan.waves_of_block(block);
    std::vector<WaveRow> rows(static_cast<std::size_t>(count));
    for (std::int64_t w = 0; w < count; ++w) {
        auto& row = rows[static_cast<std::size_t>(w)];
        row.id = static_cast<std::int64_t>(plan.wave_id(first + w));
        row.accepted = is_accepted(first + w) ? Accepted::yes : Accepted::no;
        row.acceptance_failures = is_accepted(first + w) ? 0 : 1 << 3;
    }
    return rows;
}

// Computes what is wanted until nothing is; `surplus` more blocks each time, as other ranks might have.
Plan chosen(AcceptedWaves& waves, Plan const& plan, std::int64_t count, auto const& is_accepted, unsigned surplus) {
    std::mt19937 random(surplus);
    for (auto wanted = waves.wanted(count); !wanted.empty(); wanted = waves.wanted(count)) {
        for (unsigned i = 0; i < surplus; ++i) {
            wanted.push_back(static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(plan.blocks())));
        }
        std::ranges::shuffle(wanted, random);
        for (auto const block : wanted) {
            if (!waves.knows(block)) {
                waves.take(block, rows_of(plan, block, is_accepted));
            }
        }
    }
    return waves.chosen(count);
}

TEST(AcceptedWaves, AreTheLowestNumbersWhateverElseIsKnown) {
    auto const spec = ruled(150, 10);
    Plan const plan(spec);
    auto const every_third = [](std::int64_t number) { return number % 3 == 1; };
    for (unsigned const surplus : {0U, 1U, 7U}) {
        AcceptedWaves waves(spec, plan);
        auto const plan_of = chosen(waves, plan, 150, every_third, surplus);
        ASSERT_EQ(plan_of.waves(), 150);
        for (std::int64_t w = 0; w < 150; ++w) {
            EXPECT_EQ(plan_of.number(w), 3 * w + 1);
            EXPECT_EQ(plan_of.wave_id(w), static_cast<std::uint64_t>(3 * w + 1));
        }
        EXPECT_EQ(plan_of.drawn_until(0), 3 * 149 + 2);
        EXPECT_TRUE(waves.hopeless().empty());
    }
}

// Of 450 that are needed few are computed in vain.
TEST(AcceptedWaves, AreSoughtByTheShareSoFar) {
    auto const spec = ruled(150, 10);
    Plan const plan(spec);
    AcceptedWaves waves(spec, plan);
    (void)chosen(
        waves, plan, 150, [](std::int64_t number) { return number % 3 == 1; }, 0);
    std::int64_t computed = 0;
    for (std::int64_t block = 0; block < plan.blocks(); ++block) {
        computed += waves.knows(block) ? plan.waves_of_block(block).count : 0;
    }
    EXPECT_GE(computed, 449);
    EXPECT_LT(computed, 460);
}

TEST(AcceptedWaves, OfOneLevelAreChosenApartFromOthers) {
    auto const spec = ruled(20, 5, true);
    Plan const plan(spec);
    AcceptedWaves waves(spec, plan);
    auto const rule = [](std::int64_t number) { return number < 100 || number % 2 == 0; };  // the second level's half
    auto const plan_of = chosen(waves, plan, 20, rule, 2);
    ASSERT_EQ(plan_of.waves(), 40);
    for (std::int64_t w = 0; w < 20; ++w) {
        EXPECT_EQ(plan_of.number(w), w);
        EXPECT_EQ(plan_of.first_level(w), 0);
        EXPECT_EQ(plan_of.number(20 + w), 100 + 2 * w);
        EXPECT_EQ(plan_of.first_level(20 + w), 1);
        EXPECT_EQ(plan_of.number_of(static_cast<std::int64_t>(plan_of.wave_id(20 + w))), 100 + 2 * w);
    }
}

TEST(AcceptedWaves, EndACampaignOfWhichOneInTenAtMostPasses) {
    auto const spec = ruled(30, 10);
    Plan const plan(spec);
    for (int const of_first : {9, 10}) {
        AcceptedWaves waves(spec, plan);
        // The rest all pass: only the first hundred decide.
        auto const rule = [&](std::int64_t number) { return number >= 100 || number < of_first; };
        std::string why;
        for (auto wanted = waves.wanted(30); !wanted.empty() && why.empty(); wanted = waves.wanted(30)) {
            for (auto const block : wanted) {
                waves.take(block, rows_of(plan, block, rule));
            }
            why = waves.hopeless();
        }
        EXPECT_EQ(why.empty(), of_first == 10) << why;
        if (of_first == 9) {
            EXPECT_TRUE(
                why.starts_with("9 of the first 100 waves meet japan (fewer than one in ten; of those refused: "
                                "lowest ratio missed by 91. State a longer duration"))
                << why;
        }
    }
}

TEST(AcceptedWaves, MayBeFewerThanAskedForButNotNone) {
    auto const spec = ruled(30, 2);
    Plan const plan(spec);
    AcceptedWaves some(spec, plan);
    EXPECT_EQ(chosen(
                  some, plan, 30, [](std::int64_t number) { return number % 3 == 0; }, 0)
                  .waves(),
              20);
    EXPECT_TRUE(some.hopeless().empty());
    AcceptedWaves none(spec, plan);
    EXPECT_EQ(chosen(
                  none, plan, 30, [](std::int64_t) { return false; }, 0)
                  .waves(),
              0);
    EXPECT_TRUE(none.hopeless().starts_with("none of 60 waves meets japan")) << none.hopeless();
}

TEST(AcceptedWaves, AreAllWithoutARule) {
    auto const spec = campaign_from(testing::quick_waves + testing::type_b + testing::levels("values=[3,6]\n"));
    Plan const plan(spec);
    AcceptedWaves waves(spec, plan);
    EXPECT_FALSE(waves.needs_rows());
    EXPECT_EQ(waves.wanted(3).size(), static_cast<std::size_t>(plan.blocks()));
    for (auto const block : waves.wanted(3)) {
        waves.take(block);
    }
    EXPECT_EQ(waves.chosen(3).waves(), 3);
}

// Blocks hold all waves that were drawn; of the chosen ones every kind of row stays, of the others the wave's alone.
TEST(AcceptedWaves, KeepTheirRowsAndNoOthers) {
    auto const spec = ruled(4, 3);
    Plan const plan(spec);
    PhaseSeconds seconds;
    auto const taken = plan.chosen({1, 4, 5, 7}, 4);
    std::vector<std::int64_t> ids, refused;
    std::vector<TrialRow> trials;
    for (auto const block : blocks_of_chosen(plan, taken)) {
        auto rows = run_block(spec, plan, block, seconds);
        auto const all = rows;
        for (auto const& row : refused_rows(rows, plan, block, taken)) {
            refused.push_back(row.id);
        }
        auto const kept = rows_of_chosen(std::move(rows), plan, block, taken);
        EXPECT_EQ(kept.measures.size(), kept.waves.size());
        EXPECT_EQ(kept.trials.rows.size(), 2 * kept.waves.size());
        EXPECT_EQ(kept.trials.extra.size() * all.trials.rows.size(), all.trials.extra.size() * kept.trials.rows.size());
        for (auto const& row : kept.waves) {
            ids.push_back(row.id);
        }
        trials.insert(trials.end(), kept.trials.rows.begin(), kept.trials.rows.end());
    }
    EXPECT_EQ(ids, (std::vector<std::int64_t>{1, 4, 5, 7}));
    EXPECT_EQ(refused, (std::vector<std::int64_t>{0, 2, 3, 6})) << "those above the last one were not needed";
    for (std::size_t t = 0; t < trials.size(); ++t) {
        EXPECT_EQ(trials[t].wave, ids[t / 2]);
        EXPECT_EQ(trials[t].level, static_cast<std::int64_t>(t % 2));
    }
}

}  // namespace
}  // namespace overturn
