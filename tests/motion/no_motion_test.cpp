// Requirement R-107: what is no motion is read as none: times, counts of rows, and what looks like nothing that shakes.
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "motion/record.hpp"
#include "support/expect_input_error.hpp"
#include "support/read_record.hpp"

namespace overturn {
namespace {

using testing::expect_input_error;

constexpr double gal = 0.01;

GroundMotion read(std::string const& content, RecordRequest request = {.unit_mps2 = gal}) {
    request.name = "a.csv";
    return testing::read_record(content, request);
}

std::vector<double> const three{100 * gal, -200 * gal, 300 * gal};

// a column named time or index, or in seconds, is no motion.
TEST(Columns, TimesAndIndicesAreNoMotion) {
    for (char const* names : {"index,time,acc", ",time (s),acc", "No.,t,acc", "Unnamed: 0,time,acc", "i,s,acc"}) {
        auto const motion = read(std::string(names) + "\n0,0,100\n1,0.5,-200\n2,1,300\n");
        EXPECT_EQ(motion.horizontal_mps2, three) << names;
        EXPECT_EQ(motion.time_step_s, 0.5) << names;
    }
    expect_input_error([] { (void)read("index,time,acc\n0,0,1\n7,0.5,2\n8,1,3\n"); }, "a count of rows by its name");
    expect_input_error([] { (void)read("index,time\n0,0\n1,0.5\n2,1\n"); }, "no column of accelerations");
}

// a line of names that are more or fewer than the columns is not dropped.
TEST(Columns, NamesOfAnotherNumberAreRefused) {
    expect_input_error([] { (void)read("time,NS,EW,UD\n0,1,2\n1,2,3\n"); }, "a.csv:1: ", "another number of columns");
    EXPECT_NO_THROW((void)read("time,NS,EW,UD\n0,1,2\n1,2,3\n", {.unit_mps2 = gal, .columns = "time,h1,h2"}));
}

// a row of units without names says what the columns are.
TEST(Columns, UnitsAloneAreHeard) {
    EXPECT_EQ(read("(s),(gal)\n0,100\n0.5,-200\n1,300\n", {}).horizontal_mps2, three);
    EXPECT_EQ(read("sec  cm/s2\n0 100\n0.5 -200\n1 300\n", {}).horizontal_mps2, three);
    for (char const* units : {"units: s,gal", "\xE5\x8D\x98\xE4\xBD\x8D:s,gal", "Einheit: s,gal"}) {
        EXPECT_EQ(read(fmt::format("t,NS\n{}\n0,100\n0.5,-200\n1,300\n", units), {}).horizontal_mps2, three) << units;
    }
    expect_input_error([] { (void)read("(Hz),(gal)\n0,100\n0.5,-200\n1,300\n", {}); }, "a.csv:1: ", "a frequency");
    expect_input_error([] { (void)read("(s),(cm/s)\n0,100\n0.5,-200\n1,300\n"); }, "a.csv:1: ", "a velocity");
}

// what nothing calls an acceleration and looks like none is refused.
TEST(Columns, WhatLooksLikeNoMotionIsRefused) {
    std::string positive, rising, offset, named = "t,acc\n";
    for (int i = 0; i < 100; ++i) {
        double const swing = std::sin(0.7 * i);
        positive += fmt::format("{},{}\n", 0.5 * i, 1 + swing * swing);
        rising += fmt::format("{},{}\n", 0.5 * i, i - 50);
        offset += fmt::format("{},{}\n", 0.5 * i, 0.9 + swing);
        named += fmt::format("{},{}\n", i, 1 + swing * swing);
    }
    expect_input_error([&] { (void)read(positive); }, "values of one sign throughout");
    expect_input_error([&] { (void)read(rising); }, "only rise");
    expect_input_error([&] { (void)read(offset); }, "about another one than zero");
    expect_input_error([&] { (void)read(named); }, "values of one sign throughout in column 'acc'",
                       "--columns time,h1");
    // Prose that names two directions makes no component of a time.
    expect_input_error([&] { (void)read("# at N, E\n" + rising, {.unit_mps2 = gal, .time_step_s = 1}); }, "only rise");
    EXPECT_NO_THROW((void)read(positive, {.unit_mps2 = gal, .columns = "time,h1"}));
}

// 1, 2, 3, ... are rows as well as seconds; a first value may be the count of the others, or their step.
TEST(Columns, CountsOfRowsAreNoTimes) {
    std::string counted, list;
    for (int i = 1; i <= 40; ++i) {
        counted += fmt::format("{} {}\n", i, std::sin(0.7 * i));
        list += fmt::format("{}\n", std::sin(0.7 * i));
    }
    expect_input_error([&] { (void)read(counted); }, "a.csv:1: 1, 2, 3, ... in column 1");
    EXPECT_EQ(read("t,acc\n" + counted).time_step_s, 1);
    EXPECT_EQ(read(counted, {.unit_mps2 = gal, .time_step_s = 0.01, .columns = "-,h1"}).samples(), 40U);
    RecordRequest const stated{.unit_mps2 = gal, .time_step_s = 0.01};
    EXPECT_EQ(read(list, stated).samples(), 40U);
    for (char const* above : {"40\n", "40\n0.01\n", "0.01\n"}) {
        expect_input_error([&] { (void)read(above + list, stated); }, "a.csv:1: ", "in the first row");
    }
    EXPECT_EQ(read("acc\n" + list, stated).samples(), 40U);
}

// a name that says another quantity is that of no motion, be it of one column, of letters alone, or a channel's.
TEST(Columns, NamesOfOtherQuantitiesAreRefused) {
    for (char const* name : {"velNS",
                             "NSvel",
                             "VelX",
                             "vx",
                             "v_y",
                             "dz",
                             "v",
                             "HHE",
                             "cnt",
                             "AFE",
                             "hazard",
                             "probability",
                             "jerk",
                             "theta",
                             "pressure",
                             "arias",
                             "H\xC4\xB1z",
                             "\xEC\x86\x8D\xEB\x8F\x84",
                             "d\xE9placement",
                             "voltage"}) {
        auto const text = fmt::format("time,{}\n0,1\n0.5,-2\n1,3\n", name);
        expect_input_error([&] { (void)read(text); }, "a.csv:1: column '");
    }
    for (char const* name : {"velocity", "vel", "v", "d", "psa", "index", "time", "Disp [cm]"}) {
        expect_input_error(
            [&] { (void)read(std::string(name) + "\n1\n-2\n3\n", {.unit_mps2 = gal, .time_step_s = 1}); }, "a.csv:1: ");
    }
    for (char const* name : {"udot",
                             "u_dot",
                             "u dot",
                             "xdot",
                             "udotx",
                             "velo_N",
                             "velo",
                             "geschw",
                             "Geschw. NS",
                             "vit",
                             "vit_NS",
                             "vites NS",
                             "velocidad",
                             "rot_x",
                             "rotx",
                             "rot z",
                             "roll",
                             "disp_x",
                             "depl",
                             "depl_NS",
                             "dep",
                             "despl",
                             "spost",
                             "weg",
                             "yerde\xC4\x9Fi\xC5\x9Ftirme",
                             "deslocamento",
                             "snelheid",
                             "verplaatsing",
                             "\xE5\x8F\x98\xE4\xBD\x8D",
                             "gyr",
                             "angvel",
                             "v(t)",
                             "u(t)",
                             "V1",
                             "d1",
                             "d_N",
                             "integrated",
                             "cumulative",
                             "kine",
                             "cm/s",
                             "m/s",
                             "cm",
                             "accdot",
                             "du/dt"}) {
        auto const text = fmt::format("time,{}\n0,1\n0.5,-2\n1,3\n", name);
        expect_input_error([&] { (void)read(text); }, "a.csv:1: column '");
        if (std::string(name).find_first_of("/123") == std::string::npos) {
            expect_input_error(
                [&] { (void)read(std::string(name) + "\n1\n-2\n3\n", {.unit_mps2 = gal, .time_step_s = 1}); },
                "a.csv:1: ");
        }
    }
    for (char const* name : {"uddot", "u_ddot", "xdotdot", "a(t)", "gal", "cm/s/s", "a1", "Dotter", "UD", "velvet"}) {
        EXPECT_NO_THROW((void)read(fmt::format("time,{}\n0,1\n0.5,-2\n1,3\n", name))) << name;
    }
    for (char const* name : {"HHE (gal)", "vx (gal)", "D (gal)", "HLE"}) {
        EXPECT_NO_THROW((void)read(fmt::format("time,{}\n0,1\n0.5,-2\n1,3\n", name))) << name;
    }
    auto const down = read("time,S (gal),W (gal),D (gal)\n0,1,2,3\n0.5,4,5,6\n", {});
    EXPECT_EQ(down.vertical_mps2, (std::vector{-3 * gal, -6 * gal}));
}

// text between and below the numbers states as much as that above; a count and a step may stand above rows.
TEST(Columns, CommentsBelowCount) {
    std::string const rows = "0 1\n0.5 -2\n";
    expect_input_error([&] { (void)read(rows + "# units: m/s2\n"); }, "a.csv:3: unit m/s2 in the file, gal stated");
    expect_input_error([&] { (void)read(rows + "# units: m/s2\n1 3\n"); }, "a.csv:3: ", "contradict");
    EXPECT_EQ(read("12 0.5\n1 2 3 4 5 6\n-1 -2 -3 -4 -5 -6\n").time_step_s, 0.5);
    expect_input_error(
        [] { (void)read("12 0.5\n1 2 3 4 5 6\n-1 -2 -3 -4 -5 -6\n", {.unit_mps2 = gal, .time_step_s = 1}); },
        "contradict");
}

// letters of West Europe, of Turkey and of Japan's mail are read as such.
TEST(Columns, LettersOfOtherEncodings) {
    for (char const* name : {"acc\xE9l\xE9ration (cm/s\xB2)", "\xDDvme (gal)", "\x1b$B2CB.EY\x1b(B(gal)"}) {
        EXPECT_EQ(read(fmt::format("t,{}\n0,100\n0.5,-200\n1,300\n", name), {}).horizontal_mps2, three) << name;
    }
    expect_input_error([] { (void)read("acc\xE9l\xE9ration en m/s\xB2\n0,100\n0.5,-200\n"); }, "contradict");
}

// A ramp is a motion where its name says so, in the names that this program writes itself.
TEST(NoMotion, ARampThatIsNamedAnAccelerationIsOne) {
    std::string ramp;
    for (int i = 0; i < 64; ++i) {
        ramp += fmt::format("{:.2f},{}\n", 0.01 * i, 0.1 * i);
    }
    RecordRequest request{.name = "r.csv", .unit_mps2 = 1.0};
    EXPECT_EQ(read_recording("time,a_horizontal\n" + ramp, request).components.size(), 1U);
    for (auto const* names : {"time,acc\n", "time,NS\n", "time,x\n", "time,acceleration\n"}) {
        testing::expect_input_error([&] { (void)read_recording(names + ramp, {.name = "r.csv", .unit_mps2 = 1.0}); },
                                    "r.csv:2: ", "only rise");
    }
    request.columns = "time,h1";
    EXPECT_EQ(read_recording("time,acc\n" + ramp, request).components.size(), 1U);
}

// a mark of what is missing is no motion; a value of that size in a motion of that size is one.
TEST(NoMotion, MarksOfGapsAreRefusedAtTheirRow) {
    for (char const* mark : {"-999", "9999", "-999.0", "9999.9", "99999", "NaN", "nan", "NA", ""}) {
        expect_input_error([&] { (void)read(fmt::format("time,NS (gal)\n0,1\n0.5,-2\n1,{}\n1.5,3\n", mark), {}); },
                           "a.csv:4: ");
    }
    expect_input_error([] { (void)read("# gal, dt = 0.01 s\n1\n-2\n-9999\n-9999\n3\n", {}); },
                       "a.csv:4: -9999 in column 1");
    EXPECT_EQ(read("time,NS (gal)\n0,400\n0.5,-999\n1,600\n", {}).horizontal_mps2[1], -999 * gal);
}

// rows of numbers without names are one packed series, or as many channels: by their look, else as stated.
TEST(NoMotion, ChannelsSideBySideAreNotReadAsOne) {
    std::string packed, channels;
    for (int row = 0; row < 60; ++row) {
        for (int i = 0; i < 6; ++i) {
            packed += fmt::format(" {:8.3f}", 50 * std::sin(0.31 * (6 * row + i)));
            channels += fmt::format(" {:8.3f}", (10 + 30 * i) * std::sin(0.31 * row + 2 * i));
        }
        packed += '\n';
        channels += '\n';
    }
    EXPECT_EQ(read(packed, {.unit_mps2 = gal, .time_step_s = 0.01}).samples(), 360U);
    expect_input_error([&] { (void)read(channels, {.unit_mps2 = gal, .time_step_s = 0.01}); },
                       "a.csv:1: 6 numbers to a line without names", "State the format list, or: State --columns");
    EXPECT_EQ(read(channels, {.format = "list", .unit_mps2 = gal, .time_step_s = 0.01}).samples(), 360U);
    expect_input_error([&] { (void)read(packed, {.unit_mps2 = gal}); }, "time step missing");
    expect_input_error([&] { (void)read(packed, {.time_step_s = 0.01}); }, "unit missing");
}

// what its name calls an acceleration is refused by its look, as what has no name is; but a pulse that begins at
// rest keeps its sign, and a record that is not corrected yet swings about another value than zero.
TEST(NoMotion, ANamedOneMayBeAPulseOrUncorrected) {
    std::string pulse, strict, uncorrected, list;
    for (int i = 0; i <= 64; ++i) {
        double const value = i <= 32 ? std::sin(3.14159265 * i / 32) : 0;
        pulse += fmt::format("{:.2f},{:.5f}\n", 0.01 * i, i == 0 ? 0 : value);
        strict += fmt::format("{:.2f},{:.5f}\n", 0.01 * i, value + 0.01);
        uncorrected += fmt::format("{:.2f},{:.5f}\n", 0.01 * i, 0.8 + std::sin(0.7 * i));
        list += fmt::format("{:.5f}\n", -0.01 - value);
    }
    for (auto const* names : {"time,acc\n", "time,NS\n", "# acceleration\ntime,x\n"}) {
        EXPECT_NO_THROW((void)read(names + pulse)) << names;
        EXPECT_NO_THROW((void)read(names + uncorrected)) << names;
        expect_input_error([&] { (void)read(names + strict); }, "values of one sign throughout", "--columns");
    }
    expect_input_error([&] { (void)read("Acceleration (gal), dt = 0.01 s\n" + list, {}); },
                       "a.csv:2: values of one sign");
    EXPECT_NO_THROW((void)read("time,acc\n" + strict, {.unit_mps2 = gal, .columns = "time,h1"}));
}

// a mark of what is missing is no acceleration, in columns and lists, and the message names its row; a number
// that only looks like one, among others of its size, is read.
TEST(NoMotion, AMarkOfAGapIsNamedByItsRow) {
    for (auto const* mark : {"-999", "9999", "-999.99", "999999"}) {
        auto const gap = fmt::format("time,acc\n0,1\n0.01,-2\n0.02,{}\n0.03,2\n0.04,-1\n", mark);
        expect_input_error([&] { (void)read(gap); }, "a.csv:4: ", "a mark of a gap");
        auto const list = fmt::format("1\n-2\n{}\n2\n-1\n", mark);
        expect_input_error([&] { (void)read(list, {.unit_mps2 = gal, .time_step_s = 0.01}); },
                           "a.csv:3: ", "a mark of a gap");
    }
    EXPECT_EQ(read("time,acc\n0,400\n0.01,-999\n0.02,500\n").samples(), 3U);
}

// what an old results file holds was run and is read again, whatever it looks like.
TEST(NoMotion, OldFilesAreReadWhateverTheyLookLike) {
    RecordRequest const old{.unit_mps2 = gal, .by_place = true};
    EXPECT_EQ(read("time,acc\n0,1\n0.01,-2\n0.02,-999\n0.03,2\n0.04,-1\n", old).samples(), 5U);
    std::string strict = "time,acc\n";
    for (int i = 0; i <= 64; ++i) {
        strict += fmt::format("{:.2f},{:.5f}\n", 0.01 * i, 1.5 + std::sin(0.7 * i));
    }
    EXPECT_EQ(read(strict, old).samples(), 65U);
    expect_input_error([&] { (void)read(strict); }, "values of one sign");
}

}  // namespace
}  // namespace overturn
