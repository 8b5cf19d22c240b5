// Requirement R-707: the annual frequency of each limit state follows from the campaign's curves and stripes and from a
// hazard curve that states its measure and unit; what rests on no data is said.
#include "results/hazard_frequency.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "output/frequency_text.hpp"
#include "support/campaigns.hpp"
#include "support/expect_input_error.hpp"

namespace overturn {
namespace {

using testing::expect_input_error;

LevelSpec levels_by(std::string const& measure) {
    auto const keys = "measure='" + measure + "'\nvalues=['300 gal', '600 gal']\n";
    return testing::campaign_from(testing::quick_waves + testing::type_b + "[levels]\n" + keys).levels;
}

TEST(HazardTable, UnitsOfItsNamesAreRead) {
    auto const levels = levels_by("pga");
    auto const gal =
        parse_hazard("# of no site\npga [gal], annual_exceedance\n100, 1e-2\n1000, 1e-5\n", "h.csv", levels);
    EXPECT_DOUBLE_EQ(gal.first(), 1);
    EXPECT_DOUBLE_EQ(gal.last(), 10);
    EXPECT_NEAR(gal.annual_exceedance(std::sqrt(10.0)), std::sqrt(1e-7), 1e-12);
    auto const g = parse_hazard("PGA (g), annual_exceedance\n0.1, 1e-2\n1, 1e-5\n", "h.csv", levels);
    EXPECT_DOUBLE_EQ(g.last(), g0);
    EXPECT_EQ(g.stated().symbol, "g");
    EXPECT_EQ(gal.stated().symbol, "gal");
}

TEST(HazardTable, WhatCannotBeMeantIsRefused) {
    auto const levels = levels_by("pga");
    auto const parse = [&](char const* text) { (void)parse_hazard(text, "h.csv", levels); };
    expect_input_error([&] { parse("0.1, 1e-2\n1, 1e-5\n"); }, "h.csv:1", "pga [gal]");
    expect_input_error([&] { parse("pgv [kine], n\n10, 1e-2\n100, 1e-5\n"); }, "h.csv:1", "levels are pga");
    std::string const n = "annual_exceedance\n";
    expect_input_error([&] { parse(("pga, " + n + "10, 1e-2\n100, 1e-5\n").c_str()); }, "states no unit");
    expect_input_error([&] { parse(("pga [gal], " + n + "100, 1e-5\n200, 1e-2\n").c_str()); }, "h.csv:3", "rarer");
    expect_input_error([&] { parse(("pga [gal], " + n + "200, 1e-2\n100, 1e-5\n").c_str()); }, "h.csv:3", "rise");
    expect_input_error([&] { parse(("pga [gal], " + n + "200, 1e-2\n").c_str()); }, "h.csv:1", "1 point");
    expect_input_error([&] { parse(("pgaverage [gal], " + n + "1, 1e-2\n2, 1e-5\n").c_str()); }, "h.csv:1",
                       "levels are pga");
    for (std::string const second : {"return_period", "annual_exceedance [%]", "n", "probability in 50 years"}) {
        expect_input_error([&] { parse(("pga [gal], " + second + "\n100, 475\n200, 50\n").c_str()); }, "h.csv:1",
                           "must be annual_exceedance");
    }
}

// Rows that say nothing are left out with a remark, a flat start is kept.
TEST(HazardTable, ZerosAtEitherEndAreLeftOut) {
    auto const levels = levels_by("pga");
    auto const parse = [&](std::string const& rows) {
        return parse_hazard("pga [g], annual_exceedance\n" + rows, "h.csv", levels);
    };
    auto const from_none = parse("0.0,1.0\n0.1,1e-2\n1,2e-5\n");
    EXPECT_EQ(from_none.points().size(), 2U);
    ASSERT_EQ(from_none.remarks().size(), 1U);
    EXPECT_NE(from_none.remarks()[0].find("line 2"), std::string::npos) << from_none.remarks()[0];
    auto const to_none = parse("0.1,1e-2\n0.3,8e-4\n1,2e-5\n2,0\n3,0\n");
    EXPECT_DOUBLE_EQ(to_none.last(), g0);
    ASSERT_EQ(to_none.remarks().size(), 1U);
    EXPECT_NE(to_none.remarks()[0].find("line 5"), std::string::npos) << to_none.remarks()[0];
    auto const flat = parse("0.005,4.3e-2\n0.01,4.3e-2\n0.1,1e-2\n1,2e-5\n");
    EXPECT_EQ(flat.points().size(), 4U);
    EXPECT_TRUE(flat.remarks().empty());
    expect_input_error([&] { (void)parse("0.1,1e-2\n0.3,0\n1,2e-5\n"); }, "h.csv:4", "rarer");
    expect_input_error([&] { (void)parse("0.1,1e-2\n0,1e-3\n1,2e-5\n"); }, "h.csv:3", "intensity 0");
}

// Numbers in g under the name gal: nothing of the curve lies where the trials were.
TEST(HazardTable, WhatMeetsNoLevelIsRefused) {
    auto const levels = levels_by("pga");
    auto const parse = [&](std::string const& text) { (void)parse_hazard(text, "h.csv", levels); };
    expect_input_error([&] { parse("pga [gal], annual_exceedance\n0.1,1e-3\n0.3,1e-4\n1,1e-6\n"); }, "h.csv:1",
                       "from 0.1 gal to 1 gal", "300 gal to 600 gal", "units");
    expect_input_error([&] { parse("pga [g], annual_exceedance\n1,1e-3\n3,1e-4\n"); }, "from 1 g to 3 g");
}

// A line above the numbers that names a time of investigation speaks of probabilities.
TEST(HazardTable, ATimeOfInvestigationIsNotPassedOver) {
    auto const levels = levels_by("pga");
    auto const parse = [&](std::string const& comment) {
        return parse_hazard(comment + "\npga [g], annual_exceedance\n0.1,1e-2\n1,1e-5\n", "h.csv", levels);
    };
    expect_input_error([&] { (void)parse("# investigation_time = 50.0"); }, "h.csv:1", "-ln(1 - p) / 50", "remove");
    expect_input_error([&] { (void)parse("# PSHA\n# Investigation time (years): 100"); }, "h.csv:2", "/ 100");
    expect_input_error([&] { (void)parse("# investigation time: see report"); }, "h.csv:1", "/ t");
    EXPECT_EQ(parse("# investigation_time = 1.0").points().size(), 2U);
}

// A spectral acceleration is one of its period.
TEST(HazardTable, ThePeriodOfSaIsRead) {
    auto const levels = testing::campaign_from(testing::quick_waves + testing::type_b
                                               + "[measures]\nsa_periods=['1.9 s']\n[levels]\nmeasure='sa'\nperiod='1.9 s'\n"
                                                 "values=['300 gal', '600 gal']\n")
                            .levels;
    auto const parse = [&](std::string const& over) {
        return parse_hazard(over + ", annual_exceedance [1/a]\n0.1, 1e-2\n1000, 1e-5\n", "h.csv", levels);
    };
    EXPECT_DOUBLE_EQ(parse("sa(1.9 s) [g]").last(), 1000 * g0);
    EXPECT_DOUBLE_EQ(parse("Sa(1.9 s)_gal").last(), 10);
    EXPECT_DOUBLE_EQ(parse("SA(1.90s) (gal)").last(), 10);
    EXPECT_DOUBLE_EQ(parse("Sa(1.9 sec) [gal]").last(), 10);
    for (std::string const other : {"sa(0.5 s) [g]", "sa [g]", "sa-average [g]", "sa(1.95 s) [g]"}) {
        expect_input_error([&] { (void)parse(other); }, "h.csv:1", "levels are sa(1.9 s)");
    }
}

// an export of OpenQuake: probabilities in so many years, of one site.
TEST(HazardTable, ExportsOfOpenQuakeAreRead) {
    auto const levels = testing::campaign_from(testing::quick_waves + testing::type_b
                                               + "[measures]\nsa_periods=['1 s']\n[levels]\nmeasure='sa'\nperiod='1 s'\n"
                                                 "values=['300 gal', '600 gal']\n")
                            .levels;
    auto const text = [](std::string const& time, std::string const& imt, std::string const& more = "") {
        return "#,,,,,,,\"generated_by='OpenQuake engine 3.9.0', kind='mean', investigation_time=" + time + ", imt='" + imt
               + "'\"\nlon,lat,depth,poe-0.001,poe-0.01,poe-0.1,poe-1.0,poe-2.0\n-1.0,2.0,0.0,1.0E+00,1.0E-01,1.0E-02,"
                 "1.0E-04,0.0E+00\n"
               + more;
    };
    auto const curve = parse_hazard(text("50.0", "SA(1.0)"), "h.csv", levels);
    ASSERT_EQ(curve.points().size(), 3U);
    EXPECT_DOUBLE_EQ(curve.points()[0].annual_exceedance, -std::log(0.9) / 50);
    EXPECT_DOUBLE_EQ(curve.points()[1].intensity, 0.1 * g0);
    EXPECT_DOUBLE_EQ(curve.points()[2].annual_exceedance, -std::log1p(-1e-4) / 50);
    expect_input_error([&] { (void)parse_hazard(text("50.0", "PGA"), "h.csv", levels); }, "levels are sa(1 s)");
    expect_input_error([&] { (void)parse_hazard(text("x", "SA(1.0)"), "h.csv", levels); }, "h.csv:1",
                       "investigation_time");
    expect_input_error([&] { (void)parse_hazard(text("1.0", "SA(1.0)", "1,2,0,.5,.4,.3,.2,.1\n"), "h.csv", levels); },
                       "h.csv:4", "a second site");
    ASSERT_EQ(curve.remarks().size(), 2U);
    EXPECT_EQ(curve.remarks()[0].find("up to poe-0.001 the probability is 1"), 0U);
    EXPECT_EQ(curve.remarks()[1].find("from poe-2.0 on the probability is 0"), 0U);
}

// what is no mean curve says so; a row that rises, or has lost its first line, is refused where it stands.
TEST(HazardTable, ExportsOfOpenQuakeThatAreNoMeanCurve) {
    HazardAxis const over_pga{.label = "pga", .dimension = Dimension::acceleration, .unit = {}};
    std::string const names = "lon,lat,depth,poe-0.1,poe-0.3,poe-1.0\n";
    auto const parse = [&](std::string const& kind, std::string const& row) {
        return parse_hazard("#,,\"generated_by='OpenQuake engine 3.9.0', kind='" + kind
                                + "', investigation_time=50.0, imt='PGA'\"\n" + names + row + "\n",
                            "h.csv", over_pga);
    };
    EXPECT_TRUE(parse("mean", "1,2,0,0.5,0.1,0.01").remarks().empty());
    for (auto const* kind : {"quantile-0.15", "rlz-003", "max"}) {
        auto const remarks = parse(kind, "1,2,0,0.5,0.1,0.01").remarks();
        ASSERT_EQ(remarks.size(), 1U) << kind;
        EXPECT_EQ(remarks.front().find(std::string("its kind is ") + kind + ", not mean"), 0U) << remarks.front();
    }
    for (auto const* row : {"1,2,0,0.1,0.5,0.01", "1,2,0,0.5,0,0.01", "1,2,0,0.5,1,0.01"}) {
        expect_input_error([&] { (void)parse("mean", row); }, "h.csv:3", "stronger motions are rarer");
    }
    expect_input_error([&] { (void)parse_hazard(names + "1,2,0,0.5,0.1,0.01\n", "h.csv", over_pga); }, "h.csv:1",
                       "states investigation_time");
}

// Rocks from g/10 on, below all levels.
std::string const slender =
    "[[bodies]]\nname='type-b'\nmass='12.6 t'\nbase_width='0.2 m'\ncentre_height='1 m'\ninertia='uniform-block'\n";

// Trials whose proportions are those of a lognormal curve, so that curve, stripes and the closed form agree.
class Frequency : public ::testing::Test {
  protected:
    Frequency() : Frequency(std::nullopt) {}
    /// \param above what became of every 40th wave at the highest levels; nothing: what the curve says
    explicit Frequency(std::optional<Verdict> above)
        : spec(testing::campaign_from(testing::quick_waves + slender
                                      + "[levels]\nmeasure='pga'\nvalues={from=2, to=18, count=17}\n")),
          statistics(spec) {
        LognormalFragility const truth{6, 0.4};
        constexpr int each = 200;
        for (std::int64_t w = 0; w < each; ++w) {
            WaveRow row;
            row.id = w;
            row.pga_mps2 = row.pgv_mps = 1;
            statistics.add(row, std::vector<MeasureRow>(1));
            // Wave w falls from its own quantile of the curve on.
            double const share = (static_cast<double>(w) + 0.5) / each;
            for (std::size_t level = 0; level < spec.levels.levels.size(); ++level) {
                TrialRow trial;
                trial.wave = w;
                trial.level = static_cast<std::int64_t>(level);
                trial.amplitude = spec.levels.levels[level].value;
                trial.scale = trial.amplitude;
                trial.verdict = truth.probability(trial.amplitude) > share ? Verdict::overturned : Verdict::rocked;
                if (above && trial.amplitude > 11 && w % 40 == 7) {
                    trial.verdict = *above;
                }
                trial.v_ereq_mps = 1;
                statistics.add(trial);
            }
        }
    }
    CampaignSpec spec;
    Statistics statistics;
};

TEST_F(Frequency, IsThatOfTheCurveAndWithinTheStripes) {
    HazardCurve const hazard({{0.5, 1e-2}, {50, 1e-8}});  // slope 3
    auto const analysis = analyse(spec, statistics, {.confidence = 0.95, .beta_u = 0, .replicates = 200});
    auto const all = frequencies_of(spec, statistics, analysis, hazard, 0.95);
    ASSERT_EQ(all.size(), 1U);
    auto const& f = all.front();
    EXPECT_EQ(f.body, "type-b");
    EXPECT_EQ(f.limit, "overturning");
    ASSERT_TRUE(f.mean.has_value());
    double const closed = 1e-2 * std::pow(6 / 0.5, -3) * std::exp(9 * 0.16 / 2);
    double const mean = f.mean->annual + f.mean->beyond_least;
    EXPECT_NEAR(mean / closed, 1, 0.03) << "200 waves' quantiles for a curve";
    EXPECT_LT(f.interval.lower, mean);
    EXPECT_GT(f.interval.upper, mean);
    EXPECT_GT(f.interval.lower, 0.6 * mean);
    EXPECT_TRUE(std::isinf(f.interval.upper)) << "beta_U is not known";
    // Below the lowest level, 2, P is at most what the curve holds there, above the highest, 18, it may be 1.
    auto const sure = analyse(spec, statistics, {.confidence = 0.95, .beta_u = 1e-6, .replicates = 200});
    auto const upper = frequencies_of(spec, statistics, sure, hazard, 0.95).front().interval.upper;
    EXPECT_GT(upper, mean);
    EXPECT_LT(upper, 1.6 * mean + f.bounds.below_most * 6 + f.bounds.above_most);
    EXPECT_NEAR(f.bounds.above_most, 1e-2 * std::pow(18 / 0.5, -3), 1e-12);
    EXPECT_NEAR(f.bounds.below_most / (1e-2 * (std::pow(9.80665 * 0.1 / 0.5, -3) - std::pow(4.0, -3))),
                LognormalFragility({6, 0.4}).probability(2), 1e-3);
    EXPECT_LT(f.seen.lower, mean);
    EXPECT_TRUE(std::isinf(f.seen.upper));
    EXPECT_GT(frequencies_of(spec, statistics, sure, hazard, 0.95).front().seen.upper, mean);
    EXPECT_FALSE(f.outside_seen);
    EXPECT_FALSE(f.fractiles.has_value());
    EXPECT_NEAR(f.shares->below + f.shares->between + f.shares->above, 1, 1e-12);

    // Stated beta_U: the mean is that of the composite curve, fractiles those of shifted medians.
    auto const unsure = analyse(spec, statistics, {.confidence = 0.95, .beta_u = 0.3, .replicates = 200});
    auto const with = frequencies_of(spec, statistics, unsure, hazard, 0.95).front();
    EXPECT_NEAR((with.mean->annual + with.mean->beyond_least) / mean, std::exp(9 * 0.09 / 2), 0.01);
    ASSERT_TRUE(with.fractiles.has_value());
    EXPECT_NEAR(with.fractiles->median / mean, 1, 1e-9);
    EXPECT_NEAR(with.fractiles->high / with.fractiles->median, std::exp(3 * 1.6448536 * 0.3), 0.02);
    EXPECT_NEAR(with.fractiles->median / with.fractiles->low, std::exp(3 * 1.6448536 * 0.3), 0.02);
    // At 95 % confidence the curve, the sample and what was not tried are on the unsafe side together.
    EXPECT_GT(with.fractiles->most, 1.1 * with.fractiles->high);
    EXPECT_GE(with.fractiles->most, with.interval.upper);
    EXPECT_GE(frequencies_of(spec, statistics, sure, hazard, 0.95).front().fractiles->most, upper);
    auto const stated = frequency_of_stated(0.3, 0.1, 1.5, HazardCurve({{0.5, 1e-2}, {50, 1e-8}}));
    EXPECT_GE(stated.fractiles->most, stated.interval.upper);
}

// Motions below uplift move nothing: how far down the user's table goes changes no bound, and where no such level is
// known the part of what is weaker than all levels is reported.
TEST_F(Frequency, WeakMotionsOfTheTableAreNoRisk) {
    HazardCurve const from_uplift({{0.5, 1e-2}, {50, 1e-8}});
    HazardCurve const from_nothing({{0.005, 1e4}, {50, 1e-8}});  // the same power law
    auto const analysis = analyse(spec, statistics, {.confidence = 0.95, .beta_u = 1e-6, .replicates = 50});
    auto const least = frequencies_of(spec, statistics, analysis, from_uplift, 0.95).front();
    auto const most = frequencies_of(spec, statistics, analysis, from_nothing, 0.95).front();
    EXPECT_NEAR(most.nothing_below, g0 * 0.1, 1e-12);
    EXPECT_NEAR(most.seen.upper / least.seen.upper, 1, 1e-9);
    double const weak = from_nothing.annual_exceedance(g0 * 0.1) - from_nothing.annual_exceedance(2);
    EXPECT_NEAR(most.seen_below_levels / (clopper_pearson(1, 200, 0.95).upper * weak), 1, 1e-9);

    auto factors = testing::campaign_from(testing::quick_waves + slender
                                          + "[levels]\nmeasure='pgv'\nvalues={from=2, to=18, count=17}\n");
    auto const unknown = frequencies_of(factors, statistics, analysis, from_nothing, 0.95).front();
    EXPECT_EQ(unknown.nothing_below, 0);
    double const weaker = 1e4 - from_nothing.annual_exceedance(2);
    EXPECT_NEAR(unknown.seen_below_levels / (clopper_pearson(1, 200, 0.95).upper * weaker), 1, 1e-9);
    auto const text = output::frequency_text({&unknown, 1}, from_nothing, 0.95);
    EXPECT_NE(text.find("by motions weaker than all levels"), std::string::npos) << text;
}

// A body at rest asks friction of the ground: motions too weak to move it pass such a limit, alone or in others.
TEST(FrequencyOfLimits, CountsWhatIsPassedAtRest) {
    auto const spec = testing::campaign_from(
        testing::quick_waves + slender + "[levels]\nmeasure='pga'\nvalues=[2, 4]\n"
        + "[[limits]]\nname='grips'\nquantity='friction_demand'\nabove=0.05\n"
          "[[limits]]\nname='rocks'\nquantity='peak_rotation_ratio'\nabove=0.1\n"
          "[[limits]]\nname='stands on'\nquantity='min_contact_force_ratio'\nbelow=0.9\n"
          "[[limits]]\nname='one'\nany=['grips', 'rocks']\n[[limits]]\nname='moves'\nall=['rocks', 'overturning']\n");
    Statistics statistics(spec);
    WaveRow wave;
    wave.pga_mps2 = 1;
    statistics.add(wave, std::vector<MeasureRow>(1));
    for (std::int64_t level = 0; level < 2; ++level) {
        TrialRow trial;
        trial.level = level;
        trial.amplitude = trial.scale = spec.levels.levels[static_cast<std::size_t>(level)].value;
        trial.verdict = Verdict::rocked;
        statistics.add(trial);
    }
    auto const analysis = analyse(spec, statistics, {});
    std::vector<double> nothing_below;
    for (auto const& f : frequencies_of(spec, statistics, analysis, HazardCurve({{0.5, 1e-2}, {50, 1e-8}}), 0.95)) {
        nothing_below.push_back(f.nothing_below);
    }
    double const uplift = spec.bodies.front().body.uplift_acceleration_mps2();
    EXPECT_EQ(nothing_below, (std::vector<double>{uplift, 0, uplift, 0, 0, uplift}));
}

// Trials without a verdict: the frequency holds whatever they would have done.
class OfUndecided : public Frequency {
  public:
    explicit OfUndecided(Verdict above) : Frequency(above) {}
    void TestBody() override {}
    [[nodiscard]] BodyFrequency of(HazardCurve const& hazard) const {
        auto const analysis = analyse(spec, statistics, {.confidence = 0.95, .beta_u = 1e-6, .replicates = 200});
        return frequencies_of(spec, statistics, analysis, hazard, 0.95).front();
    }
};

FragilityRequest with_beta_u(double beta_u, bool drawn = false) {
    FragilityRequest request;
    request.beta_u = beta_u;
    request.drawn = drawn;
    return request;
}

// without a curve, what lies below the first point of a hazard curve that begins amid the levels counts in the
// upper end as it would with the whole curve, or more; the lower end stays.
TEST(FrequencyWithoutACurve, AHazardThatBeginsLateCountsWhatIsWeaker) {
    HazardCurve const whole({{0.05, 0.1}, {0.3, 7.5e-4}, {0.6, 1e-4}, {2, 1e-6}});
    HazardCurve const late({{0.6, 1e-4}, {2, 1e-6}});
    for (bool const all : {true, false}) {
        std::vector<Stripe> stripes;
        for (double const level : {0.3, 0.6, 0.9}) {
            stripes.push_back({.amplitude = level, .trials = 40, .overturned = all ? 40 : 0});
        }
        auto const data = FragilityData::of_stripes(stripes);
        auto const fit = fit_fragility(data, with_beta_u(1e-6));
        auto const known = frequency_of(fit, data, whole, 0.95, 0);
        auto const bounded = frequency_of(fit, data, late, 0.95, 0);
        ASSERT_FALSE(bounded.mean);
        EXPECT_GE(bounded.seen.upper, known.seen.upper) << all;
        EXPECT_LE(bounded.seen.lower, known.seen.lower) << all;
        EXPECT_GT(bounded.seen_below_curve, 0.5 * bounded.seen.upper);
        auto const notes = output::frequency_notes(bounded, late);
        EXPECT_NE(notes.front().find("where the hazard curve begins"), std::string::npos) << notes.front();
    }
}

// without a curve too, a body whose uncertainty is neither drawn nor stated has no upper end, and a stated one
// moves it.
TEST(FrequencyWithoutACurve, NeedsBetaU) {
    HazardCurve const hazard({{0.05, 0.1}, {0.3, 7.5e-4}, {0.6, 1e-4}, {2, 1e-6}});
    std::vector<Stripe> stripes;
    for (double const level : {0.3, 0.6, 0.9}) {
        stripes.push_back({.amplitude = level, .trials = 40, .overturned = 0});
    }
    auto const data = FragilityData::of_stripes(stripes);
    auto const of = [&](FragilityRequest const& request) {
        return frequency_of(fit_fragility(data, request), data, hazard, 0.95, 0.1);
    };
    auto const unknown = of({});
    EXPECT_TRUE(unknown.lacks_beta_u);
    EXPECT_TRUE(std::isinf(unknown.ends().upper));
    auto const text = output::frequency_text({&unknown, 1}, hazard, 0.95);
    EXPECT_NE(text.find("no upper end, because beta_U is not known"), std::string::npos) << text;
    EXPECT_EQ(text.find("inf"), std::string::npos) << text;
    auto const drawn = of(with_beta_u(0, true));
    EXPECT_FALSE(drawn.lacks_beta_u);
    EXPECT_NEAR(drawn.ends().upper, annual_frequency_seen(hazard, data.points, 0.95, 0.1).upper, 1e-12)
        << "its scatter is in the stripes";
    auto const stated = of(with_beta_u(0.3));
    EXPECT_FALSE(stated.lacks_beta_u);
    EXPECT_GT(stated.ends().upper, 1.1 * drawn.ends().upper);
    EXPECT_TRUE(std::isfinite(stated.ends().upper));
    auto const both = of(with_beta_u(0.3, true));
    EXPECT_EQ(both.ends().upper, stated.ends().upper);
}

TEST(FrequencyOfUndecided, HoldsBothExtremes) {
    HazardCurve const hazard({{0.5, 1e-2}, {50, 1e-8}});
    auto const open = OfUndecided(Verdict::contact_lost).of(hazard);
    auto const standing = OfUndecided(Verdict::rocked).of(hazard);
    auto const fallen = OfUndecided(Verdict::overturned).of(hazard);
    ASSERT_TRUE(open.mean && standing.mean && fallen.mean);
    constexpr double rounding = 1e-9;
    for (auto const* extreme : {&standing, &fallen}) {
        EXPECT_LE(open.interval.lower, extreme->interval.lower * (1 + rounding));
        EXPECT_GE(open.interval.upper, extreme->interval.upper * (1 - rounding));
    }
    EXPECT_NEAR(open.seen.lower, std::min(standing.seen.lower, fallen.seen.lower), rounding * open.seen.lower);
    EXPECT_NEAR(open.seen.upper, std::max(standing.seen.upper, fallen.seen.upper), rounding * open.seen.upper);
    EXPECT_LT(standing.seen.lower, fallen.seen.lower);
}

TEST_F(Frequency, PartsWithoutDataAreReported) {
    auto const analysis = analyse(spec, statistics, {.confidence = 0.95, .beta_u = 0.1, .replicates = 50});
    auto const said = [&](HazardCurve const& hazard) {
        return output::frequency_text(frequencies_of(spec, statistics, analysis, hazard, 0.95), hazard, 0.95);
    };
    EXPECT_NE(said(HazardCurve({{0.5, 1e-2}, {6, 5e-6}})).find("where the hazard curve ends"), std::string::npos);
    EXPECT_NE(said(HazardCurve({{5, 1e-2}, {60, 1e-6}})).find("where the hazard curve begins"), std::string::npos);
    EXPECT_NE(said(HazardCurve({{0.1, 1e-1}, {60, 1e-22}})).find("the lowest level"), std::string::npos);
    EXPECT_NE(said(HazardCurve({{0.5, 1e-2}, {8, 1e-5}, {50, 9e-6}})).find("the highest level"), std::string::npos);
    EXPECT_NE(said(HazardCurve({{0.5, 1e-2}, {50, 1e-8}})).find("6.0 decades"), std::string::npos);
    // Nothing to say: it begins where hardly anything falls, ends where all fall, and has points enough.
    std::vector<HazardPoint> fine;
    for (double a = 2; a < 40; a *= 1.5) {
        fine.push_back({a, 1e-2 * std::pow(a / 0.5, -3)});
    }
    auto const sound = said(HazardCurve(fine));
    EXPECT_EQ(sound.find("note:"), std::string::npos) << sound;
    // Its ends are reported in the unit that the curve states, whatever the levels do.
    auto const in_g = parse_hazard("pga [g], annual_exceedance\n0.05, 1e-2\n5, 1e-8\n", "h.csv", spec.levels);
    EXPECT_NE(said(in_g).find("from 0.05 g (0.01 1/a) to 5 g (1e-08 1/a)"), std::string::npos) << said(in_g);
}

// a unit among other words is none of the intensities.
TEST(HazardUnits, AmongOtherWordsAreAskedFor) {
    auto const levels = levels_by("pga");
    for (char const* line : {"# not in gal", "# noise (gal)", "# g=981 (cm/s2)", "# annual rates, converted to gal"}) {
        auto const text = fmt::format("{}\npga,annual_exceedance\n100,1e-2\n1000,1e-5\n", line);
        testing::expect_input_error([&] { (void)parse_hazard(text, "h", levels); }, "among other words");
    }
}

// an operation in the name of the intensities is refused.
TEST(HazardUnits, OperationsInNamesAreRefused) {
    for (char const* name : {"pga [g]/2", "pga [g] x 0.5", "pga/2 [g]"}) {
        auto const text = fmt::format("{},annual_exceedance\n0.1,1e-2\n1,1e-5\n", name);
        expect_input_error([&] { (void)parse_hazard(text, "h", levels_by("pga")); }, "h:1: ");
    }
}

}  // namespace
}  // namespace overturn
