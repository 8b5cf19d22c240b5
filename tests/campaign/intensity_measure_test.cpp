// Requirement R-204: every measure is stated once, and levels, curves and columns are those of its entry.
#include "campaign/intensity_measure.hpp"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "campaign/block_rows.hpp"
#include "campaign/rows.hpp"
#include "motion/cumulative_velocity.hpp"
#include "results/analysis.hpp"
#include "results/schema.hpp"
#include "results/statistics.hpp"
#include "support/campaign_rows.hpp"
#include "support/campaigns.hpp"
#include "support/expect_input_error.hpp"
#include "support/tolerance.hpp"

namespace overturn {
namespace {

using testing::campaign_from;
using testing::near;
using testing::rows_of;

std::set<std::string> names_in(store::TableSpec const& table) {
    std::set<std::string> names;
    for (auto const& column : table.columns) {
        names.insert(column.name);
    }
    return names;
}

// Files hold numbers beside names: those that were given are never given again.
TEST(IntensityMeasures, KeepTheirNumbersInFiles) {
    std::vector<std::string> const given{"pga",
                                         "pgv",
                                         "v_wes",
                                         "ou_v_e",
                                         "v_wes_ratio",
                                         "level",
                                         "v_wes_other_unit",
                                         "ou_v_e_other_unit",
                                         "sa_average",
                                         "sa_1",
                                         "sa_2",
                                         "sa_3",
                                         "sa_4",
                                         "pgd",
                                         "vector_pga",
                                         "cav",
                                         "standardised_cav",
                                         "factor"};
    for (std::size_t number = 0; number < given.size(); ++number) {
        EXPECT_EQ(measure_named(given[number])->number, static_cast<std::int64_t>(number)) << given[number];
    }
}

TEST(IntensityMeasures, HaveUnitsOfTheirOwnAndOnlySaHasAPeriod) {
    auto const units = [](char const* name) { return measure_named(name)->units(); };
    EXPECT_EQ(units("pga"), "m/s2");
    EXPECT_EQ(units("vector_pga"), "m/s2");
    EXPECT_EQ(units("pgd"), "m");
    EXPECT_EQ(units("cav"), "m/s");
    EXPECT_EQ(units("v_wes_ratio"), "1");
    EXPECT_EQ(units("factor"), "1");
    for (auto const& entry : intensity_measures) {
        EXPECT_EQ(entry.period.has_value(), entry.name.starts_with("sa_") && entry.name != "sa_average") << entry.name;
    }
    for (std::size_t i = 0; i < most_sa_periods; ++i) {
        EXPECT_EQ(sa_measure(i)->name, fmt::format("sa_{}", i + 1));
    }
}

// Columns of measures say what their entries say. "level" is the number of one; those of Sa leave the period to the
// campaign.
TEST(IntensityMeasures, HaveColumnsOfTheirUnitAndMeaning) {
    std::set<std::string> checked;
    for (auto const* const fields : {&fields_of<WaveRow>(), &fields_of<MeasureRow>(), &fields_of<TrialRow>()}) {
        for (auto const& field : *fields) {
            auto const* const measure = std::ranges::find(intensity_measures, field.name, &IntensityMeasure::name);
            if (measure != intensity_measures.end() && field.name != "level" && !measure->period) {
                EXPECT_EQ(field.units, measure->units()) << field.name;
                EXPECT_TRUE(field.description.starts_with(measure->meaning)) << field.name << ": " << field.description;
                checked.insert(field.name);
            }
        }
    }
    for (auto const* const name : {"pga", "pgv", "pgd", "vector_pga", "sa_average", "v_wes", "ou_v_e",
                                   "v_wes_other_unit", "ou_v_e_other_unit", "cav", "standardised_cav"}) {
        EXPECT_TRUE(checked.contains(name)) << name;
    }
}

// Each entry reads its own column.
TEST(IntensityMeasures, AreTakenOfTheirOwnColumns) {
    WaveRow wave;
    MeasureRow of_body;
    TrialRow trial;
    wave.pga_mps2 = 2;
    wave.pgv_mps = 3;
    wave.pgd_m = 4;
    wave.vector_pga_mps2 = 5;
    wave.sa_average_mps2 = 6;
    wave.sa_mps2 = {7, 8, 9, 10};
    wave.measured = {11, 12};
    of_body.other_unit_v_wes_max_mps = 13;
    of_body.other_unit_ou_v_e_mps = 14;
    trial.v_wes_mps = 15;
    trial.ou_v_e_mps = 16;
    trial.v_ereq_mps = 60;
    trial.amplitude = 17;
    trial.measured = {18};
    std::vector<std::pair<char const*, double>> const of_waves{
        {"pga", 2},   {"pgv", 3},  {"pgd", 4},   {"vector_pga", 5}, {"sa_average", 6},        {"sa_1", 7},
        {"sa_2", 8},  {"sa_3", 9}, {"sa_4", 10}, {"cav", 11},       {"v_wes_other_unit", 13}, {"ou_v_e_other_unit", 14},
        {"factor", 1}};
    for (auto const& [name, value] : of_waves) {
        EXPECT_EQ(unscaled(measure_named(name), wave, of_body), value) << name;
    }
    std::vector<std::pair<char const*, double>> const of_trials{
        {"v_wes", 15}, {"ou_v_e", 16}, {"v_wes_ratio", 0.25}, {"level", 17}, {"standardised_cav", 18}};
    for (auto const& [name, value] : of_trials) {
        EXPECT_EQ(of_trial(measure_named(name), trial), value) << name;
    }
    EXPECT_EQ(of_waves.size() + of_trials.size(), intensity_measures.size());
}

//
TEST(IntensityMeasures, LevelsByCavAreThatOfTheScaledWave) {
    auto const spec =
        campaign_from(testing::quick_waves + testing::type_b + "[levels]\nmeasure='cav'\nvalues=[4, '800 cm/s']\n");
    EXPECT_EQ(spec.levels.text(8), "800 cm/s");
    auto const block = rows_of(spec);
    for (auto const& trial : block.trials.rows) {
        auto motion = spec.source->make(spec.seed, static_cast<std::uint64_t>(trial.wave)).motion;
        for (double& a : motion.horizontal_mps2) {
            a *= trial.scale;
        }
        EXPECT_TRUE(near(cav_mps(motion.horizontal_mps2, motion.time_step_s), trial.amplitude, testing::exact_formula));
    }
    auto const waves = names_in(wave_table(spec));
    EXPECT_TRUE(waves.contains("cav") && waves.contains("standardised_cav"));
    EXPECT_FALSE(names_in(trial_table(spec)).contains("standardised_cav")) << "nobody asked for it";

    Statistics statistics(spec);
    statistics.add(block);
    auto const fits = analyse(spec, statistics, {.confidence = 0.95, .replicates = 20}).front().fragility;
    EXPECT_EQ(fits.front().name, "cav");
    EXPECT_EQ(fits.front().title, "CAV");
    EXPECT_EQ(fits.front().units, "m/s");
    EXPECT_EQ(fits[1].name, "pga");
}

// Its windows are those of the scaled wave, so that it is of no use to scale by and has a column of its own.
TEST(IntensityMeasures, CurvesOverStandardisedCavAreOfTheScaledWave) {
    auto const spec = campaign_from(testing::quick_waves + testing::type_b + testing::levels("values=[0.3, 6]\n")
                                    + "[measures]\ncurves=['standardised_cav', 'cav']\n");
    auto const block = rows_of(spec);
    Statistics statistics(spec);
    statistics.add(block);
    auto const standardised = statistics.measured().singles(0, measure_named("standardised_cav"));
    auto const plain = statistics.measured().singles(0, measure_named("cav"));
    ASSERT_EQ(standardised.size(), block.trials.rows.size());
    ASSERT_EQ(plain.size(), block.trials.rows.size());
    for (std::size_t t = 0; t < plain.size(); ++t) {
        auto const& trial = block.trials.rows[t];
        auto const motion = spec.source->make(spec.seed, static_cast<std::uint64_t>(trial.wave)).motion;
        EXPECT_EQ(standardised[t].intensity,
                  standardised_cav_mps(motion.horizontal_mps2, motion.time_step_s, trial.scale));
        EXPECT_TRUE(near(plain[t].intensity, trial.scale * cav_mps(motion.horizontal_mps2, motion.time_step_s),
                         testing::rounding));
        EXPECT_LT(standardised[t].intensity, plain[t].intensity) << "waves begin and end below 0.025 g";
    }
    EXPECT_GT(standardised[1].intensity / standardised[0].intensity, 1.5 * 6 / 0.3) << "more windows count";
    EXPECT_TRUE(names_in(trial_table(spec)).contains("standardised_cav"));

    std::vector<std::string> names;
    auto const fits = analyse(spec, statistics, {.confidence = 0.95, .replicates = 20}).front().fragility;
    for (auto const& fit : fits) {
        names.push_back(fit.name);
    }
    EXPECT_EQ(names,
              (std::vector<std::string>{"pga", "pgv", "cav", "standardised_cav", "v_wes", "ou_v_e", "v_wes_ratio"}));
}

// What is asked for changes no other number.
TEST(IntensityMeasures, CurvesChangeNoTrial) {
    auto const text = testing::quick_waves + testing::type_b + testing::levels("values=[3, 9]\n");
    auto const plain = rows_of(campaign_from(text));
    auto const more = rows_of(campaign_from(text + "[measures]\ncurves=['standardised_cav', 'pgd', 'vector_pga']\n"));
    ASSERT_EQ(plain.trials.rows.size(), more.trials.rows.size());
    for (std::size_t t = 0; t < plain.trials.rows.size(); ++t) {
        EXPECT_EQ(differing(plain.trials.rows[t], more.trials.rows[t]), std::vector<std::string>{"standardised_cav"});
    }
    for (std::size_t w = 0; w < plain.waves.size(); ++w) {
        EXPECT_TRUE(same_bits(plain.waves[w], more.waves[w]));
    }
}

TEST(IntensityMeasures, BadOnesAreRefusedWithTheirPlace) {
    auto const with = [](std::string const& levels, std::string const& measures) {
        return
            [=] { (void)campaign_from(testing::quick_waves + testing::type_b + levels + "[measures]\n" + measures); };
    };
    auto const pga = testing::levels("values=[6]\n");
    testing::expect_input_error(with("[levels]\nmeasure='standardised-cav'\nvalues=[6]\n", ""), "measure", "cav");
    testing::expect_input_error(with(pga, "curves=['cav', 'cav']\n"), "measures.curves", "'cav' twice");
    testing::expect_input_error(with(pga, "curves=['cavv']\n"), "measures.curves", "Did you mean 'cav'?");
    testing::expect_input_error(with(pga, "curves=['v_wes']\n"), "measures.curves", "v_wes");
}

}  // namespace
}  // namespace overturn
