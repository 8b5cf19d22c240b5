// Requirement: the curves and the criterion are made from exactly the rows of a campaign, each over its
// own measure.
#include "results/analysis.hpp"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include "output/curve_text.hpp"
#include "results/detail/criterion_verdict.hpp"
#include "results/statistics.hpp"
#include "support/campaigns.hpp"

namespace overturn {
namespace {

class AnalysisOfRows : public ::testing::Test {
  protected:
    AnalysisOfRows()
        : spec(testing::campaign_from(testing::quick_waves + testing::type_a + testing::type_b
                                      + testing::levels("values=[3,6,9]\ndesign_basis=6\n"))),
          statistics(spec) {}

    void wave(std::int64_t id, double pga, double pgv) {
        WaveRow row;
        row.id = id;
        row.pga_mps2 = pga;
        row.pgv_mps = pgv;
        std::vector<MeasureRow> measures(spec.bodies.size());
        if (spec.measures.both_radius_units) {
            measures[1].other_unit_v_wes_max_mps = 0.1 * pga;
            measures[1].other_unit_ou_v_e_mps = 0.2 * pga;
        }
        statistics.add(row, measures);
    }
    void trial(std::int64_t wave, std::int64_t level, Verdict verdict, double scale, double v_wes) {
        statistics.add(trial_row(wave, level, verdict, scale, v_wes));
    }
    TrialRow trial_row(std::int64_t wave, std::int64_t level, Verdict verdict, double scale, double v_wes) {
        TrialRow row;
        row.wave = wave;
        row.body = 1;
        row.level = level;
        row.amplitude = spec.levels.levels[static_cast<std::size_t>(level)].value;
        row.scale = scale;
        row.verdict = verdict;
        row.v_wes_mps = v_wes;
        row.ou_v_e_mps = 2 * v_wes;
        row.v_ereq_mps = 1.35;
        row.v_wes_safe = v_wes < row.v_ereq_mps ? 1 : 0;
        row.ou_v_e_safe = row.ou_v_e_mps < row.v_ereq_mps ? 1 : 0;
        row.peak_rotation_ratio = verdict == Verdict::at_rest ? 0 : verdict == Verdict::overturned ? 4 : 0.3;
        row.response_velocity_mps = verdict == Verdict::overturned ? row.v_ereq_mps : v_wes / 10;
        row.peak_slip_m = wave % 2 == 0 ? 0.01 : 0;
        return row;
    }
    // 40 waves that fall from a level on which differs from wave to wave.
    void fill() {
        for (int w = 0; w < 40; ++w) {
            wave(w, 2, 0.5 + 0.01 * w);
            for (int level = 0; level < 3; ++level) {
                double const scale = spec.levels.levels[static_cast<std::size_t>(level)].value / 2;
                bool const falls = level >= 1 + w % 3 - (w % 7 == 0 ? 1 : 0);
                trial(w, level, falls ? Verdict::overturned : Verdict::rocked, scale, 0.3 * scale * (1 + 0.01 * w));
            }
        }
    }

