// Requirement R-107: a column whose name says that its numbers were made of others, or are still to be, is refused.
#include "motion/operators_in_name.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/expect_input_error.hpp"
#include "support/read_record.hpp"

namespace overturn {
namespace {

TEST(OperatorsInNames, AreReported) {
    for (char const* name :
         {"a [gal]/10",    "Sa(g)/1.5",    "Sa [g] x 0.5",  "pga [g]/2",   "a/2 [gal]",         "a^2",
          "|a|",           "da/dt",        "ax+ay",         "Sa/R [g]",    "S/ag [g]",          "Sa*1.5 [g]",
          "half a [gal]",  "resultant",    "SRSS [g]",      "a_rel [gal]", "Sa_res [g]",        "Sa beta [g]",
          "a [gal] -9.81", "a \xC3\x97 2", "acc [gal] 10%", "Sa [g] 50 %", "Sa [g] 5 % of PGA", "PSA (g) x 2 %"}) {
        EXPECT_TRUE(tells_operation_in_name(name)) << name;
    }
    for (char const* name : {"a cm/s/s",
                             "acc_cm/s2",
                             "N/S",
                             "E/W (gal)",
                             "N-S [gal]",
                             "U-D",
                             "Sa(1.0 s) [g]",
                             "H1 [g]",
                             "Acceleration (m/s^2)",
                             "acc [gal] NS",
                             "a_horizontal",
                             "pseudo-acceleration (g)",
                             "PSA [5 %] (g)",
                             "RotD50 (g)",
                             "acc [m/s2] EW",
                             "residual",
                             "Time (s)",
                             "PSA (g) @ 5% damping",
                             "SA [g] 10% damping",
                             "Sa(g) 2%",
                             "Sa [g], 5 percent of critical",
                             "UHS [g] 2% in 50 years",
                             "UHS 2%/50yr [g]",
                             "Sa(1.0 s) [g] 5 % damped"}) {
        EXPECT_FALSE(tells_operation_in_name(name)) << name;
    }
}

TEST(OperatorsInNames, AreRefusedUnlessTheColumnsAreStated) {
    for (char const* name : {"a [gal]/10", "a/2 [gal]", "SRSS [gal]", "acc_rel [gal]"}) {
        auto const text = fmt::format("time,{}\n0,10\n0.01,-20\n0.02,30\n0.03,-5\n", name);
        testing::expect_input_error([&] { (void)read_placed(text, {.name = "a"}); }, "a:1: ");
    }
}

}  // namespace
}  // namespace overturn
