// Requirement R-104: the names and the text of a target's table say what its columns are; what they call something else
// is refused, whatever unit and kind are stated.
#include "spectra/detail/target_names.hpp"

#include <cmath>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/units.hpp"
#include "support/expect_input_error.hpp"
#include "support/tolerance.hpp"

namespace overturn {
namespace {

using testing::exact_formula;
using testing::expect_input_error;
using testing::near;

TargetSpectrum read(std::string const& head, TargetKind kind = TargetKind::acceleration) {
    return parse_target_table(head + "0.1,0.7\n1,0.5\n10,0.08\n", "t.csv", kind, 0.05, 1.0);
}

std::string remarks_on(TargetSpectrum const& target) { return fmt::format("{}", fmt::join(target.remarks(), "|")); }

TEST(TargetNames, FirstColumnsArePeriodsOrFrequencies) {
    for (char const* name :
         {"T", "t", "T*", "T_n", "Tn", "period", "P\xE9riode (s)", "\xE5\x91\xA8\xE6\x9C\x9F", "T (s)"}) {
        EXPECT_TRUE(near(read(fmt::format("{},Sa\n", name)).psa_mps2(0.1), 0.7, exact_formula)) << name;
    }
    EXPECT_TRUE(near(read("freq,Sa\n").psa_mps2(10), 0.7, exact_formula));
    for (char const* name : {"omega", "index", "No", "rate", "Sa", "time", "ln T", "log T", "lnT", "time (s)"}) {
        expect_input_error([&] { (void)read(fmt::format("{},Sa\n", name)); }, "t.csv:1: '", "a period or a frequency");
    }
}

TEST(TargetNames, SecondColumnsAreOrdinatesOfTheKind) {
    for (char const* name : {"Sa", "PSA", "spectral acceleration", "Se", "value", "Sa(T)"}) {
        EXPECT_NO_THROW((void)read(fmt::format("T,{}\n", name))) << name;
    }
    for (char const* name : {"hazard", "poe", "annual rate", "PGA", "FAS", "counts", "sigma", "ratio", "T", "V", "D",
                             "Sa/PGA", "Sa normalised", "velocity", "\xE9\x80\x9F\xE5\xBA\xA6", "Sa,sigma"}) {
        expect_input_error([&] { (void)read(fmt::format("T,{}\n", name)); }, "t.csv:1: ");
    }
    EXPECT_NO_THROW((void)read("T,V\n", TargetKind::pseudo_velocity));
    expect_input_error([] { (void)read("T,PGV (m/s2)\n"); }, "t.csv:1: 'PGV");
    expect_input_error([] { (void)read("T,Sa 2% damping\n"); }, "t.csv:1: damping 0.02");
    for (char const* name : {"Se(T) [m/s^2]", "Se(T)(m/s\xC2\xB2)", "Sa(T) (5 % damped) (m/s2)"}) {
        EXPECT_TRUE(near(read(fmt::format("T(s),{}\n", name)).psa_mps2(0.1), 0.7, exact_formula)) << name;
    }
    for (char const* name : {"ln Sa", "lnSa", "ln(Sa)", "ln_Sa"}) {
        EXPECT_TRUE(near(read(fmt::format("T,{}\n", name)).psa_mps2(0.1), std::exp(0.7), exact_formula)) << name;
    }
}

TEST(TargetNames, TextMayNotContradict) {
    for (char const* line : {"# pseudo velocity", "# velocity response", "# displacement", "# hazard curve",
                             "# units: cm/s", "# units: counts"}) {
        expect_input_error([&] { (void)read(std::string(line) + "\nT,Sa\n"); }, "t.csv:1: ", "says the text");
    }
    EXPECT_NO_THROW((void)read("# pseudo velocity\nT,Sv\n", TargetKind::pseudo_velocity));
    for (char const* line : {"# response spectrum, h = 0.05", "# 10 % in 50 years, 5 % damped",
                             "# damping 5 %, 2 % in 50 a", "# intensity measure: Sa"}) {
        EXPECT_NO_THROW((void)read(std::string(line) + "\nT,Sa\n")) << line;
    }
    for (char const* line : {"# damping 2%", "# 2 % damped", "# h = 0.02", "# damping ratio 0.02", "# zeta=0.02"}) {
        expect_input_error([&] { (void)read(std::string(line) + "\nT,Sa\n"); }, "t.csv:1: damping 0.02 in the text");
    }
    // A comment beside the names is text too.
    expect_input_error([] { (void)read("T,Sa # damping 2 %\n"); }, "t.csv:1: damping 0.02 in the text");
    expect_input_error(
        [] {
            (void)parse_target_table("T,Sa\n0.1,1\n1,1\n# units: gal\n", "t.csv", TargetKind::acceleration, 0.05, g0);
        },
        "t.csv:4: unit gal in the file, g stated");
}

// R-104: units of the kind are heard in the text, in any row of units, and every other line is reported.
TEST(TargetNames, EveryLineOfTextIsAccountedFor) {
    auto const parse = [](std::string const& head, TargetKind kind) {
        return parse_target_table(head + "0.1,70\n1,50\n10,8  # the end\n", "t.csv", kind, 0.05);
    };
    for (char const* head : {"# pseudo-velocity, units: cm/s\nT,Sv\n", "T,Sv\n(s),(cm/s)\n", "# Sv in kine\n",
                             "Velocity spectrum\n# kine\n"}) {
        EXPECT_TRUE(near(parse(head, TargetKind::pseudo_velocity).psv_mps(0.1), 0.7, exact_formula)) << head;
    }
    EXPECT_TRUE(near(parse("# displacement (cm)\n", TargetKind::displacement).psv_mps(1), 2 * pi * 0.5, exact_formula));
    auto const target = parse("Smith 2001\n# 5 % damped\nT (s),Sa (gal)\n", TargetKind::acceleration);
    EXPECT_EQ(remarks_on(target), "t.csv (not understood: line 1: 'Smith 2001'; line 6: '# the end')");
    EXPECT_EQ(target.name(), "t.csv");  // of legends and tables
    for (char const* head : {"# units: gal\nT,Sv (cm/s)\n", "# Acceleration response spectrum\nT,S (cm/s)\n"}) {
        expect_input_error([&] { (void)parse(head, TargetKind::pseudo_velocity); }, "t.csv:1: ");
    }
    expect_input_error(
        [&] { (void)parse("# Pseudo-velocity response spectrum\nT,S (gal)\n", TargetKind::acceleration); },
        "t.csv:1: a spectrum of velocity");
    expect_input_error([&] { (void)parse("# units: g/10\nT,S\n", TargetKind::acceleration); }, "t.csv:1: 'g/10'");
}

// R-104: units alone are not passed over: frequencies are none of periods.
TEST(TargetNames, UnitsAloneAreHeard) {
    auto const parse = [](std::string const& head) {
        return parse_target_table(head + "0.1,70\n1,50\n10,8\n", "t.csv", TargetKind::acceleration, 0.05);
    };
    EXPECT_TRUE(near(parse("(Hz),(gal)\n").psa_mps2(10), 0.7, exact_formula));
    EXPECT_TRUE(near(parse("Hz;gal\n").psa_mps2(10), 0.7, exact_formula));
    EXPECT_TRUE(near(parse("s,gal\n").psa_mps2(0.1), 0.7, exact_formula));
    EXPECT_TRUE(near(parse("ms,gal\n").psa_mps2(1e-4), 0.7, exact_formula));
    expect_input_error([&] { (void)parse("s,cm/s\n"); }, "t.csv:1: ");
}

// R-104: prose is no pair of names, and names of more columns are not cut to two.
TEST(TargetNames, ProseIsNotTakenForNames) {
    for (char const* line : {"Response spectrum\n", "# Kobe, 1995\n", "Design spectrum, soft soil\n# T,Sa\n"}) {
        EXPECT_TRUE(near(read(line).psa_mps2(0.1), 0.7, exact_formula)) << line;
    }
    for (char const* line : {"T Sa sigma\n", "T;Sa;sigma\n", "# T (s)  Sa (g)  Sd (cm)\n"}) {
        expect_input_error([&] { (void)read(line); }, "t.csv:1: ", "another number");
    }
}

TEST(TargetNames, OtherFilesAreNamed) {
    auto const refuse = [](std::string const& text, char const* part) {
        expect_input_error([&] { (void)parse_target_table(text, "t", TargetKind::acceleration, 0.05, g0); },
                           "t: ", part);
    };
    refuse("{\"response\": {\"periods\": [0, 1]}}", "JSON");
    refuse(std::string("T\0,\0", 4), "UTF-16");
}

// R-104: uniform hazard spectra as OpenQuake exports them are in g, their PGA at period 0.
TEST(TargetNames, UniformHazardSpectraAreRead) {
    std::string const first = "#,,,,,\"generated_by='OpenQuake engine 3.11', investigation_time=50.0\"\n";
    auto const parse = [](std::string const& text) {
        return parse_target_table(text, "u.csv", TargetKind::acceleration, 0.05);
    };
    auto const target = parse(first + "lon,lat,0.1~PGA,0.1~SA(1.0),0.1~SA(0.1)\n-122.0,38.0,3.1E-01,2.0E-01,7.0E-01\n");
    EXPECT_TRUE(near(target.psa_mps2(0.1), 0.7 * g0, exact_formula));
    EXPECT_TRUE(near(target.psa_mps2(0.05), (0.31 + 0.7) / 2 * g0, exact_formula));
    EXPECT_EQ(target.last_period_s(), 1);
    EXPECT_EQ(remarks_on(target).find("not understood"), std::string::npos) << remarks_on(target);
    for (char const* kind : {"quantile-0.16", "rlz-003", "std"}) {
        auto const other =
            parse(fmt::format("#,,\"generated_by='OpenQuake engine', kind='{}', investigation_time=50.0\"\n"
                              "lon,lat,0.1~PGA,0.1~SA(1.0)\n1,2,0.3,0.2\n",
                              kind));
        EXPECT_TRUE(
            remarks_on(other).ends_with(fmt::format("u.csv (not understood: line 1: '# kind {}, not mean')", kind)))
            << remarks_on(other);
    }
    auto const mean = parse("#,,\"kind='mean', investigation_time=50.0\"\nlon,lat,0.1~PGA,0.1~SA(1.0)\n1,2,0.3,0.2\n");
    EXPECT_EQ(remarks_on(mean).find("not understood"), std::string::npos) << remarks_on(mean);
    expect_input_error([&] { (void)parse(first + "lon,lat,0.1~PGA,0.02~PGA,0.1~SA(1.0)\n1,2,3,4,5\n"); },
                       "u.csv:2: ", "several probabilities");
    expect_input_error([&] { (void)parse(first + "lon,lat,0.1~PGA,0.1~SA(1.0)\n1,2,3,4\n1,2,3,4\n"); },
                       "u.csv:4: ", "one site");
}

// R-104: the damping of a column counts as that of the text does; other words that change a spectrum are listed.
TEST(TargetNames, WordsThatChangeASpectrumAreAccountedFor) {
    for (char const* name : {"Sa(10%) (m/s2)", "SA_10pct_damping (m/s2)", "h=10% [m/s2]"}) {
        expect_input_error([&] { (void)read(fmt::format("Period (s),{}\n", name)); }, "t.csv:1: damping 0.1");
    }
    for (char const* text : {"# 5 % in 50 years, damping 2 %", "# UHS 5% in 50 years; damping ratio: 2 %",
                             "# 5 % in 50 years, damping = 0.02", "# 2 percent of critical damping", "# xi = 2 %",
                             "# spectrum, 2 percent of critical"}) {
        expect_input_error([&] { (void)read(fmt::format("{}\nT,Sa\n", text)); }, "t.csv:1: damping 0.02");
    }
    for (char const* text :
         {"# vertical spectrum", "# vertical", "# PGA = 0.35 g", "# PGA of 0.4 g", "# spectrum x 0.01",
          "# spectrum at damping two percent", "# response spectrum of the vertical component",
          "# floor spectrum at 20 m", "# damping 5 % and 2 %", "# spectrum, 84th percentile",
          "# 5 % damped spectrum of the vertical component"}) {
        EXPECT_NE(remarks_on(read(fmt::format("{}\nT,Sa\n", text))).find("not understood: line 1"), std::string::npos)
            << text;
    }
    for (char const* text : {"# response spectrum", "# 5 % damped", "# zeta=0.05, 2% in 50 yr",
                             "# 10 % in 50 years, damping 5 %", "# acceleration response spectrum"}) {
        EXPECT_EQ(remarks_on(read(fmt::format("{}\nT,Sa\n", text))), "") << text;
    }
    expect_input_error([] { (void)read("# Fourier spectrum\nT,Sa\n"); }, "t.csv:1: '# Fourier", "no response spectrum");
    for (char const* name :
         {"V_E (m/s)", "Ve (m/s)", "energy velocity (m/s)", "Veq (m/s)", "V-E (m/s)", "SV_E (m/s)"}) {
        expect_input_error([&] { (void)read(fmt::format("T,{}\n", name), TargetKind::pseudo_velocity); }, "t.csv:1: '",
                           "an energy spectrum");
        EXPECT_NO_THROW((void)read(fmt::format("T,{}\n", name), TargetKind::energy_velocity)) << name;
    }
}

// R-104: words in the ordinates' name that may change them are listed; those of a horizontal spectrum are not.
TEST(TargetNames, WordsOfAColumnsNameAreAccountedFor) {
    for (char const* name : {"Sa_vertical", "Sa84",   "Sa_floor", "Sa_2pc",     "SaZ",      "Sa_V",
                             "SAz",         "Sa_UD",  "Sa p84",   "Sa (84%)",   "FRS",      "vertical_acceleration",
                             "Sve",         "S_ve",   "Svert",    "V-spectrum", "delta Sa", "Sa error",
                             "Sa_x100",     "Sa V/H", "Sa_median"}) {
        EXPECT_EQ(remarks_on(read(fmt::format("T,{} (m/s2)\n", name))),
                  fmt::format("t.csv (not understood: line 1: '{} (m/s2)')", name));
    }
    for (char const* name : {"Sa", "S_a", "Sa(T)", "SaH", "Sa_NS", "SaRotD50", "PSA", "Sa (5%)", "Sa_5pct_damping",
                             "Sa zeta=0.05", "Sa_design", "value", "Spectral acceleration"}) {
        EXPECT_EQ(remarks_on(read(fmt::format("T,{} (m/s2)\n", name))), "") << name;
    }
    EXPECT_EQ(remarks_on(read("T,S_v (m/s)\n", TargetKind::pseudo_velocity)), "");
}

// R-104: the level of a hazard in a name is no damping, and is listed; a damping beside it is read still.
TEST(TargetNames, LevelsOfHazardAreNoDamping) {
    for (char const* name :
         {"Sa 10% in 50 years (m/s2)", "Sa 10%/50yr (m/s2)", "Sa (10% in 50 yr) (m/s2)", "10% PE in 50 years (m/s2)",
          "Sa 2% probability of exceedance in 50 years (m/s2)", "Sa 5% damped 10% in 50 years (m/s2)",
          "Sa_2475yr (m/s2)", "Sa 84th (m/s2)", "Sa quantile-0.16 (m/s2)"}) {
        EXPECT_NE(remarks_on(read(fmt::format("T,{}\n", name))).find("not understood: line 1: '"), std::string::npos)
            << name;
    }
    for (char const* name :
         {"Sa 2% damped 10% in 50 years (m/s2)", "Sa 10% in 50 years xi=2% (m/s2)", "Sa 2% (m/s2)"}) {
        expect_input_error([&] { (void)read(fmt::format("T,{}\n", name)); }, "t.csv:1: damping 0.02");
    }
    for (char const* text : {"# 84th", "# 2475 yr", "# 10 % in 50 years", "# kind='quantile-0.16'"}) {
        EXPECT_NE(remarks_on(read(fmt::format("{}\nT,Sa\n", text))).find("not understood: line 1"), std::string::npos)
            << text;
    }
}

// R-104: seconds as Turkish, Spanish, German and Japanese tables call them.
TEST(TargetNames, SecondsOfOtherLanguages) {
    for (char const* name : {"Periyot (sn)", "Periodo (seg)", "T [Sek]", "\xE5\x91\xA8\xE6\x9C\x9F(\xE7\xA7\x92)"}) {
        EXPECT_TRUE(near(read(fmt::format("{},Sa\n", name)).psa_mps2(0.1), 0.7, exact_formula)) << name;
    }
}

// R-104: what a spectrum scatters by is no spectrum.
TEST(TargetNames, SpreadsAreNoOrdinates) {
    for (char const* name : {"Sa uncertainty", "Sa_sigma", "dispersion", "ln std"}) {
        expect_input_error([&] { (void)read(fmt::format("T,{}\n", name)); }, "t.csv:1: '", "no ordinate");
    }
}

// R-104: text that speaks of frequencies above periods, of periods above frequencies, or of another unit.
TEST(TargetNames, TextOfTheFirstColumnMayNotContradict) {
    for (char const* text : {"# frequency in Hz", "# Frequencies (Hz)", "# f in Hz", "# first column frequency",
                             "# periods in ms", "# T in ms", "# period [ms], Sa"}) {
        expect_input_error([&] { (void)read(fmt::format("{}\nT (s),Sa\n", text)); }, "t.csv:1: '#", "contradict");
    }
    for (char const* text : {"# frequency in Hz", "# T in ms", "# periods in milliseconds"}) {
        expect_input_error([&] { (void)read(fmt::format("{}\n", text)); }, "t.csv:1: '#");
    }
    for (char const* text : {"# period in s", "# T [s]"}) {
        expect_input_error([&] { (void)read(fmt::format("{}\nf (Hz),Sa\n", text)); }, "t.csv:1: '#", "contradict");
        EXPECT_NO_THROW((void)read(fmt::format("{}\nT (s),Sa\n", text))) << text;
    }
    for (char const* text : {"# T in ms", "# periods in ms"}) {
        EXPECT_NO_THROW((void)read(fmt::format("{}\nT (ms),Sa\n", text))) << text;
    }
    for (char const* text : {"# return period 475 years", "# annual frequency 0.002", "# corner frequency 0.1 Hz",
                             "# frequency in Hz or period in s", "# natural frequency 2 Hz"}) {
        EXPECT_NO_THROW((void)read(fmt::format("{}\nT (s),Sa\n", text))) << text;
    }
    EXPECT_NO_THROW((void)read("# frequency in Hz\nf (Hz),Sa\n"));
}

// R-104: a spectrum of Fourier amplitudes is none of a response, and a letter says which component it is.
TEST(TargetNames, AbbreviationsAreHeard) {
    for (char const* line : {"# FAS", "# FAS, smoothed", "# HVSR", "# power spectral density"}) {
        expect_input_error([&] { (void)read(std::string(line) + "\nT,a\n"); }, "t.csv:1: '#", "no response spectrum");
    }
    for (char const* line : {"# PSV", "# type: PSV", "# quantity: Sv", "# PSV of Kobe"}) {
        expect_input_error([&] { (void)read(std::string(line) + "\nT,a\n"); }, "t.csv:1: a spectrum of velocity");
    }
    EXPECT_NO_THROW((void)read("# state: SD\nT,a\n"));
    EXPECT_EQ(remarks_on(read("# component: Z\nT,a\n")), "t.csv (not understood: line 1: '# component: Z')");
}

// R-104: what stands beside a damping in its line is accounted for word by word.
TEST(TargetNames, ADampingHidesNothingBesideIt) {
    for (char const* text :
         {"# 5 % damped, mean plus one standard deviation", "# 5 % damped, 84 % NEP", "# 5 % damped, times 1.5",
          "# 5 % damped, envelope of 3 sites", "# 5 % damped at 2/3 of MCE", "# 5 % damped, node 312",
          "# 5 % damped, q = 1.5", "# 5 % damped, Z direction", "# 5 % damped, SRSS of two", "# DSP 5 % damped",
          "# 5 % damped, periods in ms", "# 5 % damped, probability of exceedance 84 %"}) {
        EXPECT_NE(remarks_on(read(fmt::format("{}\nT,Sa\n", text))).find("not understood: line 1"), std::string::npos)
            << text;
    }
    for (char const* text :
         {"# 5 % damped elastic acceleration response spectrum", "# UHS, 10 % in 50 years, damping ratio 0.05",
          "# 5% of critical damping, return period 475 yr", "# pseudo-spectral acceleration, zeta = 0.05"}) {
        EXPECT_EQ(remarks_on(read(fmt::format("{}\nT,Sa\n", text))), "") << text;
    }
}

// R-104: periods and frequencies have their units: a quotient has none, and what is not known is refused.
TEST(TargetNames, UnitsOfTheFirstColumnAreKnown) {
    EXPECT_TRUE(near(read("f (kHz),Sa\n").psa_mps2(0.01), 0.7, exact_formula));
    EXPECT_TRUE(near(read("f (cps),Sa\n").psa_mps2(10), 0.7, exact_formula));
    for (char const* name : {"frequency [rad/s]", "f (1/min)", "T/T1", "T/ms", "f/f0"}) {
        expect_input_error([&] { (void)read(fmt::format("{},Sa\n", name)); }, "t.csv:1: ");
    }
}

// R-104: a factor beside a unit makes it none of the ordinates'.
TEST(TargetNames, UnitsWithFactorsAreNone) {
    for (char const* line : {"# in g / 10", "# Sa in g (x 0.01)", "# 100 x m/s2", "# acceleration in tenths of g"}) {
        expect_input_error(
            [&] {
                (void)parse_target_table(std::string(line) + "\nT,Sa\n0.1,1\n1,1\n", "t.csv", TargetKind::acceleration,
                                         0.05);
            },
            "t.csv:");
    }
}

// R-104: a unit beside the names counts; one that is not known is none, whatever is stated.
TEST(TargetNames, UnitsBesideNamesAreHeard) {
    auto const parse = [](std::string const& head, std::optional<double> unit) {
        return parse_target_table(head + "0.1,70\n1,50\n", "t.csv", TargetKind::acceleration, 0.05, unit);
    };
    EXPECT_TRUE(near(parse("T,Sa # units: gal\n", {}).psa_mps2(0.1), 0.7, exact_formula));
    expect_input_error([&] { (void)parse("# units: g/10\nT,S\n", g0); }, "t.csv:1: 'g/10'");
}

}  // namespace
}  // namespace overturn
