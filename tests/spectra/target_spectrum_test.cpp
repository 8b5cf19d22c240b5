// Requirement R-104: targets have the values their standards print, and say where they end.
#include "spectra/target_spectrum.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/units.hpp"
#include "spectra/named_targets.hpp"
#include "spectra/target_input.hpp"
#include "support/expect_input_error.hpp"
#include "support/tolerance.hpp"

namespace overturn {
namespace {

using testing::exact_formula;
using testing::expect_input_error;
using testing::near;

TargetSpectrum named(std::string_view name, NamedTargetInput const& input = {}) {
    return config::find_entry(named_targets(), name, "spectrum").value(input);
}

// peak over 35 Hz ordinate on hard rock by Toro, Abrahamson and Schneider (1997, Midcontinent, moment
// magnitude): ln y = C1 + C2 (M - 6) - C4 ln r - (C5 - C4) max(ln(r / 100), 0) - C6 r, r^2 = R^2 + C7^2.
TEST(TargetSpectrum, ImpliesAPeakThatHardRockMayHave) {
    struct Coefficients {
        double c1, c2, c4, c5, c6, c7;
    };
    auto const log_of = [](Coefficients const& c, double magnitude, double distance_km) {
        double const r = std::hypot(distance_km, c.c7);
        return c.c1 + c.c2 * (magnitude - 6) - c.c4 * std::log(r) - (c.c5 - c.c4) * std::max(std::log(r / 100), 0.0)
               - c.c6 * r;
    };
    Coefficients const peak{2.20, 0.81, 1.27, 1.16, 0.0021, 9.3};
    Coefficients const at_35_hz{4.00, 0.79, 1.57, 1.83, 0.0008, 11.1};
    auto const rock = TargetSpectrum::from_points("rock", 0.05, TargetKind::acceleration,
                                                  std::vector<std::pair<double, double>>{{1 / 35.0, 1}, {0.1, 0.8}});
    ASSERT_TRUE(rock.pga());
    for (double const magnitude : {5.0, 6.0, 7.0, 8.0}) {
        for (double const distance_km : {1.0, 10.0, 30.0, 100.0, 200.0}) {
            double const share =
                std::exp(log_of(peak, magnitude, distance_km) - log_of(at_35_hz, magnitude, distance_km));
            EXPECT_GT(share, rock.pga()->least_mps2) << magnitude << ' ' << distance_km;
            EXPECT_LT(share, rock.pga()->most_mps2) << magnitude << ' ' << distance_km;
        }
    }
    constexpr double largest = 0.402;  // at magnitude 5 and 10 km, the least share
    EXPECT_GT(rock.pga()->least_mps2, 0.99 * largest) << "wider than what is published";
}

TEST(TargetSpectrum, MlitValuesAreThePrintedOnes) {
    struct Printed {
        char const* name;
        double period_s, gal;
    };
    for (auto const& [name, period, gal] :
         {Printed{"mlit-ch1", 0.02, 380}, Printed{"mlit-ch1", 0.16, 800}, Printed{"mlit-ch1", 0.7, 800},
          Printed{"mlit-ch1", 1.28, 800}, Printed{"mlit-ch1", 2, 512},    Printed{"mlit-ch1", 4, 256},
          Printed{"mlit-ch1", 6, 128},    Printed{"mlit-ch1", 8, 64},     Printed{"mlit-ch1", 10, 51.2},
          Printed{"mlit-sz1", 0.1, 620},  Printed{"mlit-sz1", 5, 128},    Printed{"mlit-sz1", 10, 51.2},
          Printed{"mlit-ka1", 0.1, 99.2}, Printed{"mlit-ka1", 1, 128},    Printed{"mlit-ka1", 4, 64},
          Printed{"mlit-ka1", 5, 76.8},   Printed{"mlit-ka1", 8, 64},     Printed{"mlit-ka1", 10, 38.4},
          Printed{"mlit-os1", 0.1, 496},  Printed{"mlit-os1", 1, 640},    Printed{"mlit-os1", 2, 352},
          Printed{"mlit-os1", 4, 216},    Printed{"mlit-os1", 5, 204.8},  Printed{"mlit-os1", 10, 51.2},
          Printed{"mlit-sz2", 2, 384},    Printed{"mlit-sz2", 4, 160},    Printed{"mlit-sz2", 10, 38.4},
          Printed{"mlit-sz3", 0.64, 800}, Printed{"mlit-sz3", 4, 96},     Printed{"mlit-sz3", 10, 25.6},
          Printed{"mlit-ch2", 2, 384},    Printed{"mlit-ch2", 4, 176},    Printed{"mlit-ch2", 8, 48},
          Printed{"mlit-os2", 2, 288},    Printed{"mlit-os2", 4, 176},    Printed{"mlit-os2", 6, 128},
          Printed{"mlit-os2", 8, 80}}) {
        EXPECT_TRUE(near(named(name).psa_mps2(period), gal / 100, exact_formula)) << name << " at " << period;
    }
}

TEST(TargetSpectrum, NamedTargetsAreContinuous) {
    for (auto const& entry : named_targets()) {
        auto const target = entry.value({});
        for (double period = 0.011; period < 12; period *= 1.0005) {
            double const before = target.psa_mps2(period * (1 - 1e-9));
            EXPECT_NEAR(target.psa_mps2(period * (1 + 1e-9)) / before, 1, 1e-7) << entry.name << " at " << period;
        }
        for (double const period : {0.16, 1.1, 1.28, 2.0, 3.0, 3.5, 4.0, 5.0, 5.5, 6.0, 7.5, 8.0, 10.0}) {
            EXPECT_NEAR(target.psa_mps2(period * (1 + 1e-12)) / target.psa_mps2(period), 1, 1e-9) << entry.name;
        }
    }
}

// Table I of the guide, and its ground displacement of 36 inches for 1 g.
TEST(TargetSpectrum, RegulatoryGuideControlPoints) {
    struct Row {
        double damping, at_9, at_2_5, at_0_25;
    };
    for (auto const& row : {Row{0.005, 4.96, 5.95, 3.20}, Row{0.02, 3.54, 4.25, 2.50}, Row{0.05, 2.61, 3.13, 2.05},
                            Row{0.07, 2.27, 2.72, 1.88}, Row{0.10, 1.90, 2.28, 1.70}}) {
        auto const target = named("rg-1.60", {.damping = row.damping, .pga_mps2 = 3.0});
        EXPECT_TRUE(near(target.psa_mps2(1 / 33.0), 3.0, exact_formula));
        EXPECT_TRUE(near(target.psa_mps2(0.011), 3.0, exact_formula));
        EXPECT_TRUE(near(target.psa_mps2(1 / 9.0), 3.0 * row.at_9, exact_formula));
        EXPECT_TRUE(near(target.psa_mps2(0.4), 3.0 * row.at_2_5, exact_formula));
        double const displacement = row.at_0_25 * 0.9144 * 3.0 / g0;
        for (double const period : {4.0, 7.0, 10.0}) {
            double const w = 2 * pi / period;
            EXPECT_TRUE(near(target.psa_mps2(period) / (w * w), displacement, exact_formula));
        }
    }
    EXPECT_TRUE(near(named("rg-1.60").psa_mps2(4.0) / g0, 0.4716, testing::Tolerance{1e-3, "printed"}));
}

// The guide's own words on its vertical spectra: two thirds of the horizontal below 0.25 Hz, equal above 3.5 Hz.
TEST(TargetSpectrum, RegulatoryGuideVerticalIsInItsStatedProportion) {
    constexpr testing::Tolerance table_digits{0.004, "two decimals of table II"};
    for (double const damping : {0.005, 0.02, 0.05, 0.07, 0.10}) {
        auto const vertical = named("rg-1.60-vertical", {.damping = damping, .pga_mps2 = 2.0});
        auto const horizontal = named("rg-1.60", {.damping = damping, .pga_mps2 = 2.0});
        for (double const period : {4.0, 6.0, 10.0}) {
            EXPECT_TRUE(near(vertical.psa_mps2(period) / horizontal.psa_mps2(period), 2.0 / 3, table_digits));
        }
        for (double const period : {0.01, 1 / 33.0, 0.05, 1 / 9.0, 0.2, 1 / 3.5}) {
            EXPECT_TRUE(near(vertical.psa_mps2(period), horizontal.psa_mps2(period), table_digits)) << period;
        }
    }
    EXPECT_TRUE(near(named("rg-1.60-vertical").psa_mps2(1 / 3.5) / g0, 2.98, exact_formula));
}

TEST(TargetSpectrum, UntabulatedDampingIsRefused) {
    expect_input_error([] { (void)named("rg-1.60", {.damping = 0.03, .pga_mps2 = {}}); }, "damping 0.03", "tabulated");
    expect_input_error([] { (void)named("mlit-ka1", {.damping = 0.02, .pga_mps2 = {}}); }, "damping 0.02", "0.05 only");
    expect_input_error([] { (void)named("mlit-ka1", {.pga_mps2 = 1}); }, "Use scale");
    expect_input_error([] { (void)named("mlit-ch3"); }, "Did you mean 'mlit-ch1'");
}

TEST(TargetSpectrum, ContinuesBeyondItsEndsAndReportsIt) {
    auto const target = named("mlit-ch1");

    EXPECT_FALSE(target.defined_at(10.001));
    EXPECT_TRUE(target.defined_at(10));
    EXPECT_TRUE(near(target.psa_mps2(20), 0.512 / 4, exact_formula));  // constant displacement
}

//
TEST(TargetSpectrum, SimilarityShortensPeriodsOnly) {
    auto const model = named("mlit-ch1").at_time_scale(0.632);

    EXPECT_TRUE(near(model.psa_mps2(6 * 0.632), 1.28, exact_formula));
    EXPECT_TRUE(near(model.last_period_s(), 6.32, exact_formula));
    EXPECT_TRUE(near(model.scaled(2).psa_mps2(0.5 * 0.632), 16, exact_formula));
}

TEST(TargetSpectrum, TableIsStraightInLogLog) {
    auto const target = parse_target_table("# T  Sv [m/s]\n0.1, 0.2\r\n1.0  2.0   ! knee\n\n10 2.0\n", "t.csv",
                                           TargetKind::pseudo_velocity, 0.02);

    EXPECT_TRUE(near(target.psv_mps(0.1), 0.2, exact_formula));
    EXPECT_TRUE(near(target.psv_mps(0.3), 0.6, exact_formula));
    EXPECT_TRUE(near(target.psv_mps(3), 2.0, exact_formula));
    EXPECT_TRUE(near(target.psa_mps2(0.01), target.psa_mps2(0.1), exact_formula));
    EXPECT_EQ(target.damping(), 0.02);
}

TEST(TargetSpectrum, OneLineOfNamesMayStandAboveATable) {
    for (char const* names :
         {"T,Sv\n", "period (s), psv (m/s)\r\n", "\xEF\xBB\xBFPeriod;Sv\n", "# note\n\"T\" \"Sv\"\n"}) {
        auto const target = parse_target_table(names + std::string("0.1, 0.2\n1.0; 2.0\n"), "t.csv",
                                               TargetKind::pseudo_velocity, 0.02, 1.0);
        EXPECT_TRUE(near(target.psv_mps(0.3), 0.6, exact_formula)) << names;
    }
    auto const parse = [](char const* text) {
        (void)parse_target_table(text, "t.csv", TargetKind::acceleration, 0.05);
    };
    expect_input_error([&] { parse("0.1 1\nT,Sa\n1 1\n"); }, "t.csv:2: 'T' in column 1");
    expect_input_error([&] { parse("nan 1\n1 1\n"); }, "t.csv:1: 'nan' in column 1");
    expect_input_error([&] { parse("0.1,\n1 1\n"); }, "t.csv:1: '' in column 2");
    expect_input_error([&] { parse("T,Sa\n"); }, "t.csv:1: no row of numbers", "two columns, period and value");
}

// the units of a target's table are those of its header or those stated, never SI whatever they say.
TEST(TargetSpectrum, UnitsOfTheHeaderAreRead) {
    std::string const rows = "0.02,300\n0.1,700\n1,500\n10,80\n";
    auto const peak = [&](std::string const& header, TargetKind kind = TargetKind::acceleration,
                          std::optional<double> unit = {}) {
        auto const target = parse_target_table(header + rows, "t.csv", kind, 0.05, unit);
        return kind == TargetKind::acceleration ? target.psa_mps2(0.1) : target.psv_mps(0.1);
    };
    for (char const* header : {"period [s],Sa [gal]\n", "# period_s,sa_cmps2\n", "T (s) Sa (cm/s2)\n", "T;Sa_gal\n",
                               "# T  Sa [Gal]\n", "T [s]\tSa [cm/sec/sec]\n", "# Sa in gal\n", "# Sa in gal\nT,Sa\n"}) {
        EXPECT_TRUE(near(peak(header), 7, exact_formula)) << header;
    }
    EXPECT_TRUE(near(peak("T,Sa [g]\n"), 700 * g0, exact_formula));
    EXPECT_TRUE(near(peak("T,Sa_g\n"), 700 * g0, exact_formula));
    EXPECT_TRUE(near(peak("T,Sv [kine]\n", TargetKind::pseudo_velocity), 7, exact_formula));
    for (char const* header : {"T [s],Sa [m/s2]\n", "# period_s,sa_mps2\n"}) {
        EXPECT_TRUE(near(peak(header), 700, exact_formula)) << header;
    }
    for (char const* header : {"# 5% damped, units g\nT,Sa\n", "Design spectrum in g\nT,Sa\n", "# units: g\n"}) {
        EXPECT_TRUE(near(peak(header), 700 * g0, exact_formula)) << header;
    }
    for (char const* header : {"", "T,Sa\n", "# a table of 300 gal\n", "# after (Smith 1990), 5 % (see text)\n"}) {
        expect_input_error([&] { (void)peak(header); }, "t.csv:", "unit of the ordinates missing",
                           "State unit = \"g\"");
    }
    EXPECT_TRUE(near(peak("T,Sa\n", TargetKind::acceleration, 0.01), 7, exact_formula));
    EXPECT_TRUE(near(peak("T,Sa [gal]\n", TargetKind::acceleration, 0.01), 7, exact_formula));
    auto const refuse = [&](std::string const& header, TargetKind kind, std::optional<double> unit, char const* part) {
        expect_input_error([&] { (void)peak(header, kind, unit); }, "t.csv:1: ", part);
    };
    refuse("T,Sa [gal]\n", TargetKind::acceleration, g0, "contradict");
    refuse("T,Sa [gal]\n", TargetKind::pseudo_velocity, {}, "'Sa [gal]' where kind says velocity");
    refuse("T,Sa [gal]\n", TargetKind::pseudo_velocity, 0.01, "'Sa [gal]' where kind says velocity");
    refuse("T,Sa [counts]\n", TargetKind::acceleration, {}, "'counts'");
    EXPECT_TRUE(near(peak("T,Sa [counts]\n", TargetKind::acceleration, 0.3), 700 * 0.3, exact_formula));
    EXPECT_TRUE(near(peak("T,Sa [ft/s2]\n"), 700 * 0.3048, exact_formula));
    refuse("T,Sv\n", TargetKind::acceleration, 0.01, "'Sv' where kind says acceleration");
    refuse("T,log Sa (g)\n", TargetKind::acceleration, {}, "a logarithm of which base?");
    expect_input_error([&] { (void)peak("# units g\nT,Sa [gal]\n"); }, "t.csv:1: unit g, line 2 says gal");
    refuse("T [days],Sa [gal]\n", TargetKind::acceleration, {}, "of the periods");
    EXPECT_TRUE(near(
        parse_target_table("T [ms],Sa [gal]\n100,300\n1000,700\n", "t", TargetKind::acceleration, 0.05).psa_mps2(0.1),
        3, exact_formula));
}

// frequencies, ln Sa and a row at period 0 are read as what they are.
TEST(TargetSpectrum, FrequenciesLogarithmsAndThePga) {
    auto const read = [](std::string const& text) {
        return parse_target_table(text, "t.csv", TargetKind::acceleration, 0.05);
    };
    for (char const* names : {"f,Sa [gal]\n", "Frequency (Hz),Sa [gal]\n", "f [Hz]  Sa [gal]\n"}) {
        auto const target = read(names + std::string("0.1,80\n1,500\n10,700\n50,300\n"));
        EXPECT_TRUE(near(target.psa_mps2(0.02), 3, exact_formula)) << names;
        EXPECT_TRUE(near(target.psa_mps2(1), 5, exact_formula)) << names;
        EXPECT_EQ(target.last_period_s(), 10) << names;
    }
    auto const logarithms = read("T (s),ln Sa (g)\n0.1,0\n1,-0.6931471805599453\n");
    EXPECT_TRUE(near(logarithms.psa_mps2(0.1), g0, exact_formula));
    EXPECT_TRUE(near(logarithms.psa_mps2(1), 0.5 * g0, exact_formula));
    auto const code =
        read("\xEF\xBB\xBF\"<i>T</i>(s)\",\"<i>S</i>\xE2\x82\x90(g)\"\n0,0.346\n0.05,0.764\n0.1,0.865\n1,0.3\n");
    EXPECT_TRUE(near(code.psa_mps2(0.025), (0.346 + 0.764) / 2 * g0, exact_formula));
    EXPECT_TRUE(near(code.psa_mps2(0.05), 0.764 * g0, exact_formula));
    EXPECT_EQ(code.name(), "t.csv");
    EXPECT_EQ(code.remarks(), std::vector<std::string>{"t.csv: the row at period 0, 3.393 m/s2, is the PGA; a straight "
                                                       "line joins it to the next row"});
    expect_input_error([&] { (void)read("T,Sa [g]\n0,0\n0.1,1\n1,1\n"); }, "t.csv:2: ", "ordinate 0");
    expect_input_error([&] { (void)read("f,Sa [g]\n0,1\n1,1\n2,1\n"); }, "t.csv:2: ", "frequency 0");
}

TEST(TargetSpectrum, BadTablesNameTheLine) {
    auto const parse = [](char const* text) {
        (void)parse_target_table(text, "t.csv", TargetKind::acceleration, 0.05, 1.0);
    };
    expect_input_error([&] { parse("0.1 1\n0.2 0\n"); }, "t.csv:2: ", "ordinate 0");
    expect_input_error([&] { parse("0.1 1\n#\n0.1 2\n"); }, "t.csv:3: ", "periods must rise");
    expect_input_error([&] { parse("0.1 1\n0.2 x\n"); }, "t.csv:2: 'x' in column 2");
    expect_input_error([&] { parse("0.1 1 2\n"); }, "t.csv:1: a row of 3 (it must be of 2 numbers)");
    expect_input_error([&] { parse("0.1\n"); }, "t.csv:1: a row of 1 (it must be of 2 numbers)");
    expect_input_error([&] { parse("0.1 1\n0.2\n"); }, "t.csv:2: a row of one number");
    expect_input_error([&] { parse("0.1 1\n0.2\n0.3 1\n"); }, "t.csv:2: a row of 1 where the first has 2");
    for (char const* none : {"nan", "inf", "NA", "-"}) {
        expect_input_error([&] { parse(fmt::format("0.1 {}\n0.2 1\n", none).c_str()); },
                           fmt::format("t.csv:1: '{}' in column 2", none));
    }
    expect_input_error([&] { parse("1 1\n"); }, "at least two");
}

TEST(TargetSpectrum, CampaignStatesItInThreeWays) {
    InputFiles files(
        std::map<std::string, std::string>{{"sv.csv", "0.1 1\n1 1\n"}, {"si.csv", "# m/s2\n0.1 1\n1 1\n"}});
    auto const read = [&](char const* text) { return read_target(config::Table::parse(text, "c.toml"), files); };

    EXPECT_TRUE(near(read("spectrum='rg-1.60'\npga='0.3 g'").psa_mps2(0.02), 0.3 * g0, exact_formula));
    EXPECT_TRUE(near(read("kind='pseudo-velocity'\npoints=[[0.1,'20 kine'],[1,'0.2 m/s']]\nscale=2").psv_mps(0.5), 0.4,
                     exact_formula));
    EXPECT_TRUE(near(read("kind='acceleration'\nunit='m/s2'\nfile='sv.csv'\ntime_scale=0.5").last_period_s(), 0.5,
                     exact_formula));
    EXPECT_TRUE(
        near(read("kind='pseudo-velocity'\nunit='kine'\npoints=[[0.1,20],[1,20]]").psv_mps(0.5), 0.2, exact_formula));
    EXPECT_TRUE(near(read("kind='acceleration'\nunit='gal'\nfile='sv.csv'").psa_mps2(0.5), 0.01, exact_formula));
    expect_input_error([&] { (void)read("kind='acceleration'\nunit='kine'\nfile='sv.csv'"); },
                       "c.toml:2:", "not a unit of acceleration");
    expect_input_error([&] { (void)read("kind='acceleration'\nunit='gal'\npoints=[[0.1,'1 g'],[1,2]]"); },
                       "c.toml:3:", "pure number");
    expect_input_error([&] { (void)read("damping=0.05"); }, "c.toml:", "exactly one of");
    expect_input_error([&] { (void)read("kind='acceleration'\nfile='no.csv'"); }, "c.toml:2:", "no.csv");
    expect_input_error([&] { (void)read("kind='acceleration'\npoints=[[0.1,1],[1,-1]]"); }, "c.toml:2:", "ordinate -1");
    expect_input_error([&] { (void)read("spectrum='mlit-ch1'\ndamping=0.1"); }, "c.toml:1:", "0.05 only");
}

// a unit among other words is none of the ordinates, also where none is expected to be stated.
TEST(TargetText, AUnitAmongOtherWordsIsAskedFor) {
    for (char const* line :
         {"# not in gal", "# range in gal", "# units: g (x 9.81 = m/s2)", "# Sa = column x 981 (gal)"}) {
        for (bool const silence_is_si : {false, true}) {
            testing::expect_input_error(
                [&] {
                    (void)parse_target_table(fmt::format("{}\nT,Sa\n0.1,3\n1,7\n", line), "t", TargetKind::acceleration,
                                             0.05, {}, silence_is_si);
                },
                "among other words");
        }
    }
    EXPECT_EQ(parse_target_table("# spectral acceleration in gal, 5 % damping\nT,Sa\n0.1,300\n1,700\n", "t",
                                 TargetKind::acceleration, 0.05)
                  .psa_mps2(0.1),
              3);
}

// an operation in the name of the ordinates is refused.
TEST(TargetText, OperationsInNamesAreRefused) {
    for (char const* name : {"Sa(g)/1.5", "Sa [g] x 0.5", "Sa/R [g]", "S/ag [g]", "Sa*1.5 [g]", "SRSS Sa [g]"}) {
        testing::expect_input_error(
            [&] {
                (void)parse_target_table(fmt::format("T,{}\n0.1,3\n1,7\n", name), "t", TargetKind::acceleration, 0.05);
            },
            "t:1: ");
    }
}

}  // namespace
}  // namespace overturn
