// Requirement R-707: a hazard curve's second column is a frequency in a year, which its names and the text above must
// say.
#include <string>

#include <fmt/format.h>

#include "core/units.hpp"
#include "results/hazard_table.hpp"
#include "support/expect_input_error.hpp"

namespace overturn {
namespace {

using testing::expect_input_error;

HazardAxis const over_pga{.label = "pga", .dimension = Dimension::acceleration, .unit = {}};

// a probability in so many years is none, whatever the names below say.
TEST(HazardNames, ProbabilitiesInTheTextAreRefused) {
    auto const parse = [&](std::string const& comment) {
        return parse_hazard(comment + "\npga [g], annual_exceedance\n0.1,1e-2\n1,1e-5\n", "h.csv", over_pga);
    };
    expect_input_error([&] { (void)parse("# probability of exceedance in 50 years"); }, "h.csv:1", "-ln(1 - p) / 50");
    expect_input_error([&] { (void)parse("# PoE in 50-yr"); }, "h.csv:1", "-ln(1 - p) / 50");
    expect_input_error([&] { (void)parse("# probability of exceedance"); }, "h.csv:1", "/ t");
    for (char const* text : {"# exposure time 50 a", "# lifetime: 50 years", "# reference period 50 yr"}) {
        expect_input_error([&] { (void)parse(text); }, "h.csv:1", "-ln(1 - p) / 50");
    }
    expect_input_error(
        [] {
            (void)parse_hazard("pga [g], annual_exceedance # investigation time 50 yr\n0.1,1e-2\n1,1e-5\n", "h.csv",
                               over_pga);
        },
        "h.csv:1", "-ln(1 - p) / 50");
    auto const noted = parse("# T = 50 yr").remarks();
    ASSERT_EQ(noted.size(), 1U);
    EXPECT_EQ(noted.front(), "line 1 names 50 years: exceedances of one year are read. Check that they are");
    EXPECT_TRUE(parse("# 1 year").remarks().empty());
    for (char const* text : {"# annual probability of exceedance", "# probability of exceedance in 1 year",
                             "# exceedances per year", "# of 2014"}) {
        EXPECT_EQ(parse(text).points().size(), 2U) << text;
    }
}

// a frequency in a year by any of its names; a probability, a return period or another unit is none.
TEST(HazardNames, AnnualFrequenciesHaveManyNames) {
    auto const parse = [&](std::string const& name) {
        return parse_hazard("pga [g], " + name + "\n0.1,1e-2\n1,1e-5\n", "h.csv", over_pga);
    };
    for (char const* name : {"MAFE", "mean annual frequency of exceedance (1/yr)", "annual rate of exceedance [1/year]",
                             "Annual_Exceedance", "AFE (/yr)"}) {
        EXPECT_EQ(parse(name).points().front().annual_exceedance, 1e-2) << name;
    }
    expect_input_error([] { (void)parse_hazard("pga [g], return_period\n0.1,30\n1,500\n", "h.csv", over_pga); },
                       "h.csv:1",
                       "must be annual_exceedance");  // not that its rows rise
    for (char const* name : {"annual probability of exceedance", "poe", "return period [a]", "MAFE [1/50a]", "lambda",
                             "MAFE (1/yr) of SA"}) {
        expect_input_error([&] { (void)parse(name); }, "h.csv:1", "must be annual_exceedance");
    }
}

// the unit may stand in the text, which may not contradict the names; what it says else is reported.
TEST(HazardNames, EveryLineOfTextIsAccountedFor) {
    auto const parse = [&](std::string const& head) {
        return parse_hazard(head + "0.1,1e-2\n1,1e-5\n", "h.csv", over_pga);
    };
    auto const of_text = parse("# hazard of the site, intensities in g\npga,annual_exceedance\n");
    EXPECT_DOUBLE_EQ(of_text.last(), g0);
    EXPECT_EQ(of_text.stated().symbol, "g");
    EXPECT_DOUBLE_EQ(parse("pga,annual_exceedance\n(g),(1/yr)\n").last(), g0);
    expect_input_error([&] { (void)parse("# units: gal\npga [g],annual_exceedance\n"); },
                       "h.csv:1: unit gal, line 2 says g");
    expect_input_error([&] { (void)parse("# units: cm/s\npga,annual_exceedance\n"); }, "h.csv:1: a unit of velocities");
    expect_input_error([&] { (void)parse("pga [g],annual_exceedance,sigma\n"); }, "h.csv:1: ", "another number");
    auto const told = parse("# of Smith, model 7b\n# annual rates\npga [g],annual_exceedance\n").remarks();
    ASSERT_FALSE(told.empty());
    EXPECT_EQ(told[0], "h.csv (not understood: line 1: '# of Smith, model 7b')");
}

// what a line says of a curve that is no mean annual one of this measure is a note.
TEST(HazardNames, WordsThatChangeACurveAreNotes) {
    auto const remarks = [](std::string const& comment) {
        return parse_hazard(comment + "\npga [g], annual_exceedance\n0.1,1e-2\n1,1e-5\n", "h.csv", over_pga).remarks();
    };
    for (char const* text : {"# median hazard", "# hazard, 16 % fractile", "# hazard for Sa(1 s)",
                             "# hazard of the vertical component", "# Hazard: best estimate minus one sigma"}) {
        auto const noted = remarks(text);
        ASSERT_EQ(noted.size(), 1U) << text;
        EXPECT_NE(noted.front().find("not understood: line 1"), std::string::npos) << noted.front();
    }
    EXPECT_TRUE(remarks("# mean hazard").empty());
}

// rates that still have a factor or another span to them are not read as they stand.
TEST(HazardNames, OtherRatesInTheTextAreRefused) {
    for (std::string const line :
         {"# monthly hazard", "# hazard: rate per century", "# hazard x 1000", "# in 10^-4 per year",
          "# rates in 1e-4/yr", "# multiply by 100", "# rates per 1000 years", "# per 50 years"}) {
        testing::expect_input_error(
            [&] {
                (void)parse_hazard("pga [g], annual_exceedance\n" + line + "\n0.1,1e-2\n1,1e-5\n", "h.csv", over_pga);
            },
            "h.csv:2: '" + line + "' (speaks of a factor or of another span than a year, and annual_exceedance is read",
            "take the line away");
    }
    EXPECT_NO_THROW((void)parse_hazard("# catalogue of 50 years\npga [g], annual_exceedance\n0.1,1e-2\n1,1e-5\n",
                                       "h.csv", over_pga));
}

// text that speaks of another measure than the column is reported.
TEST(HazardNames, OtherMeasuresInTheTextAreReported) {
    auto const remarks = [](std::string const& line) {
        return parse_hazard(line + "\npga [g], annual_exceedance\n0.1,1e-2\n1,1e-5\n", "h.csv", over_pga).remarks();
    };
    for (char const* line : {"# velocity", "# spectral acceleration at 1 s", "# PGA = 2.5 x", "# Sa(1 s)"}) {
        auto const told = remarks(line);
        ASSERT_EQ(told.size(), 1U) << line;
        EXPECT_EQ(told.front(), fmt::format("h.csv (not understood: line 1: '{}')", line));
    }
    EXPECT_TRUE(remarks("# mean annual hazard curve").empty());
}

// a word in the intensity's name that may change it is reported: of another component, a percentile.
TEST(HazardNames, WordsOfTheIntensityAreAccountedFor) {
    auto const remarks = [](std::string const& name, std::string const& label) {
        HazardAxis const axis{.label = label, .dimension = Dimension::acceleration, .unit = {}};
        return parse_hazard(name + ", annual_exceedance\n0.1,1e-2\n1,1e-5\n", "h.csv", axis).remarks();
    };
    for (char const* name : {"pga_v [g]", "pga_vertical [g]", "PGA UD [g]", "pga_84 [g]"}) {
        auto const told = remarks(name, "pga");
        ASSERT_EQ(told.size(), 1U) << name;
        EXPECT_EQ(told.front(), fmt::format("h.csv (not understood: line 1: '{}')", name));
    }
    for (char const* name : {"pga [g]", "PGA_h [g]", "pga_gal", "pga (cm/s2)"}) {
        for (auto const& remark : remarks(name, "pga")) {
            EXPECT_EQ(remark.find("not understood"), std::string::npos) << name;
        }
    }
    EXPECT_TRUE(remarks("Sa(1.0 s) [g]", "sa(1 s)").empty());
    EXPECT_EQ(remarks("Sa(1.0 s)_v [g]", "sa(1 s)").size(), 1U);
}

}  // namespace
}  // namespace overturn
