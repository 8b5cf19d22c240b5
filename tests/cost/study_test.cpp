// Requirement R-904: a study distinguishes a coarse setting from a fine one on real waves, repeats in all but times,
// and is read back from its file as it was.
#include "cost/study.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "cost/bench.hpp"
#include "cost/study_output.hpp"
#include "store/results_file.hpp"
#include "support/bit_equal.hpp"
#include "support/campaigns.hpp"
#include "support/expect_input_error.hpp"
#include "support/temporary_folder.hpp"

namespace overturn::cost {
namespace {

using testing::input_from;

std::string const text =
    testing::quick_waves + testing::type_a + testing::type_b + testing::levels("values=[5,6,7,8,9,10]\n");

// Every trial of the campaign's waves, made once, with other settings of its accuracy.
struct AllTrials {
    CampaignInput input = input_from(text);
    CampaignSpec spec = parse_campaign(input);
    Plan plan{spec};
    std::vector<PreparedWave> waves;

    AllTrials() {
        PhaseSeconds ignored;
        for (std::int64_t wave = 0; wave < plan.waves(); ++wave) {
            waves.push_back(prepare_wave(spec, plan, wave, ignored));
        }
    }
    [[nodiscard]] auto rows(std::vector<std::string> const& settings) const {
        return run_trials(parse_campaign(with(input, settings)), plan, waves).rows;
    }
};

// Without step control a step is a wave sample for every order, and truncation falls with the order: Taylor's
// theorem.
TEST(Bench, HigherOrderErrsLess) {
    AllTrials const trials;
    auto const reference = trials.rows(reference_settings());
    double last = 1;
    for (char const* order : {"4", "6", "8"}) {
        auto const found = compare(
            trials.rows({std::string("accuracy.taylor_order=") + order, "accuracy.step_tolerance=1e-3"}), reference);
        ASSERT_GE(found.peak.count, 10) << "too few trials rock for this to mean anything";
        EXPECT_LT(found.peak.median, last) << "order " << order;
        last = found.peak.median;
    }
    EXPECT_LT(last, 1e-9);
}

// why order, sub-steps, step_tolerance and settle are constants: what other values of them change, against the
// reference, on every trial of three waves.
TEST(Bench, ConstantsOfTheIntegrationChangeNextToNothing) {
    AllTrials const trials;
    auto const reference = trials.rows(reference_settings());
    for (std::string const setting :
         {"substeps=1", "substeps=2", "substeps=4", "taylor_order=10", "taylor_order=12", "step_tolerance=1e-3",
          "step_tolerance=1e-7", "step_tolerance=1e-13", "settle=1e-2", "settle=1e-4", "settle=1e-7"}) {
        auto const found = compare(trials.rows({"accuracy." + setting}), reference);
        ASSERT_GE(found.peak.count, 10) << "too few trials rock for this to mean anything";
        EXPECT_EQ(found.flips, 0) << setting;
        EXPECT_LT(found.peak.median, 1e-12) << setting;
        EXPECT_LT(found.peak.worst, 1e-6) << setting;
        RecordProperty("median " + setting, fmt::format("{:.2g}", found.peak.median));
        RecordProperty("worst " + setting, fmt::format("{:.2g}", found.peak.worst));
    }
}

TEST(Bench, RunsWhatACampaignRuns) {
    auto const spec = parse_campaign(input_from(text));
    Plan const plan(spec);
    PhaseSeconds ignored;
    std::vector<PreparedWave> const waves{prepare_wave(spec, plan, 0, ignored), prepare_wave(spec, plan, 2, ignored)};
    auto const run = run_trials(spec, plan, waves);

    ASSERT_EQ(run.units, 2 * plan.trials_per_wave());
    for (std::size_t i = 0; i < run.rows.size(); ++i) {
        auto const& at = run.rows[i];
        auto const alone =
            run_trial(spec, waves[i / static_cast<std::size_t>(plan.trials_per_wave())], at.body, at.level)
                .rows.front();
        EXPECT_TRUE(testing::bit_equal(at, alone)) << "trial " << i;
    }
}

TEST(Bench, SamplesAreSpreadOverTheCampaign) {
    EXPECT_EQ(spread_over(4, 8), (std::vector<std::int64_t>{0, 2, 4, 6}));
    EXPECT_EQ(spread_over(3, 10), (std::vector<std::int64_t>{0, 3, 6}));
    EXPECT_EQ(spread_over(9, 2), (std::vector<std::int64_t>{0, 1}));
}

// the answer names the value that changes most verdicts; without any, the one of the largest error.
TEST(Advice, NamesTheSettingThatMattersMost) {
    auto const row = [](char const* label, double error, std::int64_t flips) {
        Measured measured;
        measured.setting.label = label;
        measured.error.p95 = error;
        measured.trials = 40;
        measured.flips = flips;
        return measured;
    };
    auto const knob = [](char const* name, std::optional<std::size_t> here, std::vector<Measured> rows) {
        KnobResult result;
        result.knob.name = name;
        result.knob.here = here;
        result.rows = std::move(rows);
        return result;
    };
    auto effects = knob("effects", 1, {row("none", 0.1, 9), row("auto", 1e-9, 2)});
    auto step = knob("contact_step", 0, {row("0.3", 0.2, 3), row("0.1", 0.01, 1)});
    auto const unset = knob("periods", std::nullopt, {row("10", 1, 40)});  // no key sets it
    EXPECT_EQ(largest_effect({effects, step, unset}),
              "Largest effect of a setting: effects = none changes 9 of 40 verdicts; the campaign's auto changes 2.");
    EXPECT_EQ(largest_effect({step}),
              "Largest effect of a setting: contact_step = 0.3 changes 3 of 40 verdicts; it is the campaign's value.");
    for (auto* result : {&effects, &step}) {
        for (auto& each : result->rows) {
            each.flips = 0;
        }
    }
    EXPECT_EQ(largest_effect({effects, step}),
              "No value of any setting changes a verdict (40 trials). Largest error: contact_step = 0.3, 95 % error "
              "2.0e-01, 0 of 40 verdicts change.");
    EXPECT_EQ(largest_effect({unset}), "");
}

class StudyOfThree : public ::testing::Test {
  protected:
    static Study const& study() {
        static Study const once = run_study(input_from(text), {.waves = 3, .timing_s = 0}, [](double, double) {});
        return once;
    }
    static KnobResult const& knob(std::string const& name) {
        for (auto const& result : study().knobs) {
            if (result.knob.name == name) {
                return result;
            }
        }
        throw std::logic_error(name);
    }
};

//
TEST_F(StudyOfThree, EveryKnobHasAFrontAndErrorsShrink) {
    EXPECT_EQ(study().waves, 3);
    EXPECT_EQ(study().trials, 36);
    for (auto const& result : study().knobs) {
        std::int64_t on_front = 0;
        for (auto const& row : result.rows) {
            on_front += row.on_front ? 1 : 0;
            EXPECT_GT(row.seconds, 0) << result.knob.name;
        }
        EXPECT_GT(on_front, 0) << result.knob.name;
        EXPECT_FALSE(result.advice.empty());
    }
    auto const& quadrature = knob("ou_v_e").rows;
    EXPECT_GT(quadrature.front().error.median, 100 * quadrature[3].error.median);  // 40 rad against 25
    auto const& spectrum = knob("spectrum_periods").rows;
    EXPECT_GT(spectrum.front().error.median, 5 * spectrum.back().error.median);
}

/// The defaults are one run: what a knob says at its own position is what the study says of the defaults.
TEST_F(StudyOfThree, TheOwnPositionIsTheDefaults) {
    for (char const* name : {"effects"}) {
        auto const& result = knob(name);
        ASSERT_TRUE(result.knob.here.has_value()) << name;
        auto const& own = result.rows[*result.knob.here];
        EXPECT_EQ(own.flips, study().defaults.flips) << name;
        EXPECT_EQ(own.error.worst, study().defaults.peak.worst) << name;
    }
}

TEST_F(StudyOfThree, MoreWavesNarrowTheInterval) {
    auto const& subsets = study().sampling.subsets;
    ASSERT_EQ(subsets.size(), 2U);
    EXPECT_EQ(subsets[0].waves, 1);
    EXPECT_EQ(subsets[1].waves, 3);
    EXPECT_LT(subsets[1].width, subsets[0].width);
    EXPECT_DOUBLE_EQ(subsets[0].root_n_width, subsets[1].width * std::sqrt(3.0));
    // All of the campaign's waves are in the sample, so what is foretold is what was found.
    EXPECT_DOUBLE_EQ(study().sampling.half_width, subsets[1].width / 2);
}

TEST_F(StudyOfThree, RepeatsInAllButTimes) {
    auto const again = run_study(input_from(text), {.waves = 3, .timing_s = 0}, [](double, double) {});
    ASSERT_EQ(again.knobs.size(), study().knobs.size());
    for (std::size_t k = 0; k < again.knobs.size(); ++k) {
        for (std::size_t i = 0; i < again.knobs[k].rows.size(); ++i) {
            auto const& a = again.knobs[k].rows[i];
            auto const& b = study().knobs[k].rows[i];
            EXPECT_EQ(a.setting.label, b.setting.label);
            EXPECT_EQ(a.error.count, b.error.count);
            EXPECT_EQ(a.error.worst, b.error.worst);
            EXPECT_EQ(a.flips, b.flips);
        }
    }
    EXPECT_EQ(again.sentence, study().sentence);
}

//
TEST_F(StudyOfThree, ReportsBasesWithoutPoints) {
    constexpr auto told = "there is no number of points to vary";
    EXPECT_EQ(study_text(study()).find(told), std::string::npos);
    auto const round =
        testing::quick_waves + testing::type_b + "base={shape='round'}\n" + testing::levels("values=[4]\n");
    auto const of_rim = run_study(input_from(round), {.waves = 1, .timing_s = 0}, [](double, double) {});
    EXPECT_NE(study_text(of_rim).find(told), std::string::npos);
}

TEST_F(StudyOfThree, FileHoldsWhatWasFound) {
    testing::TemporaryFolder const folder;
    write_study(folder / "cost.h5", input_from(text), study());

    testing::expect_input_error([&] { store::ResultsReader const wrong(folder / "cost.h5"); }, "not a results file");
    store::ResultsReader const file(folder / "cost.h5", store::Trust::sealed, format_name);
    for (auto const& result : study().knobs) {
        auto const group = "settings/" + result.knob.name + "/";
        auto const times = file.reals(group + "cpu");
        auto const errors = file.reals(group + "error_p95");
        auto const flips = file.integers(group + "flips");
        ASSERT_EQ(times.size(), result.rows.size());
        EXPECT_EQ(file.text_attribute(group + "cpu", "units"), "s");
        EXPECT_FALSE(file.text_attribute(group + "error_p95", "description").empty());
        for (std::size_t i = 0; i < times.size(); ++i) {
            EXPECT_EQ(times[i], result.rows[i].seconds);
            EXPECT_EQ(errors[i], result.rows[i].error.p95);
            EXPECT_EQ(flips[i], result.rows[i].flips);
            EXPECT_EQ(file.integers(group + "setting")[i], static_cast<std::int64_t>(i));
            EXPECT_EQ(file.integers(group + "here")[i], result.knob.here == i ? 1 : 0);
        }
    }
    auto const& quantities = study().step_error.quantities;
    auto const medians = file.reals("step_error/step_median");
    auto const rounded = file.reals("step_error/last_bit_p95");
    ASSERT_GE(quantities.size(), 5U);
    ASSERT_EQ(medians.size(), quantities.size());
    for (std::size_t i = 0; i < medians.size(); ++i) {
        EXPECT_EQ(medians[i], quantities[i].step.median);
        EXPECT_EQ(rounded[i], quantities[i].rounding.p95);
        EXPECT_EQ(file.integers("step_error/step_count")[i], quantities[i].step.count);
    }
    EXPECT_EQ(file.integers("waves/waves"), (std::vector<std::int64_t>{1, 3}));
    EXPECT_EQ(file.texts("study/sentence"), std::vector{study().sentence});
}

}  // namespace
}  // namespace overturn::cost