    CampaignSpec spec;
    Statistics statistics;
};

TEST_F(AnalysisOfRows, EveryMeasureSeesItsOwnValues) {
    fill();
    auto const& trials = statistics.measured();

    EXPECT_EQ(trials.singles(1, measure_named("pga"))[2].intensity, 9);
    EXPECT_EQ(trials.singles(1, measure_named("pgv"))[5].intensity, 4.5 * 0.51);
    EXPECT_EQ(trials.singles(1, measure_named("v_wes"))[5].intensity, 0.3 * 4.5 * 1.01);
    EXPECT_EQ(trials.singles(1, measure_named("v_wes_ratio"))[5].intensity, 0.3 * 4.5 * 1.01 / 1.35);
    EXPECT_TRUE(trials.singles(0, measure_named("pga")).empty());
}

TEST_F(AnalysisOfRows, LevelsAreStripesAndWavesAreResampled) {
    fill();
    auto const bodies = analyse(spec, statistics, {});
    auto const& levels = bodies[1].over_levels();

    EXPECT_EQ(bodies[0].over_levels().fit.state, FragilityState::no_trials);
    EXPECT_EQ(levels.name, "pga");
    EXPECT_EQ(levels.fit.isotonic.back().to, std::exp(std::log(9.0)));
    EXPECT_EQ(levels.fit.waves, 40);
    EXPECT_EQ(levels.fit.method, FragilityFit::Method::widest) << "of resamples and of ranges of capacities";
    ASSERT_TRUE(levels.fit.identifiable());
    ASSERT_EQ(levels.fit.quotes.size(), 4U);
    EXPECT_EQ(levels.fit.quotes[1].quote.intensity, 9);
    EXPECT_EQ(levels.fit.quotes[1].trials, 40);
}

// What a curve over another measure than the levels' hangs on is said once beneath a table of several.
TEST_F(AnalysisOfRows, CurvesOverOtherMeasuresAreOfTheDesign) {
    fill();
    auto const fits = analyse(spec, statistics, {})[1].fragility;
    auto const all = output::fragility_table(fits, 0.95);
    std::string const said = "note: curves over measures other than pga depend on the scaling levels";

    EXPECT_NE(all.find(said), std::string::npos) << all;
    EXPECT_EQ(all.find(said), all.rfind(said));
    EXPECT_EQ(output::fragility_table({fits.front()}, 0.95).find("measures other"), std::string::npos);
}

/// V_WES and ouV_E are one multiple of each other in these rows: same beta, same rank, medians apart by the factor.
TEST_F(AnalysisOfRows, ProportionalMeasuresGiveTheSameFit) {
    fill();
    auto const body = analyse(spec, statistics, {})[1];
    auto const& wes = body.fragility[2];
    auto const& ou = body.fragility[3];

    EXPECT_EQ(wes.name, "v_wes");
    EXPECT_EQ(ou.name, "ou_v_e");
    EXPECT_NEAR(ou.fit.line->beta(), wes.fit.line->beta(), 1e-9);
    EXPECT_NEAR(ou.fit.line->log_median() - wes.fit.line->log_median(), std::log(2.0), 1e-9);
    EXPECT_EQ(ou.rank_area, wes.rank_area);
}

// R-1104.
TEST_F(AnalysisOfRows, TrialsWithoutVerdictAreReported) {
    fill();
    trial(3, 2, Verdict::contact_lost, 4.5, 1);
    trial(3, 2, Verdict::failed, 0, 0);
    auto const body = analyse(spec, statistics, {})[1];

    for (auto const& measured : body.fragility) {
        EXPECT_EQ(measured.fit.undecided, 2) << measured.name;
        EXPECT_EQ(measured.fit.trials, 120) << measured.name;
    }
}

// T0 and T1 with R in the other unit: curves and criteria of their own beside the first ones, against the same
// V_Ereq.
TEST_F(AnalysisOfRows, TheOtherUnitOfRStandsBeside) {
    spec.measures.both_radius_units = true;
    statistics = Statistics(spec);
    fill();
    auto const body = analyse(spec, statistics, {})[1];

    ASSERT_EQ(body.criterion.size(), 4);
    EXPECT_EQ(body.criterion[0].radius_unit, RadiusUnit::centimetre);
    EXPECT_EQ(body.criterion[2].radius_unit, RadiusUnit::metre);
    EXPECT_EQ(body.criterion[2].measure, measure_named("v_wes_other_unit"));
    auto const& counts = body.criterion[2].study.counts;
    EXPECT_EQ(counts.false_alarm + counts.true_overturn, 0) << "0.1 of 9 m/s2 lies below V_Ereq";
    EXPECT_EQ(counts.false_safe + counts.true_safe, 120);
    EXPECT_EQ(statistics.measured().singles(1, measure_named("ou_v_e_other_unit"))[5].intensity, 4.5 * 0.4);
    ASSERT_EQ(body.fragility.size(), 7);
    EXPECT_EQ(body.fragility[5].label, "v_wes(R in m)");
    // The measures are the level's amplitude in other words, so their curves differ by that factor alone.
    EXPECT_NEAR(std::exp(body.fragility[5].fit.line->log_median()),
                0.1 * std::exp(body.fragility[0].fit.line->log_median()), 1e-9);
}

/// V_resp of what stood is set against V_WES, trials that slipped apart; what never moved has no answer to show.
TEST_F(AnalysisOfRows, ResponsesAreOfWhatMovedAndStood) {
    fill();
    trial(3, 0, Verdict::at_rest, 1, 0.1);
    auto const body = analyse(spec, statistics, {})[1];

    std::int64_t without = 0;
    std::int64_t with = 0;
    std::int64_t overturned = 0;
    for (auto const& bin : body.response) {
        without += bin.without_slip ? bin.without_slip->count : 0;
        with += bin.with_slip ? bin.with_slip->count : 0;
        overturned += bin.overturned;
        if (bin.without_slip) {
            EXPECT_GE(bin.without_slip->lowest, bin.from / 10);
            EXPECT_LT(bin.without_slip->highest, bin.to / 10);
        }
    }
    EXPECT_EQ(without + with + overturned, 120);
    EXPECT_EQ(overturned, body.over_levels().fit.overturned);
    EXPECT_GT(with, 0);
    EXPECT_TRUE(analyse(spec, statistics, {})[0].response.empty());
}

// One trial said safe that fell speaks against the criterion; none speaks for it only if something fell at all.
TEST_F(AnalysisOfRows, TheVerdictFollowsTheCounts) {
    auto const verdict = [&] { return analyse(spec, statistics, {})[1].verdict.value(); };
    wave(0, 2, 1);
    trial(0, 0, Verdict::rocked, 1.5, 1.0);
    EXPECT_EQ(verdict().safety, Safety::nothing_overturned);
    trial(0, 2, Verdict::overturned, 4.5, 3.0);
    EXPECT_EQ(verdict().safety, Safety::few_waves);
    for (std::int64_t w = 100; w < 140; ++w) {
        wave(w, 2, 1);
        trial(w, 0, Verdict::rocked, 1.5, 1.0);
    }
    EXPECT_EQ(verdict().safety, Safety::conservative);
    EXPECT_EQ(verdict().false_alarms, Speaks::neither) << "one alarm";
    trial(0, 1, Verdict::overturned, 3, 1.2);
    EXPECT_EQ(verdict().safety, Safety::false_safe);
    wave(1, 2, 1);
    trial(1, 0, Verdict::at_rest, 1.5, 1.0);
    auto const body = analyse(spec, statistics, {})[1];
    auto const own = std::ranges::find(body.criterion, measure_named("v_wes"), &MeasuredCriterion::measure);
    EXPECT_EQ(own->study.safe_uplifted_but_overturned.of, 42) << "what never left the ground is not counted";
    EXPECT_EQ(own->study.safe_uplifted_but_overturned.count, 1);
    for (std::int64_t w = 2; w < 8; ++w) {
        wave(w, 2, 1);
        trial(w, 2, Verdict::overturned, 4.5, 3.0);
    }
    EXPECT_EQ(verdict().false_alarms, Speaks::in_favour);
    for (std::int64_t w = 8; w < 40; ++w) {
        wave(w, 2, 1);
        trial(w, 2, Verdict::rocked, 4.5, 3.0);
    }
    EXPECT_EQ(verdict().false_alarms, Speaks::against);
}

// A pad yields under a body that slides: it rotates by a little, yet no part of its base leaves the ground.
TEST_F(AnalysisOfRows, ABodyOnAYieldingPadThatOnlySlidDoesNotTestTheCriterion) {
    wave(0, 2, 1);
    auto row = trial_row(0, 0, Verdict::slid, 1.5, 1.0);
    row.peak_rotation_ratio = 2e-5;
    for (auto const effect : {Effect::contact, Effect::spatial}) {
        row.effects = mask_of(Effect::sliding) | mask_of(effect);
        statistics.add(row);
    }
    EXPECT_EQ(analyse(spec, statistics, {})[1].verdict->safety, Safety::none_uplifted);

    row.verdict = Verdict::slid_and_rocked;
    statistics.add(row);
    row.verdict = Verdict::rocked;
    statistics.add(row);
    row.verdict = Verdict::slid;  // on corners whatever rotates has left the ground
    row.effects = mask_of(Effect::sliding);
    statistics.add(row);

    auto const body = analyse(spec, statistics, {})[1];
    auto const v_wes = std::ranges::find(body.criterion, measure_named("v_wes"), &MeasuredCriterion::measure);
    EXPECT_EQ(v_wes->study.safe_uplifted_but_overturned.of, 3);
}

TEST_F(AnalysisOfRows, UntestedSafetyIsReported) {
    wave(0, 2, 1);
    trial(0, 2, Verdict::rocked, 4.5, 3.0);
    EXPECT_EQ(analyse(spec, statistics, {})[1].verdict->safety, Safety::none_predicted_safe);
    trial(0, 0, Verdict::at_rest, 1.5, 1.0);
    EXPECT_EQ(analyse(spec, statistics, {})[1].verdict->safety, Safety::none_uplifted);
}

// Dispersions are compared replicate by replicate; waves matched to one spectrum cannot tell measures apart at
// all.
TEST_F(AnalysisOfRows, DispersionsAreComparedInPairs) {
    fill();
    auto body = analyse(spec, statistics, {})[1];
    body.one_spectrum = false;
    auto const compared = verdict_on(body, 0.95).beside;
    EXPECT_TRUE(std::ranges::any_of(compared, [](auto const& one) { return one.dispersion && one.beta_ratio; }));
    EXPECT_TRUE(std::ranges::any_of(compared, [](auto const& one) { return one.rank.has_value(); }));
    body.one_spectrum = true;
    EXPECT_TRUE(verdict_on(body, 0.95).beside.empty());

    // A measure that is V_WES by another name has a ratio of exactly 1: neither better nor worse.
    body.one_spectrum = false;
    auto const own = std::ranges::find(body.fragility, measure_named("v_wes"), &MeasuredFragility::measure);
    auto const same = std::ranges::find(body.fragility, measure_named("pgv"), &MeasuredFragility::measure);
    same->fit = own->fit;
    auto const beside = verdict_on(body, 0.95).beside;
    auto const one =
        std::ranges::find(beside, static_cast<std::size_t>(same - body.fragility.begin()), &MeasureBeside::curve);
    ASSERT_NE(one, beside.end());
    EXPECT_EQ(one->beta_ratio->lower, 1);
    EXPECT_EQ(one->beta_ratio->upper, 1);
    EXPECT_EQ(one->dispersion, Speaks::neither);
}

}  // namespace
}  // namespace overturn
