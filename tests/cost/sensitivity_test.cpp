// Requirement R-906: what an assumed number does to a probability is reported under the same waves, with what chance
// makes of nothing beside it; a number without influence is seen to have none.
#include "cost/sensitivity.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "campaign/trial.hpp"
#include "cost/detail/varied_inputs.hpp"
#include "output/json.hpp"
#include "support/campaigns.hpp"
#include "support/expect_input_error.hpp"

namespace overturn::cost {
namespace {

using testing::input_from;

// Sixteen waves of noise, no two of one PGA, at factors of them: P(uplift) rises from 0 to 1. (What passes its
// threshold by a thousandth rotates by 1e-10 alpha.)
std::string const text =
    "[waves]\nsource='spectrum-compatible'\ncount=16\nduration='20.48 s'\ntime_step='0.02 s'\nmatch='none'\n"
    "[waves.target]\nspectrum='mlit-ch1'\ntime_scale=0.632\n"
    "[waves.envelope]\nshape='jennings'\nrise='2 s'\nlevel_end='10 s'\nend={value='18 s', basis='assumed'}\n"
    "[[bodies]]\nname='b'\nmass={value='12.6 t', basis='assumed'}\ninertia='uniform-block'\n"
    "base_width={value=0.9, basis='assumed', range=[0.8, '1.00 m']}\n"
    "centre_height={value='1.045 m', basis='assumed'}\n"
    "restitution={value='housner', basis='assumed'}\n"
    "[levels]\nmeasure='factor'\nvalues=[0.6, 0.8, 0.9, 1.1, 1.2, 1.4]\ndesign_basis={value=1, basis='published'}\n"
    "[[limits]]\nname='uplift'\nquantity='peak_rotation_ratio'\nabove=1e-15\n";
constexpr std::size_t uplift = 1;

class SensitivityOfUplift : public ::testing::Test {
  protected:
    static Sensitivity const& study() {
        static Sensitivity const once = study_sensitivity(input_from(text), 0, [](double, double) {});
        return once;
    }
    static SensitivityRow const& row(std::string const& key, std::size_t limit = uplift) {
        for (auto const& row : study().rows) {
            if (row.limit == limit && study().inputs[row.input].keys.front() == key) {
                return row;
            }
        }
        throw std::logic_error(key);
    }
    // A rigid block leaves the ground where the acceleration passes g b/h (Housner 1963).
    struct Uplifts {
        std::vector<bool> any;  // wave by wave, level by level
        std::int64_t at_design_basis = 0;
    };
    static Uplifts uplifts(double width_m, double height_m) {
        auto const spec = parse_campaign(input_from(text));
        Plan const plan(spec);
        PhaseSeconds ignored;
        Uplifts found;
        for (std::int64_t wave = 0; wave < plan.waves(); ++wave) {
            double const pga = prepare_wave(spec, plan, wave, ignored).intensity.pga_mps2;
            for (auto const& level : spec.levels.levels) {
                bool const up = level.value * pga > g0 * 0.5 * width_m / height_m;
                found.any.push_back(up);
                found.at_design_basis += up && level.value == 1 ? 1 : 0;
            }
        }
        return found;
    }
    static void expect_closed_form(Shift const& shift, double width_m, double height_m) {
        auto const before = uplifts(0.9, 1.045);
        auto const after = uplifts(width_m, height_m);
        std::int64_t newly = 0;
        std::int64_t no_longer = 0;
        for (std::size_t t = 0; t < before.any.size(); ++t) {
            newly += after.any[t] && !before.any[t] ? 1 : 0;
            no_longer += before.any[t] && !after.any[t] ? 1 : 0;
        }
        EXPECT_EQ(shift.compared, static_cast<std::int64_t>(before.any.size()));
        EXPECT_EQ(shift.passed, newly);
        EXPECT_EQ(shift.no_longer, no_longer);
        EXPECT_GT(newly + no_longer, 0) << "nothing to tell by";
        EXPECT_EQ(shift.at_design_basis.passed, after.at_design_basis);
        EXPECT_EQ(shift.design_passed - shift.design_no_longer, after.at_design_basis - before.at_design_basis);
        // A lower threshold spares no wave that a higher one does not: all that differ go one way.
        auto const differ = static_cast<int>(std::abs(after.at_design_basis - before.at_design_basis));
        EXPECT_NEAR(shift.design_p_value, std::min(1.0, std::ldexp(1.0, 1 - differ)), 1e-12);
    }
};

TEST_F(SensitivityOfUplift, FollowsTheClosedForm) {
    expect_closed_form(*row("bodies[0].base_width").ends[0], 0.8, 1.045);
    expect_closed_form(*row("bodies[0].base_width").ends[1], 1.0, 1.045);
    expect_closed_form(*row("bodies[0].centre_height").ends[0], 0.9, 0.9 * 1.045);
    expect_closed_form(*row("bodies[0].centre_height").ends[1], 0.9, 1.1 * 1.045);
}

/// The threshold is linear in b/h, and so is the median of a curve over factors of the same waves, up to what the
/// levels resolve.
TEST_F(SensitivityOfUplift, MovesTheMedianAsTheThreshold) {
    for (std::size_t end : {0U, 1U}) {
        auto const& shift = *row("bodies[0].base_width").ends.at(end);
        double const expected = end == 0 ? 0.8 / 0.9 : 1.0 / 0.9;
        ASSERT_TRUE(shift.median_ratio.has_value());
        EXPECT_NEAR(*shift.median_ratio, expected, 0.05);
        EXPECT_TRUE(shift.resolved());
        EXPECT_LT(shift.median_interval->lower, expected);
        EXPECT_GT(shift.median_interval->upper, expected);
    }
    auto const told = sensitivity_text(study());  // the answer stands above the tables
    EXPECT_LT(told.find("Largest effect: bodies[0]."), told.find("Each assumed value")) << told;
}

/// of two waves to a target one that moves alone may not be distinguishable from chance as two of their own
/// could.
TEST_F(SensitivityOfUplift, CountsTargetsWhereWavesShareThem) {
    auto varying = text;
    varying.replace(varying.find("match='none'"), 12, "match='each'\nmatch_tolerance=0.3");
    varying.insert(varying.find("[[bodies]]"), "[waves.variability]\nsigma=0.05\ncorrelation='none'\nper_target=8\n");
    auto const of_targets = study_sensitivity(input_from(varying), 0, [](double, double) {});
    bool any = false;
    for (auto const& row : of_targets.rows) {
        for (auto const& end : row.ends) {
            EXPECT_GE(end ? end->design_p_value : 1, 0.5) << "two targets: 2 / 2^2";
            any = any || (end && end->design_passed + end->design_no_longer > 2);
        }
    }
    EXPECT_TRUE(any) << "nothing to tell by";
}

TEST_F(SensitivityOfUplift, MassHasNone) {
    for (auto const& end : row("bodies[0].mass").ends) {
        EXPECT_EQ(end->flips(), 0);
        EXPECT_EQ(end->median_ratio, 1.0);
        EXPECT_EQ(end->median_interval->lower, 1);
        EXPECT_EQ(end->median_interval->upper, 1);
        EXPECT_EQ(end->design_p_value, 1);
        EXPECT_FALSE(end->resolved());
    }
    EXPECT_NE(sensitivity_text(study()).find("No verdict changes with: bodies[0].mass.\n"), std::string::npos);
}

// Levels between which all waves change their verdict hold no median: neither "+0.0 %" nor an interval of no width.
TEST_F(SensitivityOfUplift, IsNotResolvedByCoarseLevels) {
    auto coarse = text;
    std::string const levels = "[0.6, 0.8, 0.9, 1.1, 1.2, 1.4]";
    coarse.replace(coarse.find(levels), levels.size(), "[0.01, 100]");
    coarse.replace(coarse.find("value=1, "), 9, "value=0.01, ");
    auto const found = study_sensitivity(input_from(coarse), 0, [](double, double) {});
    ASSERT_FALSE(found.rows.empty());
    for (auto const& row : found.rows) {
        for (auto const& end : row.ends) {
            if (row.limit == uplift && end) {
                EXPECT_TRUE(end->levels_too_coarse);
                EXPECT_FALSE(end->median_ratio.has_value());
                EXPECT_FALSE(end->median_interval.has_value());
                EXPECT_EQ(end->flips(), 0) << "as where nothing is moved";
            }
        }
    }
    EXPECT_FALSE(found.unmoved.at(uplift).median.has_value());
    auto const told = sensitivity_text(found);
    EXPECT_NE(told.find("median not resolved: coarse levels"), std::string::npos) << told;
    EXPECT_NE(told.find("  not resolved: coarse levels"), std::string::npos) << told;
    EXPECT_NE(told.find("State more levels."), std::string::npos) << told;
    EXPECT_EQ(told.find("+0.0 %"), std::string::npos) << told;
    // Of the first campaign's levels four have both outcomes.
    EXPECT_EQ(sensitivity_text(study()).find("coarse levels"), std::string::npos);
    EXPECT_FALSE(row("bodies[0].base_width").ends.front()->levels_too_coarse);
}

/// What moves the median most comes first, and every end is reported as it would be written.
TEST_F(SensitivityOfUplift, IsReportedWithItsSize) {
    auto const json = output::json_of(sensitivity_tables(study()));
    std::vector<double> moves;
    for (auto const& row : json["rows"]) {
        if (row["limit"] == "uplift") {
            auto const move = std::abs(std::log(row["median_ratio"].get<double>()));
            if (row["end"] == "low") {
                moves.push_back(move);
            } else {
                moves.back() = std::max(moves.back(), move);
            }
        }
    }
    ASSERT_EQ(moves.size(), 4U);
    EXPECT_TRUE(std::ranges::is_sorted(moves, std::greater{}));
    auto const& input = study().inputs[row("bodies[0].mass").input];
    EXPECT_EQ(input.ends, (std::array<std::string, 2>{"11.34 t", "13.86 t"}));
    EXPECT_EQ(study().inputs[row("bodies[0].base_width").input].ends, (std::array<std::string, 2>{"0.8", "1.00 m"}));
    ASSERT_EQ(json["not_moved"].size(), 1U);
    EXPECT_EQ(json["not_moved"][0]["key"], "bodies[0].restitution");
}

/// Only the shape of waves can differ, never their draws: the same study twice is the same to the last digit.
TEST_F(SensitivityOfUplift, IsPure) {
    auto const again = study_sensitivity(input_from(text), 0, [](double, double) {});

    EXPECT_EQ(output::json_of(sensitivity_tables(again)).dump(), output::json_of(sensitivity_tables(study())).dump());
}

TEST(Sensitivity, ReplacesTheValueWhereItStands) {
    auto const input = input_from(
        "title='\u00e9\u00e9'\n" + testing::quick_waves
            + "[[bodies]]\nfile='b.toml'\n[levels]\nmeasure='pga'\nvalues=[5] # \u00e9\n"
              "design_basis={value='600 gal', basis='assumed'} # here\n",
        {{"b.toml", "mass=1\nbase_width={basis='assumed', value='90 cm'}\ncentre_height=1\ninertia=1\n"}});
    auto const spec = parse_campaign(input);
    for (auto const& value : spec.inputs) {
        if (value.key == "bodies[0].base_width") {
            EXPECT_EQ(with_value(input, value, "80 cm").files.at("b.toml"),
                      "mass=1\nbase_width={basis='assumed', value='80 cm'}\ncentre_height=1\ninertia=1\n");
        } else if (value.key == "levels.design_basis") {
            EXPECT_NE(with_value(input, value, "5.4").text.find("design_basis={value=5.4, basis='assumed'} # here\n"),
                      std::string::npos);
        }
    }
}

TEST(Sensitivity, AnImpossibleEndIsReportedAsRefused) {
    auto const study = study_sensitivity(input_from(testing::quick_waves + testing::type_b
                                                    + "friction={static={value=0.5, basis='assumed'}, kinetic=0.48}\n"
                                                    + testing::levels("values=[5]\n")),
                                         2, [](double, double) {});

    ASSERT_EQ(study.inputs.size(), 1U);
    EXPECT_NE(study.inputs[0].refused[0].find("0.48 above static 0.45"), std::string::npos)
        << study.inputs[0].refused[0];
    EXPECT_EQ(study.inputs[0].refused[1], "");
    EXPECT_FALSE(study.rows.front().ends[0].has_value());
    EXPECT_NE(sensitivity_text(study).find("refused: "), std::string::npos);
}

// Where nothing was changed, or no median is known, the first sentence does not say that nothing has an effect.
TEST(Sensitivity, WhatWasNotChangedHasNoKnownEffect) {
    auto const first_line = [](std::string const& campaign) {
        auto const told = sensitivity_text(study_sensitivity(input_from(campaign), 2, [](double, double) {}));
        return told.substr(told.find('\n') + 1, 60);
    };
    auto const one = testing::quick_waves + testing::type_b + testing::levels("values=[0.1]\n");
    EXPECT_EQ(first_line(one).rfind("No value is marked as assumed: none was changed.", 0), 0U) << first_line(one);

    auto word = one;
    word.insert(word.find("[levels]"), "restitution={value='housner', basis='assumed'}\n");
    EXPECT_EQ(first_line(word).rfind("No assumed value was changed; the reasons are below.", 0), 0U)
        << first_line(word);

    auto resting = one;
    resting.insert(resting.find("[levels]"), "friction={value=0.9, basis='assumed'}\n");
    EXPECT_EQ(first_line(resting).rfind("The effect of assumed values on medians is not known: 2", 0), 0U)
        << first_line(resting);
}

// From tan(alpha) = 0.4306 to 1.15 of it a body slides and rocks at once: there friction is moved, stated or not.
TEST(Sensitivity, FrictionNearTheSlopeIsMovedWhateverItsSource) {
    auto const moves = [](std::string const& friction) {
        auto with = text;
        with.insert(with.find("restitution="), "friction=" + friction + "\n");
        auto const found = varied_inputs(parse_campaign(input_from(with))).inputs;
        return std::ranges::any_of(
            found, [](VariedInput const& input) { return input.keys.front().starts_with("bodies[0].friction"); });
    };
    for (auto const* const near : {"0.4", "0.54", "{static=0.45, kinetic=0.4}", "{value=0.45, basis='measured'}"}) {
        EXPECT_TRUE(moves(near)) << near;
    }
    for (auto const* const far : {"0.38", "0.57", "{static=0.8, kinetic=0.45}"}) {
        EXPECT_FALSE(moves(far)) << far;
    }
}

// The pad's frequency is a default that nobody measured. Under a base that is no pair of corners it is moved by
// two, and only it: what the file of the body states of its pad stays.
TEST(Sensitivity, TheDefaultPadIsMovedUnderARim) {
    auto const found = [](std::string const& keys) {
        auto with = text;
        with.insert(with.find("restitution="), keys);
        return varied_inputs(parse_campaign(input_from(with)));
    };
    auto const is_pad = [](VariedInput const& input) {
        return input.keys.front() == "bodies[0].pad.vertical_frequency";
    };
    EXPECT_FALSE(std::ranges::any_of(found("").inputs, is_pad)) << "on its corners";
    EXPECT_FALSE(std::ranges::any_of(
        found("base={shape='round'}\npad={vertical_frequency={value='80 Hz', basis='measured'}}\n").inputs, is_pad));
    auto const round = found("base={shape='round'}\npad={tangential_ratio=0.9}\n");
    auto const pad = std::ranges::find_if(round.inputs, is_pad);
    ASSERT_NE(pad, round.inputs.end());
    EXPECT_EQ(pad->ends, (std::array<std::string, 2>{"49 Hz", "196 Hz"}));

    auto const input =
        input_from(testing::quick_waves + "[[bodies]]\nfile='b.toml'\n" + testing::levels("values=[5]\n"),
                   {{"b.toml",
                     "mass=1000\nbase_width=1\ncentre_height=1\ninertia='uniform-block'\nbase={shape='round'}\n"
                     "pad={tangential_ratio=0.9}\n"}});
    auto const values = varied_inputs(parse_campaign(input)).values;
    ASSERT_EQ(values.size(), 1U);
    auto const moved = parse_campaign(with_value(input, values.front(), "49 Hz")).bodies.front().footing;
    EXPECT_DOUBLE_EQ(moved.pad.vertical_frequency_hz, 49);
    EXPECT_DOUBLE_EQ(moved.pad.tangential_ratio, 0.9);
    EXPECT_EQ(moved.base.shape, BaseShape::round);
}

TEST(Sensitivity, AGridIsNoSample) {
    testing::expect_input_error(
        [] {
            (void)study_sensitivity(
                input_from("[waves]\nsource='harmonic'\namplitude='1 m/s2'\nfrequencies=[1, 2]\ncycles=5\n"
                           + testing::type_b + testing::levels("values=[5]\n")),
                0, [](double, double) {});
        },
        "a grid of frequencies", "Read the map");
}

}  // namespace
}  // namespace overturn::cost
