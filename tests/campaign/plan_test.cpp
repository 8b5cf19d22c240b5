// Requirement R-1001, R-101: waves, trials and blocks are numbered by the campaign alone, and growing it renumbers no
// earlier wave.
#include "campaign/plan.hpp"

#include <set>

#include "campaign/waves_per_look.hpp"
#include "support/campaigns.hpp"
#include "support/expect_input_error.hpp"

namespace overturn {
namespace {

using testing::campaign_from;

CampaignSpec campaign(int waves, std::string const& levels, bool independent = false, bool two_bodies = true) {
    auto text = testing::quick_waves + testing::type_a + (two_bodies ? testing::type_b : "")
                + testing::levels("values=" + levels + (independent ? "\nwaves='independent'\n" : "\n"));
    text.replace(text.find("count=3"), 7, "count=" + std::to_string(waves));
    return campaign_from(text);
}

TEST(Plan, SharedWavesGoThroughAllLevels) {
    auto const spec = campaign(5, "[3,6,9]");
    Plan const plan(spec);

    EXPECT_EQ(plan.waves(), 5);
    EXPECT_EQ(plan.trials_per_wave(), 6);
    EXPECT_EQ(plan.trials(), 30);
    EXPECT_EQ(plan.wave_id(4), 4U);
    auto const trial = plan.trial(2 * 6 + 1 * 3 + 2);
    EXPECT_EQ(trial.wave, 2);
    EXPECT_EQ(trial.body, 1);
    EXPECT_EQ(trial.level, 2);
}

TEST(Plan, IndependentWavesBelongToOneLevel) {
    auto const spec = campaign(5, "[3,6,9]", true);
    Plan const plan(spec);

    EXPECT_EQ(plan.waves(), 15);
    EXPECT_EQ(plan.trials(), 30);
    std::set<std::uint64_t> ids;
    for (std::int64_t wave = 0; wave < plan.waves(); ++wave) {
        EXPECT_EQ(plan.first_level(wave), wave / 5);
        ids.insert(plan.wave_id(wave));
    }
    EXPECT_EQ(ids.size(), 15U);
    EXPECT_EQ(plan.trial(11).wave, 5);
    EXPECT_EQ(plan.trial(11).body, 1);
    EXPECT_EQ(plan.trial(11).level, 1);
}

TEST(Plan, EveryTrialHasOneNumber) {
    for (bool const independent : {false, true}) {
        auto const spec = campaign(7, "[3,6,9]", independent);
        Plan const plan(spec);
        std::set<std::tuple<std::int64_t, std::int64_t, std::int64_t>> seen;
        for (std::int64_t number = 0; number < plan.trials(); ++number) {
            auto const [wave, body, level] = plan.trial(number);
            EXPECT_GE(level, plan.first_level(wave));
            EXPECT_LT(level, plan.first_level(wave) + plan.level_count());
            seen.insert({wave, body, level});
        }
        EXPECT_EQ(seen.size(), static_cast<std::size_t>(plan.trials()));
    }
}

TEST(Plan, GrowthRenumbersNoWave) {
    auto const small = campaign(5, "[3,6]", true);
    auto const more_waves = campaign(8, "[3,6]", true);
    auto const more_levels = campaign(5, "[1,3,6,9]", true);
    Plan const before(small);
    Plan const waves(more_waves);
    Plan const levels(more_levels);

    for (std::int64_t level = 0; level < 2; ++level) {
        for (std::int64_t n = 0; n < 5; ++n) {
            EXPECT_EQ(before.wave_id(level * 5 + n), waves.wave_id(level * 8 + n));
            EXPECT_EQ(before.wave_id(level * 5 + n), levels.wave_id((level + 1) * 5 + n));
        }
    }
}

TEST(Plan, BlocksCoverTheWavesOnce) {
    for (int const count : {1, 3, 255, 256, 600, 70001}) {
        auto const spec = campaign(count, "[3]");
        Plan const plan(spec);
        std::int64_t next = 0;
        for (std::int64_t block = 0; block < plan.blocks(); ++block) {
            auto const [first, size] = plan.waves_of_block(block);
            EXPECT_EQ(first, next);
            EXPECT_GT(size, 0);
            EXPECT_LE(size, plan.block_size());
            next = first + size;
        }
        EXPECT_EQ(next, count);
    }
}

// R-1001: the parts of an array job are all blocks, each once, whatever their number.
TEST(Plan, PartsCoverTheBlocksOnce) {
    auto const spec = campaign(600, "[3]");
    Plan const plan(spec);
    for (std::int64_t const of : {1, 2, 7, 299, 300, 1000}) {
        std::int64_t next = 0;
        for (std::int64_t number = 1; number <= of; ++number) {
            auto const part = plan.blocks_of({number, of});
            EXPECT_EQ(part.first, next);
            EXPECT_GE(part.last, part.first);
            EXPECT_LE(part.count(), plan.blocks() / of + 1);
            next = part.last;
        }
        EXPECT_EQ(next, plan.blocks());
    }
}

TEST(Plan, MissingWavesAreNamedByRange) {
    auto const spec = campaign(600, "[3]");
    Plan const plan(spec);
    ASSERT_EQ(plan.block_size(), 2);

    EXPECT_EQ(plan.waves_text({}), "");
    EXPECT_EQ(plan.waves_text({0, 1, 2, 9, 298, 299}), "0 to 5, 18 to 19, 596 to 599");
}

// R-1303: a block is short enough to lose and a folder of blocks small enough for a file system.
TEST(Plan, BlocksAreFewAndShort) {
    for (std::int64_t const waves : {1, 1000, 100'000, 10'000'000, 1'000'000'000}) {
        auto const spec = campaign(static_cast<int>(waves), "[3]");
        Plan const plan(spec);
        EXPECT_LE(plan.blocks(), 1 << 20) << waves;
        EXPECT_LE(plan.block_size(), std::max<std::int64_t>(64, waves / 1'000'000)) << waves;
    }
}

// R-1303: a thousand ranks have something to do each, and looks at a target stay where they are.
TEST(Plan, LargeCampaignsHaveManyBlocks) {
    auto spec = campaign(16384, "[3]");
    EXPECT_EQ(Plan(spec).block_size(), 16);
    EXPECT_EQ(waves_per_look(16384), 64);
    EXPECT_EQ(Plan(campaign(262'144, "[3]")).blocks(), 16384)
        << "of 4096 blocks a thousand ranks wait a fifth of the time";
    EXPECT_EQ(Plan(campaign(10'000'000, "[3]")).block_size(), 64);
    spec.limits.front().target.half_width = 0.1;
    EXPECT_EQ(Plan(spec).block_size(), 16);
}

// R-1102: of trials on points, a hundred times as dear, a block holds no more than some seconds' worth, so that a run
// which has to leave has something to keep; a target is looked at after whole blocks.
TEST(Plan, BlocksOfTrialsOnPointsAreShort) {
    auto spec = campaign(20'000, "[1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25]");
    ASSERT_EQ(Plan(spec).trials_per_wave(), 50);
    EXPECT_EQ(Plan(spec).block_size(), 16);
    spec.bodies.front().footing.stated = true;
    EXPECT_EQ(Plan(spec).block_size(), 6);
    spec.bodies.back().footing.stated = true;
    EXPECT_EQ(Plan(spec).block_size(), 3);
    spec.limits.front().target.half_width = 0.1;
    EXPECT_EQ(Plan(spec).block_size(), 2);
    EXPECT_EQ(waves_per_look(20'000) % Plan(spec).block_size(), 0);

    auto forced = campaign(20'000, "[3]");
    forced.effects.include = mask_of(Effect::contact);
    forced.measures.energy = forced.measures.wave_quality = false;
    EXPECT_EQ(Plan(forced).block_size(), 16) << "not 128, as of waves that are not measured";
}

// R-1303: where a wave costs less than its commit, many share one; but for a campaign that looks at a target.
TEST(Plan, BlocksOfWhatIsNotMeasuredAreLong) {
    auto spec = campaign(4000, "[3]");
    ASSERT_EQ(Plan(spec).block_size(), 15);
    spec.measures.energy = false;
    EXPECT_EQ(Plan(spec).block_size(), 15);
    spec.measures.wave_quality = false;
    EXPECT_EQ(Plan(spec).block_size(), 128);
    spec.limits.front().target.half_width = 0.1;
    EXPECT_EQ(Plan(spec).block_size(), 15);

    auto few = campaign(5, "[3]");
    few.measures.energy = few.measures.wave_quality = false;
    EXPECT_EQ(Plan(few).block_size(), 5);
}

// R-1303: the rows of a block fit beside a rank's own work, however many levels a wave has.
TEST(Plan, BlocksOfVeryManyLevelsAreShort) {
    auto spec = campaign(20'000, "{from=1,to=9,count=4000}");  // two bodies
    EXPECT_EQ(Plan(spec).block_size(), 8) << "65 536 trials, 16 waves otherwise";
    spec.measures.energy = spec.measures.wave_quality = false;
    EXPECT_EQ(Plan(spec).block_size(), 8);
    spec.limits.front().target.half_width = 0.1;
    EXPECT_EQ(Plan(spec).block_size(), 8);
    EXPECT_EQ(waves_per_look(20'000), 64) << "looks at a target stay where they were";
    EXPECT_EQ(Plan(campaign(3, "{from=1,to=9,count=50000}")).block_size(), 1);
}

// Bodies, a few levels and seed do not enter the block size, and nothing from outside can: it is a function of the
// campaign.
TEST(Plan, BlockSizeFollowsTheWavesOnly) {
    auto const one = campaign(600, "[3]", false, false);
    auto const many = campaign(600, "[1,2,3,4,5,6,7,8,9]", false, true);

    EXPECT_EQ(Plan(one).block_size(), Plan(many).block_size());
    EXPECT_EQ(Plan(one).blocks(), Plan(many).blocks());
}

// Levels by a PGD that is the baseline's and not the ground's are refused, where they are stated.
TEST(Plan, RefusesLevelsByAPgdThatIsDrift) {
    auto const by_pgd = [](std::string const& waves) {
        std::string const levels = "[levels]\nmeasure='pgd'\nvalues=['18 mm']\n";
        auto const input = testing::input_from(waves + testing::type_b + levels);
        auto spec = parse_campaign(input);  // as of a file from before: read all the same
        EXPECT_EQ(spec.levels.levels.size(), 1U);
        refuse_drifting_levels(input, spec);
        return spec;
    };
    std::string const noise =
        "[waves]\nsource='filtered-noise'\nmodel='kanai-tajimi'\nrms=1\nduration='60 s'\ncount=2\n";
    testing::expect_input_error([&] { (void)by_pgd(noise); }, "c.toml:", "measure: pgd of waves that drift",
                                "its displacement grows with the duration", "Scale by pga or pgv");
    std::string const sinusoid = "[waves]\nsource='harmonic'\namplitude=1\nfrequency=0.63\nduration=160\n";
    testing::expect_input_error([&] { (void)by_pgd(sinusoid); }, "begins at once", "state a ramp of some cycles");
    EXPECT_EQ(by_pgd(sinusoid + "ramp=20\n").levels.levels.size(), 1U);
    auto const drawn = [](std::string const& envelope) {
        return "[waves]\nsource='spectrum-compatible'\ncount=3\nduration='120 s'\nmatch='none'\n"
               "[waves.target]\nspectrum='mlit-ch1'\n[waves.envelope]\n"
               + envelope;
    };
    EXPECT_EQ(by_pgd(drawn("shape='jennings'\nrise='10 s'\nlevel_end='60 s'\nend='110 s'\n")).levels.levels.size(), 1U);
    testing::expect_input_error([&] { (void)by_pgd(drawn("shape='constant'\n")); }, "is slower than 20 s",
                                "begin or end abruptly");
    for (std::string const shape : {"half-sine", "rectangle"}) {
        testing::expect_input_error(
            [&] { (void)by_pgd("[waves]\nsource='pulse'\nshape='" + shape + "'\namplitude=1\nperiod='1 s'\n"); },
            "leaves the ground moving");
    }
}

}  // namespace
}  // namespace overturn
