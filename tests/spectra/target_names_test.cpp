// Requirement R-104: the names and the text of a target's table say what its columns are; what they call something else
// is refused, whatever unit and kind are stated.
#include "spectra/detail/target_names.hpp"

#include <cmath>
#include <string>

#include <fmt/format.h>

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
        expect_input_error([&] { (void)read(fmt::format("T,{}\n", name)); }, "t.csv:1: '");
    }
    EXPECT_NO_THROW((void)read("T,V\n", TargetKind::pseudo_velocity));
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
    EXPECT_NO_THROW((void)read("# response spectrum, h = 0.05\nT,Sa\n"));
    for (char const* line : {"# damping 2%", "# 2 % damped", "# h = 0.02", "# damping ratio 0.02", "# zeta=0.02"}) {
        expect_input_error([&] { (void)read(std::string(line) + "\nT,Sa\n"); }, "t.csv:1: damping 0.02 in the text");
    }
    expect_input_error(
        [] {
            (void)parse_target_table("T,Sa\n0.1,1\n1,1\n# units: gal\n", "t.csv", TargetKind::acceleration, 0.05, g0);
        },
        "unit gal in the text");
}

TEST(TargetNames, OtherFilesAreNamed) {
    auto const refuse = [](std::string const& text, char const* part) {
        expect_input_error([&] { (void)parse_target_table(text, "t", TargetKind::acceleration, 0.05, g0); },
                           "t: ", part);
    };
    refuse("{\"response\": {\"periods\": [0, 1]}}", "JSON");
    refuse(std::string("T\0,\0", 4), "UTF-16");
}

// uniform hazard spectra as OpenQuake exports them are in g, their PGA at period 0.
TEST(TargetNames, UniformHazardSpectraAreRead) {
    std::string const first = "#,,,,,\"generated_by='OpenQuake engine 3.11', investigation_time=50.0\"\n";
    auto const parse = [](std::string const& text) {
        return parse_target_table(text, "u.csv", TargetKind::acceleration, 0.05);
    };
    auto const target = parse(first + "lon,lat,0.1~PGA,0.1~SA(1.0),0.1~SA(0.1)\n-122.0,38.0,3.1E-01,2.0E-01,7.0E-01\n");
    EXPECT_TRUE(near(target.psa_mps2(0.1), 0.7 * g0, exact_formula));
    EXPECT_TRUE(near(target.psa_mps2(0.05), (0.31 + 0.7) / 2 * g0, exact_formula));
    EXPECT_EQ(target.last_period_s(), 1);
    expect_input_error([&] { (void)parse(first + "lon,lat,0.1~PGA,0.02~PGA,0.1~SA(1.0)\n1,2,3,4,5\n"); },
                       "u.csv:2: ", "several probabilities");
    expect_input_error([&] { (void)parse(first + "lon,lat,0.1~PGA,0.1~SA(1.0)\n1,2,3,4\n1,2,3,4\n"); },
                       "u.csv:4: ", "one site");
}

}  // namespace
}  // namespace overturn
