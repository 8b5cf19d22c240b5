// Requirement R-101, R-1002: a trial is a pure function of (campaign, wave, body, level): the same bits alone and in a
// crowd, and when waves, levels or bodies are added.
#include "campaign/trial.hpp"

#include <cmath>

#include "campaign/block_rows.hpp"
#include "campaign/verdict_text.hpp"
#include "response/registry.hpp"
#include "spatial/spatial_model.hpp"
#include "support/bit_equal.hpp"
#include "support/campaigns.hpp"
#include "support/expect_input_error.hpp"

namespace overturn {
namespace {

using testing::campaign_from;

std::string with_count(std::string text, int waves) {
    return text.replace(text.find("count=3"), 7, "count=" + std::to_string(waves));
}

std::string const scatter = "restitution={distribution='lognormal',median=0.85,beta=0.1}\n";
std::string const vertical = "[waves.vertical]\nratio=0.667\n";
std::string const small_campaign =
    testing::quick_waves + vertical + testing::type_b + scatter + testing::levels("values=[4,6]\n");

using testing::bit_equal;

TrialRow run(CampaignSpec const& spec, PreparedWave const& wave, std::int64_t body, std::int64_t level) {
    return run_trial(spec, wave, body, level).rows.front();
}

PreparedWave prepared(CampaignSpec const& spec, std::int64_t wave) {
    PhaseSeconds seconds;
    return prepare_wave(spec, Plan(spec), wave, seconds);
}

// Wave 2 of the small campaign, computed first and alone, against the same wave of `other`.
void expect_same_trials(CampaignSpec const& other, std::int64_t body, std::vector<std::int64_t> const& levels) {
    auto const spec = campaign_from(small_campaign);
    auto const alone = prepared(spec, 2);
    auto const crowd = prepared(other, 2);

    EXPECT_TRUE(bit_equal(alone.row, crowd.row));
    EXPECT_TRUE(bit_equal(alone.measures[0], crowd.measures[static_cast<std::size_t>(body)]));
    for (std::int64_t level = 0; level < 2; ++level) {
        auto const before = run(spec, alone, 0, level);
        auto after = run(other, crowd, body, levels[static_cast<std::size_t>(level)]);
        EXPECT_NE(before.verdict, Verdict::failed);
        after.level = before.level;  // the only thing that a new level below may change
        EXPECT_TRUE(bit_equal(before, after));
    }
}

// an aftershock meets the body where the mainshock left it, and what the mainshock does keeps every bit.
TEST(Aftershocks, LeaveTheMainshocksTrialsAsTheyAre) {
    auto const keys = testing::type_b + "[levels]\nmeasure='factor'\nvalues=[0.6,1,1.6,3]\n";
    auto const plain = campaign_from(testing::quick_waves + keys);
    auto const both = campaign_from(testing::quick_waves + "[waves.aftershock]\nscale=1\npause='20 s'\n" + keys);
    int fell_first = 0;
    int moved_later = 0;
    for (std::int64_t wave = 0; wave < 3; ++wave) {
        auto const one = prepared(plain, wave);
        auto const two = prepared(both, wave);
        double const end_s = one.row.duration_s;
        EXPECT_NEAR(two.row.duration_s, 2 * end_s + 20, 2 * one.motion.time_step_s);
        for (std::int64_t level = 0; level < 4; ++level) {
            auto const first = run(plain, one, 0, level);
            auto const whole = run(both, two, 0, level);
            if (first.overturn_time_s < end_s) {
                EXPECT_EQ(whole.overturn_time_s, first.overturn_time_s);
                EXPECT_EQ(whole.impacts, first.impacts);
                EXPECT_EQ(whole.peak_energy_ratio, first.peak_energy_ratio);
                ++fell_first;
            } else {
                EXPECT_GE(whole.peak_rotation_rad, first.peak_rotation_rad);
                moved_later += whole.time_of_peak_s > end_s + 20 ? 1 : 0;
            }
            if (first.first_uplift_s < end_s) {
                EXPECT_EQ(whole.first_uplift_s, first.first_uplift_s);
            }
        }
    }
    EXPECT_GT(fell_first, 0);
    EXPECT_GT(moved_later, 1);
}

// With R in the other unit beside it, each value has the bits that it has where that unit is the campaign's own.
TEST(TrialMeasures, BothUnitsOfRStandSideBySide) {
    auto const keyed = [](std::string const& keys) {
        return prepared(campaign_from(small_campaign + "[measures]\n" + keys), 1).measures[0];
    };
    auto const centimetres = keyed("radius_unit='cm'\n");
    auto const metres = keyed("radius_unit='m'\n");
    auto const both = keyed("radius_unit='cm'\nboth_radius_units=true\n");

    EXPECT_TRUE(std::isnan(centimetres.other_unit_v_wes_max_mps)) << "not asked for";
    EXPECT_EQ(both.v_wes_max_mps, centimetres.v_wes_max_mps);
    EXPECT_EQ(both.ou_v_e_mps, centimetres.ou_v_e_mps);
    EXPECT_EQ(both.other_unit_v_wes_max_mps, metres.v_wes_max_mps);
    EXPECT_EQ(both.other_unit_ou_v_e_mps, metres.ou_v_e_mps);
    EXPECT_LT(metres.v_wes_max_mps, centimetres.v_wes_max_mps) << "a window ten times shorter offers less";
}

// What is not measured changes no wave and no response: matched waves and unmatched ones.
TEST(TrialMeasures, WhatIsNotWantedChangesNothingElse) {
    for (std::string const match : {"none", "each"}) {
        auto text = small_campaign;
        text.replace(text.find("match='none'"), 12, "match='" + match + "'");
        auto const all = campaign_from(text);
        auto const least = campaign_from(text + "[measures]\nenergy=false\nwave_quality=false\n");
        auto const whole = prepared(all, 1);
        auto const bare = prepared(least, 1);
        EXPECT_EQ(bare.motion.horizontal_mps2, whole.motion.horizontal_mps2);
        EXPECT_EQ(bare.row.pgv_mps, whole.row.pgv_mps);
        EXPECT_EQ(bare.row.matched, whole.row.matched);
        EXPECT_EQ(bare.row.match_iterations, whole.row.match_iterations);
        EXPECT_EQ(whole.row.matched, match == "each" ? 1 : 0);
        EXPECT_EQ(bare.row.duration_5_75_s, 0) << "not judged";
        EXPECT_TRUE(std::isnan(bare.measures[0].v_wes_max_mps)) << "not measured";
        for (std::int64_t level = 0; level < 2; ++level) {
            auto const said = run(all, whole, 0, level);
            auto const row = run(least, bare, 0, level);
            EXPECT_TRUE(bit_equal<Response>(row, said));
            EXPECT_TRUE(std::isnan(row.v_wes_mps));
            EXPECT_GT(said.v_wes_mps, 0);
        }
    }
}

TEST(TrialPurity, AloneAndInACrowd) {
    auto const spec = campaign_from(small_campaign);
    Plan const plan(spec);
    PhaseSeconds seconds;
    auto const wave = prepared(spec, 1);

    auto const block = run_block(spec, plan, 1, seconds);

    ASSERT_EQ(plan.block_size(), 1);
    ASSERT_EQ(block.trials.rows.size(), 2U);
    EXPECT_TRUE(bit_equal(block.waves[0], wave.row));
    EXPECT_TRUE(bit_equal(block.trials.rows[1], run(spec, wave, 0, 1)));
    EXPECT_GT(block.waves[0].vertical_pga_mps2, 0);
    EXPECT_EQ(block.waves[0].transverse_pga_mps2, 0);
}

// how each component was matched is stored with the wave; a weak transverse one leaves a square base as it
// is, and so does any for a body that it is not to shake.
TEST(TrialPurity, TransverseMotionIsReportedAndCallsForSpaceWhereItIsStrong) {
    auto const transverse = testing::quick_waves + "[waves.transverse]\nratio=0.1\n" + vertical + testing::type_b
                            + scatter + testing::levels("values=[4,6]\n");
    auto const spec = campaign_from(small_campaign);
    auto const other = campaign_from(transverse);
    auto const without = prepared(spec, 1);
    auto const with = prepared(other, 1);
    auto const& row = with.row;
    EXPECT_TRUE(bit_equal(run(spec, without, 0, 1), run(other, with, 0, 1)));
    auto const strong = testing::quick_waves + "[waves.transverse]\nratio=1.2\n" + vertical + testing::type_b + scatter;
    for (bool const shaken : {true, false}) {
        auto const third = campaign_from(strong + (shaken ? "" : "axes=1\n") + testing::levels("values=[4,6]\n"));
        auto const there = run(third, prepared(third, 1), 0, 1);
        EXPECT_EQ(there.model == spatial_traits().number, shaken);
        EXPECT_EQ(has(static_cast<EffectMask>(there.required), Effect::vertical), shaken);
    }
    EXPECT_EQ(row.vertical_pga_mps2, without.row.vertical_pga_mps2);
    EXPECT_TRUE(std::isnan(without.row.transverse_match_mean_misfit)) << "there is no such component";
    EXPECT_TRUE(std::isnan(without.row.transverse_match.lowest_ratio));
    EXPECT_GT(row.transverse_match.lowest_ratio, 0);
    EXPECT_GT(row.transverse_pga_mps2, 0);
    EXPECT_GT(row.transverse_match_mean_misfit, 0);
    EXPECT_GE(row.transverse_match_worst_decade, row.transverse_match_mean_misfit);
    EXPECT_NE(row.transverse_match_mean_misfit, row.vertical_match_mean_misfit);
}

// a wave that follows no target has no figures of a match, rather than zeros.
TEST(TrialPurity, WhatWasComparedWithNoTargetHasNoFiguresOfAMatch) {
    auto const steady = prepared(campaign_from("[waves]\nsource='harmonic'\namplitude='100 gal'\nperiod=1\ncycles=5\n"
                                               + testing::type_b + testing::levels("values=[4,6]\n")),
                                 0);
    auto const expect_nothing = [](Fields const& fields, std::span<std::byte const> row,
                                   std::span<std::byte const> before) {
        for (auto const& field : fields) {
            bool const became_nothing =
                field.type == FieldType::real && real_at(before, field) == 0 && std::isnan(real_at(row, field));
            EXPECT_EQ(became_nothing, field.type == FieldType::real && is_match_figure(field.name)) << field.name;
        }
    };
    WaveRow const wave{};
    MeasureRow const measures{};
    expect_nothing(fields_of<WaveRow>(), bytes_of(steady.row), bytes_of(wave));
    expect_nothing(fields_of<MeasureRow>(), bytes_of(steady.measures.at(0)), bytes_of(measures));
}

TEST(TrialPurity, MoreWaves) { expect_same_trials(campaign_from(with_count(small_campaign, 900)), 0, {0, 1}); }

TEST(TrialPurity, MoreLevels) {
    expect_same_trials(campaign_from(testing::quick_waves + vertical + testing::type_b + scatter
                                     + testing::levels("values=[2,4,5,6,9]\ndesign_basis=3\n")),
                       0, {2, 4});
}

TEST(TrialPurity, MoreBodies) {
    expect_same_trials(campaign_from(testing::quick_waves + vertical + testing::type_b + scatter + testing::type_a
                                     + scatter + testing::levels("values=[4,6]\n")),
                       0, {0, 1});
}

TEST(TrialPurity, EffectsAndStatisticsDoNotTouchTheWave) {
    auto const spec = campaign_from(small_campaign);
    auto const other = campaign_from(small_campaign + "[effects]\nmode='none'\n[statistics]\nconfidence=0.9\n");

    EXPECT_TRUE(bit_equal(prepared(spec, 0).row, prepared(other, 0).row));
}

TEST(TrialPurity, AnotherSeedIsAnotherWave) {
    auto input = testing::input_from(small_campaign);
    input.settings = {"seed=8"};
    auto const other = parse_campaign(input);
    auto const spec = campaign_from(small_campaign);

    EXPECT_NE(prepared(spec, 0).row.pga_mps2, prepared(other, 0).row.pga_mps2);
    EXPECT_NE(prepared(spec, 0).bodies[0].body.restitution(), prepared(other, 0).bodies[0].body.restitution());
}

//
TEST(Trial, IsAtItsLevel) {
    auto const spec = campaign_from(small_campaign);
    auto const wave = prepared(spec, 0);

    auto const row = run(spec, wave, 0, 1);

    EXPECT_EQ(row.amplitude, 6);
    EXPECT_DOUBLE_EQ(row.scale * wave.intensity.pga_mps2, 6);
    EXPECT_DOUBLE_EQ(row.v_wes_mps, row.scale * wave.measures[0].v_wes_max_mps);
    EXPECT_EQ(row.v_wes_safe != 0, row.v_wes_mps < row.v_ereq_mps);
    EXPECT_DOUBLE_EQ(row.ou_v_e_mps, row.scale * wave.measures[0].ou_v_e_mps);
    EXPECT_EQ(row.ou_v_e_safe != 0, row.ou_v_e_mps < row.v_ereq_mps);
    EXPECT_GT(std::abs(row.ou_v_e_mps / row.v_wes_mps - 1), 0.01) << "else this could not tell one from the other";
}

// R-1104.
TEST(Trial, AWaveThatCannotBeScaledIsARowWithAReason) {
    auto const spec =
        campaign_from("[waves]\nsource='records'\nfiles=['z.csv']\nunit='gal'\ntime_step='0.01 s'\nformat='columns'\n"
                          + testing::type_b + testing::levels("values=[4]\n"),
                      {{"z.csv", "0\n0\n0\n0\n0\n"}});

    auto const row = run(spec, prepared(spec, 0), 0, 0);

    EXPECT_EQ(row.verdict, Verdict::failed);
    EXPECT_EQ(row.failure, FailureReason::wave_cannot_be_scaled);
    for (double const unknown : {row.scale, row.peak_rotation_rad, row.peak_slip_m, row.v_wes_mps}) {
        EXPECT_TRUE(std::isnan(unknown)) << "not 0: nobody knows";
    }
}

TEST(BlockRows, TravelUnchanged) {
    auto const spec = campaign_from(small_campaign);
    Plan const plan(spec);
    PhaseSeconds seconds;
    auto const rows = run_block(spec, plan, 0, seconds);

    auto const bytes = rows.pack();
    auto const back = BlockRows::unpack(bytes, plan, 1);

    EXPECT_EQ(back.pack(), bytes);
    EXPECT_TRUE(bit_equal(back.trials.rows[1], rows.trials.rows[1]));
    EXPECT_THROW((void)BlockRows::unpack(std::span(bytes).first(bytes.size() - 8), plan, 1), SystemError);
    EXPECT_THROW((void)BlockRows::unpack(bytes, plan, 0), SystemError);
}

// R-1001: blocks computed together, in any choice, have the bytes that each has alone; with models' own records.
TEST(BlockRows, OfSeveralBlocksAreThoseOfEachAlone) {
    auto const spec = campaign_from(with_count(small_campaign, 5) + "[effects]\ninclude=['vertical','contact']\n");
    Plan const plan(spec);
    PhaseSeconds seconds;
    ASSERT_EQ(plan.blocks(), 5);
    ASSERT_GT(plan.extra_bytes(), 0);
    std::vector<std::int64_t> const some{0, 2, 3, 4};

    auto const together = run_blocks(spec, plan, some, seconds, [] { return true; });

    ASSERT_EQ(together->size(), some.size());
    for (std::size_t i = 0; i < some.size(); ++i) {
        EXPECT_EQ((*together)[i].pack(), run_block(spec, plan, some[i], seconds).pack());
    }
    EXPECT_NE((*together)[0].pack(), (*together)[1].pack());
    EXPECT_GE(blocks_together(plan), 4);
    EXPECT_FALSE(run_blocks(spec, plan, some, seconds, [] { return false; }));
}

// R-1102: a block is left before any of its trials on points, in the plane and in space; what takes no time is not
// asked for.
TEST(BlockRows, AreLeftBeforeEveryTrialOnPoints) {
    for (auto const* const effect : {"contact", "spatial"}) {
        auto const spec = campaign_from(with_count(small_campaign, 1) + "[effects]\ninclude=['" + effect + "']\n");
        Plan const plan(spec);
        PhaseSeconds seconds;
        std::int64_t const block = 0;
        auto const run = [&](std::int64_t most) {
            std::int64_t asked = 0;
            auto const rows = run_blocks(spec, plan, std::span(&block, 1), seconds, [&] { return ++asked <= most; });
            EXPECT_EQ(rows.has_value(), asked <= most);
            return asked;
        };
        std::int64_t const all = 1 + plan.trials_per_wave();  // the wave, and its trials

        EXPECT_EQ(run(1000), all) << effect;
        EXPECT_EQ(run(all - 1), all) << effect;
        EXPECT_EQ(run(2), 3) << effect;
    }
}

// A pad of 10 Hz settles by 2.5 mm: a base of which nothing leaves it leans by up to twice that.
TEST(Movement, WhatAPadGivesWayIsNoRocking) {
    RigidBody const body({.mass_kg = 138e3, .half_width_m = 1.7, .centre_height_m = 2.9, .inertia_kgm2 = 5e5});
    Pad soft;
    soft.vertical_frequency_hz = 10;
    double const leans_m = 2 * g0 / std::pow(20 * pi, 2);
    auto const ends = [&](double rise_m, Effect effect) {
        Response response;
        response.verdict = Verdict::rocked;
        response.peak_rotation_rad = std::asin(rise_m / 3.4);
        response.effects = mask_of(effect);
        return MovementSpec{}.verdict(response, body, true, soft);
    };
    for (auto const points : {Effect::contact, Effect::spatial}) {
        EXPECT_EQ(ends(leans_m, points), Verdict::at_rest);
        EXPECT_EQ(ends(leans_m + 0.99e-3, points), Verdict::at_rest);
        EXPECT_EQ(ends(leans_m + 1.01e-3, points), Verdict::rocked);
    }
    EXPECT_EQ(ends(1.01e-3, Effect::sliding), Verdict::rocked) << "rigid ground does not give way";
}

// a verdict is explained with the thresholds that the campaign uses, and so is "at rest" of a body that moved.
TEST(Movement, IsExplainedWithItsThresholds) {
    IntensityUnit const mm{"mm", 1e-3};
    MovementSpec const movement{.slip_m = 2e-3, .uplift_m = 5e-4};
    auto const text = [&](Verdict verdict) { return verdict_text(entry_of(verdict), movement, mm); };
    EXPECT_EQ(text(Verdict::at_rest), "slid less than 2 mm, and no edge of its base rose 0.5 mm");
    EXPECT_EQ(text(Verdict::slid), "slid 2 mm or more, and no edge of its base rose 0.5 mm");
    EXPECT_EQ(text(Verdict::rocked),
              "an edge of its base rose 0.5 mm or more; it slid less than 2 mm and stayed upright");
    EXPECT_EQ(text(Verdict::slid_and_rocked),
              "slid 2 mm or more, an edge of its base rose 0.5 mm or more, and it stayed upright");
    EXPECT_EQ(text(Verdict::overturned), "fell over");

    Response response;
    response.verdict = Verdict::at_rest;
    response.peak_slip_m = 0;
    response.peak_rotation_rad = 0;
    EXPECT_EQ(at_rest_text(response, movement, mm), "");
    response.peak_slip_m = 0.744e-3;
    EXPECT_EQ(at_rest_text(response, movement, mm), " (slid less than 2 mm, and no edge of its base rose 0.5 mm)");
    response.verdict = Verdict::slid;
    EXPECT_EQ(at_rest_text(response, movement, mm), "");
}

// R-1003: A body that stands has slid or rocked, or both, from stated distances on, whatever model ran: what a pad
// gives way elastically (3e-5 of alpha under a base of 3.4 m, 0.05 mm) is no rocking.
TEST(Movement, CountsFromStatedDistancesOn) {
    RigidBody const body({.mass_kg = 138e3, .half_width_m = 1.7, .centre_height_m = 2.9, .inertia_kgm2 = 5e5});
    Pad const pad;
    Response response;
    auto const ends = [&](double slip_m, double uplift_m, bool may_slip = true) {
        response.verdict = Verdict::rocked;
        response.peak_slip_m = slip_m;
        response.peak_rotation_rad = std::asin(uplift_m / 3.4);
        return MovementSpec{}.verdict(response, body, may_slip, pad);
    };
    EXPECT_EQ(ends(0.9e-3, 0.05e-3), Verdict::at_rest);
    EXPECT_EQ(ends(1.1e-3, 0.9e-3), Verdict::slid);
    EXPECT_EQ(ends(0.9e-3, 1.1e-3), Verdict::rocked);
    EXPECT_EQ(ends(1.1e-3, 1.1e-3), Verdict::slid_and_rocked);
    EXPECT_EQ(ends(1.1e-3, 1.1e-3, false), Verdict::rocked) << "what holds fast does not slide";
    EXPECT_EQ((MovementSpec{0, 0}.verdict(response, body, true, pad)), Verdict::slid_and_rocked);
    EXPECT_EQ((MovementSpec{2e-3, 2e-3}.verdict(response, body, true, pad)), Verdict::at_rest);
    EXPECT_EQ((MovementSpec{.by_model = true}.verdict(response, body, true, pad)), Verdict::rocked);
    for (auto const other : {Verdict::overturned, Verdict::contact_lost, Verdict::failed}) {
        response.verdict = other;
        EXPECT_EQ((MovementSpec{2e-3, 2e-3}.verdict(response, body, true, pad)), other);
    }
    // Thrown up without turning it has left the ground too; what rotation lifts the centre of gravity is no flight.
    auto const rises = [&](double rise_m, double rotation_rad) {
        response.verdict = Verdict::rocked;
        response.peak_slip_m = 0;
        response.peak_rotation_rad = rotation_rad;
        response.effects = mask_of(Effect::contact);
        return MovementSpec{}.verdict(response, body, true, pad, rise_m);
    };
    double const settled_m = g0 / std::pow(2 * pi * pad.vertical_frequency_hz, 2);
    EXPECT_EQ(rises(1.01e-3 + settled_m, 0), Verdict::rocked);
    EXPECT_EQ(rises(0.99e-3 + settled_m, 0), Verdict::at_rest);
    EXPECT_EQ((MovementSpec{1e-3, 0.5}.verdict(response, body, true, pad, 0.278)), Verdict::at_rest);
    response.peak_rotation_rad = 0.2;
    double const by_rotation_m = 1.7 * std::sin(0.2) - 2.9 * (1 - std::cos(0.2));
    EXPECT_EQ((MovementSpec{1e-3, 1}.verdict(response, body, true, pad, by_rotation_m + 0.99)), Verdict::at_rest);
    EXPECT_EQ((MovementSpec{1e-3, 1}.verdict(response, body, true, pad, by_rotation_m + 1.01)), Verdict::rocked);
    response.verdict = Verdict::at_rest;
    response.peak_slip_m = response.peak_rotation_rad = 0;
    EXPECT_EQ((MovementSpec{0, 0}.verdict(response, body, true, pad)), Verdict::at_rest) << "nothing is no movement";
}

}  // namespace
}  // namespace overturn
