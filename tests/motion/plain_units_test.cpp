// Requirement R-107: a line of prose gives the unit of all numbers only where each of its words is known; among other
// words a unit is asked for, and the line is listed once it is stated.
#include <array>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/units.hpp"
#include "motion/text_statements.hpp"
#include "support/expect_input_error.hpp"
#include "support/read_record.hpp"

namespace overturn {
namespace {

using testing::expect_input_error;

constexpr auto among_others = std::to_array<char const*>({"# units: g (x 9.81 = m/s2)",
                                                          "# g: 9.81 (m/s2)",
                                                          "# g=981 (cm/s2)",
                                                          "# acceleration (g -> m/s2: 9.81)",
                                                          "# not in gal",
                                                          "# convert to gal before use",
                                                          "# must be converted to cm/s2",
                                                          "# gal = column times 981",
                                                          "# use 981 for gal",
                                                          "# resolution in gal",
                                                          "# range in gal",
                                                          "# noise (gal)",
                                                          "# baseline drift (m/s2)",
                                                          "# DC removed in gal",
                                                          "# previous version was in gal",
                                                          "# companion file ABC_gal.txt is in gal",
                                                          "# SI units m/s2 unless noted: g",
                                                          "# unit cm/s2 replaced by g",
                                                          "# to get gal multiply by 981",
                                                          "# converted from m/s2 to fractions of gravity",
                                                          "# intensities: gal; data: g",
                                                          "# station unit: gal"});

TEST(PlainUnits, AmongOtherWordsAUnitIsAskedFor) {
    for (char const* line : among_others) {
        auto const text = fmt::format("{}\ntime,acc\n0,10\n0.01,-20\n0.02,30\n0.03,-5\n", line);
        expect_input_error([&] { (void)read_placed(text, {.name = "a"}); }, "a:3: unit missing (line 1 names",
                           "among other words");
        auto const stated = read_placed(text, {.name = "a", .unit_mps2 = 1});
        EXPECT_EQ(stated.unit_mps2, 1) << line;
        ASSERT_EQ(stated.unread.size(), 1U) << line;
        EXPECT_TRUE(stated.unread.front().starts_with(fmt::format("line 1: '{}", std::string(line).substr(0, 20))));
    }
}

TEST(PlainUnits, OfKnownWordsALineIsAStatement) {
    constexpr double gal = 0.01;
    for (auto const& [line, si] : {std::pair{"# all data are in gal", gal},
                                   {"# EL CENTRO 1940, NS component, acceleration in g", g0},
                                   {"# Acceleration time history (cm/s/s), dt = 0.01 s", gal},
                                   {"# values of all columns [m/s2]", 1.0},
                                   {"# 4 samples of acceleration at 100 Hz sampling in gal", gal},
                                   {"# ground acceleration, unit: metre per second squared", 1.0},
                                   {"# Units are cm/sec^2, 8F10.3", gal}}) {
        TextStatements statements;
        statements.take(line, 1);
        EXPECT_EQ(statements.unit(), si) << line;
        EXPECT_TRUE(statements.doubt().empty()) << line;
    }
}

}  // namespace
}  // namespace overturn
