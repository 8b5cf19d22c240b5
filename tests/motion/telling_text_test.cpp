// Requirement R-107: a word in a line that may change what the numbers are leads to a statement, to a refusal, or to a
// line that is listed; one known word beside it hides nothing.
#include <algorithm>
#include <array>
#include <string>

#include <fmt/format.h>

#include "core/units.hpp"
#include "motion/telling_words.hpp"
#include "motion/text_statements.hpp"
#include "support/expect_input_error.hpp"
#include "support/read_record.hpp"

namespace overturn {
namespace {

using testing::expect_input_error;

std::string text(std::string const& line, std::string const& names = "Time,acc [gal]") {
    return line + "\n" + names + "\n0,10\n0.01,-20\n0.02,30\n0.03,-5\n";
}

Direction direction(std::string const& line) { return read_placed(text(line), {.name = "a"}).direction; }

// a single column without a direction of its own is what the text says; the vertical one rocks nothing.
TEST(TextStatements, AComponentInTheTextIsThatOfTheColumn) {
    for (char const* line : {"# Component: UP", "# Channel: HNZ", "# Orientation: vertical", "# comp = Z", "# Dir. U-D",
                             "# HNZ", "# station ABC, vertical", "# DIRECTION: UP-DOWN", "# Komponente: vertikal",
                             "# azimuth: up", "# \xE6\x88\x90\xE5\x88\x86: \xE4\xB8\x8A\xE4\xB8\x8B",
                             "# up-down component", "# gal, Z", "# cm/s2; V", "# cm/s/s, U"}) {
        EXPECT_EQ(direction(line), Direction::up) << line;
    }
    EXPECT_EQ(direction("# Component: NS"), Direction::horizontal);
    EXPECT_EQ(direction("# components NS, EW, UD of one station"), Direction::unknown);
    EXPECT_EQ(direction("# altitude Z: 300 m"), Direction::unknown);
    EXPECT_EQ(direction("# gal, N, E, Z"), Direction::unknown);
    EXPECT_EQ(direction("# gal, N"), Direction::unknown);
    EXPECT_EQ(read_placed(text("# gal, Z"), {.name = "a"}).statements,
              (std::vector<std::string>{"line 1: component z", "line 1: gal"}));
    expect_input_error([] { (void)read_placed(text("# Component: UP", "Time,NS [gal]"), {.name = "a"}); }, "a:1",
                       "contradict each other");
    RecordRequest stated{.name = "a"};
    stated.columns = "time,h1";
    expect_input_error([&] { (void)read_placed(text("# Component: UP"), stated); }, "a:1", "contradict each other");
}

// factors, other quantities, rates and directions within a line that is understood are listed, before others.
TEST(TextStatements, WhatMayChangeTheNumbersIsListed) {
    for (char const* line : {"# station X, values scaled by 0.5",
                             "# date 2011-03-11, multiply by 9.81",
                             "# Component: NS, x 100",
                             "# acceleration x 1000",
                             "# event X, divide by 980",
                             "# channel 1, amplification 10",
                             "# Event: X; ground velocity",
                             "# 200 Hz",
                             "# file 200Hz",
                             "# Station X, 200 Hz",
                             "# 50 % of the original",
                             "# acceleration in gal, decimated by 2",
                             "# acceleration in gal, sign reversed",
                             "# gal, with gravity",
                             "# acceleration in gal, every second sample",
                             "# pseudo-acceleration in gal",
                             "# gal, Fs of 200",
                             "# Station X, units 0.01 g",
                             "# gal, rate = 200",
                             "# acceleration in gal, rotated to 45 deg",
                             "# acceleration in gal, (x1000)",
                             "# 1 unit = 0.01 m/s2",
                             "# zero-period acceleration 0.5g",
                             "# gain = 10",
                             "# accelerogram, reduced to 10 %"}) {
        auto const placed = read_placed("blue ink\n" + text(line), {.name = "a"});
        ASSERT_FALSE(placed.unread.empty()) << line;
        EXPECT_TRUE(placed.unread.front().starts_with(fmt::format("line 2: '{}", std::string(line).substr(0, 20))))
            << placed.unread.front();
    }
    for (char const* line : {"# Station: X", "# acceleration in gal", "# Kobe 1995, JMA, gal", "# gal, M 6.9, 12 km",
                             "# gal, 2011-03-11 05:46", "# gal, 35.1N 139.2E", "# RSN1106, acceleration in gal",
                             "# dt = 0.01 s", "# gal, Fs=100", "# gal, delta = 0.01"}) {
        EXPECT_TRUE(read_placed(text(line), {.name = "a"}).unread.empty()) << line;
    }
    expect_input_error([] { (void)read_placed(text("# gal, Fs=200"), {.name = "a"}); }, "a:1: time step 0.005 s");
}

// a line of known words alone that calls accelerations something else.
TEST(TextStatements, AnotherQuantityContradictsTheName) {
    for (char const* line :
         {"# absolute acceleration response spectrum", "# 5% damped spectrum", "# values below are velocities in cm/s",
          "# VEL", "# Component: NS velocity, cm/s", "# displacement [cm]", "# ground velocity"}) {
        expect_input_error([&] { (void)read_placed(text(line), {.name = "a"}); },
                           "a:1: ", "says the text, where names say accelerations");
        expect_input_error([&] { (void)read_placed(text("# station X") + line + "\n", {.name = "a"}); },
                           "a:7: ", "says the text, where names say accelerations");
    }
    for (char const* line : {"# acceleration, velocity and displacement in cgs units", "# velocity sensor, station ABC",
                             "# matched to a design spectrum", "# shear wave velocity 300 m/s"}) {
        EXPECT_NO_THROW((void)read_placed(text(line), {.name = "a"})) << line;
    }
    EXPECT_NO_THROW(
        (void)read_placed("# velocity in cm/s\ntime,acc [gal],vel\n0,1,2\n1,-2,3\n2,3,-4\n", {.name = "a"}));
}

// a line below the numbers counts as one above does, and one on where or whence as another.
TEST(TextStatements, EveryLineCounts) {
    auto const below = [](std::string const& line, std::string const& names = "Time,acc [gal]") {
        return read_placed(text("# station X", names) + line + "\n", {.name = "a"});
    };
    for (char const* line : {"end of file, all in g", "--- end, units: g"}) {
        expect_input_error([&] { (void)below(line); }, "a:7: ", "unit g, line 2 says gal");
        expect_input_error([&] { (void)below(line, "Time,acc"); }, "a: ", "peak of 30 g");
    }
    for (char const* line : {"end of file", "*** End Data ***", "/& END OF DATA", "--- end ---"}) {
        EXPECT_TRUE(below(line).unread.empty()) << line;
    }
    expect_input_error([&] { (void)below("*** End Data *** (in g)", "Time,acc"); }, "a:3: ", "line 7 names g");
    expect_input_error([&] { (void)below("End of data, 9 samples"); }, "a:7: ", "9 samples stated, 4 found");
    expect_input_error([] { (void)read_placed(text("# station ABC, units: m/s"), {.name = "a"}); },
                       "a:1: velocities, says the text");
    auto const list =
        read_placed("Kobe NS (gal)\n4 0.01\n1\n-2\n3\n-1\nend of file, velocities in cm/s\n", {.name = "a"});
    EXPECT_EQ(list.unread, std::vector<std::string>{"line 7: 'end of file, velocities in cm/...'"});
    for (char const* line : {"END", "end", "EOF"}) {
        EXPECT_TRUE(below(line).unread.empty()) << line;
    }
    EXPECT_TRUE(read_placed(text("--- end of header ---"), {.name = "a"}).motion.samples() == 4);
    auto const aside = read_placed(text("# Source: PEER, g"), {.name = "a"});
    EXPECT_EQ(aside.unread, std::vector<std::string>{"line 1: '# Source: PEER, g'"});
}

// a unit of velocities below which a column is called an acceleration.
TEST(TextStatements, AnotherUnitContradictsTheName) {
    expect_input_error([] { (void)read_placed(text("# units: m/s", "time,acc"), {.name = "a", .unit_mps2 = 1}); },
                       "a:1", "velocities");
}

// a factor in a column's name is nothing to guess at; a distance is no time step.
TEST(TextStatements, FactorsInNamesAreRefusedAndDistancesAreNoSteps) {
    for (char const* name : {"a x 100 [m/s2]", "a*100 [m/s2]", "a [m/s2] x100"}) {
        expect_input_error([&] { (void)read_placed(text("# X", fmt::format("time,{}", name)), {.name = "a"}); }, "a:2");
    }
    EXPECT_EQ(read_placed(text("# Tokyo, delta = 0.05 deg"), {.name = "a"}).motion.time_step_s, 0.01);
}

// a peak in its own unit is held against the numbers in theirs; one that is none of them is listed.
TEST(TextStatements, PeaksHaveUnits) {
    for (char const* line :
         {"# PGA = 30 gal", "# PGA = 0.3 m/s2", "# Peak acceleration: 30 cm/s2", "# pga 30 gal",
          "# peak acceleration of 0.3 m/s2", "# PGA of 30 gal", "# Peak acceleration is 0.3 m/s2 at 0.02 s",
          "# PGA (m/s2) 0.3", "# PGA=30gal", "# max. acceleration -30 gal", "# max 30 gal", "# peak of 0.3 m/s2"}) {
        EXPECT_TRUE(read_placed(text(line), {.name = "a"}).unread.empty()) << line;
    }
    for (char const* line : {"# PGA = 30 m/s2", "# peak acceleration of 30 m/s2", "# maximum acceleration was 30 m/s2",
                             "# peak of 30 m/s2"}) {
        expect_input_error([&] { (void)read_placed(text(line), {.name = "a"}); }, "a:1", "a wrong unit");
    }
    for (char const* line : {"# peak acceleration at 3.2 s", "# Peak acceleration, see 3"}) {
        auto const listed = read_placed(text(line), {.name = "a"}).unread;
        EXPECT_EQ(listed, std::vector<std::string>{fmt::format("line 1: '{}'", line)});
    }
    expect_input_error([] { (void)read_placed(text("# PGA = 0.5 g"), {.name = "a"}); },
                       "a:1: ", "peak of 4.90332 m/s2 stated, 0.3 m/s2 found");
    auto const unmet = read_placed(text("# sensor range, max 0.5 g"), {.name = "a"}).unread;
    ASSERT_EQ(unmet.size(), 1U);
    EXPECT_EQ(unmet.front(), "line 1: a peak of 4.903 m/s2, the numbers have 0.3 m/s2");
}

// a sensor that reads gravity is refused, whichever way it is mounted.
TEST(TextStatements, RecordsAboutOneGAreRefused) {
    for (double const mean : {-1.1, -0.9, 0.9, 1.0, 1.1}) {
        std::string values = "time,NS [g],UD [g]\n";
        for (int i = 0; i < 8; ++i) {
            values += fmt::format("{},{},{}\n", 0.01 * i, i % 2 - 0.5, mean + 0.4 * (i % 2 - 0.5));
        }
        expect_input_error([&] { (void)read_placed(values, {.name = "a"}); }, "component 'UD [g]'", "reads gravity");
    }
}

// what one channel of a seismometer is by its unit, the others are too; a word for two columns is refused.
TEST(TextStatements, NoChannelIsDropped) {
    auto const placed = read_placed("Time(s),BHZ,BHN,BHE [m/s2]\n0,1,2,3\n0.01,-1,-2,-4\n0.02,1,2,3\n", {.name = "a"});
    EXPECT_EQ(placed.components, (std::vector<std::string>{"BHN", "BHE [m/s2]", "BHZ"}));
    RecordRequest stated{.name = "a", .unit_mps2 = 1};
    stated.columns = "time,h1,h1,v";
    expect_input_error([&] { (void)read_placed("0,1,2,3\n0.01,-1,-2,-4\n0.02,1,2,3\n", stated); }, "a",
                       "columns 2 and 3 are both 'h1'");
}

// a rate with its unit is one however it is worded; a filter's is none.
TEST(TextStatements, RatesAndStepsAreStatements) {
    auto const list = [](std::string const& line) {
        return read_placed(line + ", gal\n1\n-2\n3\n-1\n", {.name = "a"}).motion.time_step_s;
    };
    for (char const* line :
         {"# @200Hz", "# acceleration @ 200 Hz", "# every 5 ms", "# a value every 0.005 s", "# 200 Hz sampling",
          "# fs = 200 Hz", "# sampled 200 Hz", "# step 0.005 s", "# interval 5 ms", "# 200 pts/s"}) {
        EXPECT_EQ(list(line), 0.005) << line;
        expect_input_error([&] { (void)read_placed(text(line), {.name = "a"}); }, "a:1: ", "time step 0.005 s");
    }
    for (char const* line : {"# low-pass @ 50 Hz", "# band-pass, corner @ 25 Hz", "# every 5th day", "# FS = 2 g"}) {
        expect_input_error([&] { (void)list(line); }, "a:2: ", "time step missing");
    }
}

// quotes around numbers are none of them; decimal commas in them are refused with the remedy.
TEST(TextStatements, QuotedNumbersAreRead) {
    auto const read = [](std::string const& rows) {
        return read_placed("time;acc [gal]\n" + rows, {.name = "a"}).motion;
    };
    EXPECT_EQ(read("\"0\";\"10\"\n\"0.01\";\"-20\"\n\"0.02\";\"5\"\n").horizontal_mps2[1], -0.2);
    expect_input_error([&] { (void)read("\"0,00\";\"1,5\"\n\"0,01\";\"-2,5\"\n"); }, "a:2: ", "Write decimal points");
    expect_input_error([&] { (void)read_placed("time,acc [gal]\n\"0,00\",\"1,5\"\n", {.name = "a"}); },
                       "a:2: ", "Write decimal points");
}

// a factor beside a unit makes it none of the numbers'.
TEST(TextStatements, UnitsWithFactorsAreNone) {
    for (char const* line :
         {"# acceleration in g / 1000", "# acceleration in gal (x 0.001)", "# acceleration in 0.01 g", "# 100 x m/s2",
          "# acceleration in tenths of g", "# acceleration, percent of g"}) {
        expect_input_error([&] { (void)read_placed(text(line, "time,acc"), {.name = "a"}); }, "a:");
    }
    auto const plain = "# acceleration in units of g\ntime,acc\n0,1\n0.01,-2\n0.02,1\n";
    EXPECT_EQ(read_placed(plain, {.name = "a"}).unit_mps2, g0);
}

// a hazard curve is no record, whatever its unit.
TEST(TextStatements, HazardCurvesAreRefused) {
    expect_input_error([] { (void)read_placed("acc [g],annual_exceedance\n0,1\n1,0.1\n", {.name = "a"}); },
                       "a:1: ", "a hazard curve");
}

// names of what is made of motions are listed; a time in another unit is none in seconds.
TEST(TextStatements, NamesOfOtherValuesAreListed) {
    for (char const* name : {"acc error [gal]", "acc_std [gal]", "envelope [gal]", "-acc [gal]", "PGA [gal]",
                             "acc inverted [gal]", "floor acc [gal]"}) {
        auto const listed = read_placed(text("# X", fmt::format("time,{}", name)), {.name = "a"}).unread;
        ASSERT_FALSE(listed.empty()) << name;
        EXPECT_EQ(listed.front(), fmt::format("line 2: '{}'", name));
    }
    EXPECT_TRUE(read_placed(text("# gal", "time,acc_NS"), {.name = "a"}).unread.empty());
    for (char const* time : {"time [d]", "time (0.01 s)", "t [-]", "time (x10 ms)"}) {
        expect_input_error([&] { (void)read_placed(text("# X", fmt::format("{},acc [gal]", time)), {.name = "a"}); },
                           "a:2: ", "no unit of time");
    }
    EXPECT_EQ(read_placed(text("# gal, sampling frequency: 0.1 kHz"), {.name = "a"}).motion.time_step_s, 0.01);
    EXPECT_EQ(read_placed(text("# X", "time (UTC),acc [gal]"), {.name = "a"}).motion.time_step_s, 0.01);
}

TEST(TextStatements, WordsAreFoundAsWords) {
    EXPECT_TRUE(tells_factor("normalised to 1 g"));
    EXPECT_TRUE(tells_factor("acc * 9.81"));
    EXPECT_TRUE(tells_factor("100*a"));
    EXPECT_FALSE(tells_factor("m/s**2"));
    EXPECT_FALSE(tells_factor("a pit of 2 x 3 m"));
    EXPECT_FALSE(tells_vertical("supper"));
    EXPECT_TRUE(tells_statistic("84th percentile"));
    EXPECT_TRUE(tells_other_span("per century"));
    EXPECT_FALSE(tells_other_quantity("level of the sea"));
    EXPECT_TRUE(tells_other_quantity("raw counts"));
    EXPECT_FALSE(tells_rate("hertzian"));
}

}  // namespace
}  // namespace overturn
