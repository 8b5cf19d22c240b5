// Requirement R-107: a stated unit or time step that contradicts a file's own prose or column names is an error, never
// a silent reading in the wrong unit; what is packed or binary is named.
#include "motion/prose.hpp"

#include <string>

#include "core/units.hpp"
#include "motion/column_unit.hpp"
#include "support/expect_input_error.hpp"
#include "support/read_record.hpp"

namespace overturn {
namespace {

using testing::expect_input_error;

constexpr double gal = 0.01;

Prose heard(std::string const& line) {
    Prose prose;
    prose.take(line, 3);
    return prose;
}

TEST(Prose, UnitsAreHeardInEverySpelling) {
    struct Said {
        char const* line;
        double si;
    };
    for (auto const& [line, si] : {Said{"Accelaration time series in m/s/s", 1},
                                   {"PGA (m/s/s)                   : 6.7694000E-01", 1},
                                   {"# Time (s),Acceleration (g's)", g0},
                                   {"Units: cm/sec/sec", gal},
                                   {"acceleration in g", g0},
                                   {"ACCELERATION [G]", g0},
                                   {"unit = g", g0},
                                   {"values in gal.", gal},
                                   {"(cm/s**2)", gal},
                                   {"CM/SEC2, 8F10.3", gal},
                                   {"Units are g", g0},
                                   {"Acceleration in m/s\xC2\xB2", 1},
                                   {"accel. cm/s/s", gal},
                                   {"acceleration, cm.s^-2", gal},
                                   {"data in mg", 1e-3 * g0}}) {
        ASSERT_TRUE(heard(line).unit()) << line;
        EXPECT_EQ(*heard(line).unit(), si) << line;
    }
    for (char const* line : {"station G, block g", "Mg 6.1 M", "Gallipoli 1992", "velocity in cm/s", "0.3 g", "g",
                             "in m", "g = 9.81 m/s2", "PGA = 300. gal", "Max .028 g , at 32.570 sec"}) {
        EXPECT_FALSE(heard(line).unit()) << line;
    }
}

TEST(Prose, StepsAreHeardInEverySpelling) {
    struct Said {
        char const* line;
        double step;
    };
    for (auto const& [line, step] : {Said{"Time Increment (s)            : 0.005", 0.005},
                                     {"dt = 0.02", 0.02},
                                     {"NPTS=  2000, DT= .02000 SEC", 0.02},
                                     {"Time step: 5 ms", 0.005},
                                     {"time step (ms) = 5", 0.005},
                                     {"dt=1e-2 s", 0.01},
                                     {"Sampling rate: 200 Hz", 0.005},
                                     {"sampling frequency (Hz) 100", 0.01},
                                     {"1559 points at 0.02 sec", 0.02},
                                     {"data equally spaced at .010 sec", 0.01},
                                     {"200 sps", 0.005},
                                     {"recorded with 200 samples per second", 0.005},
                                     {"Samples per second: 200", 0.005},
                                     {"Interval: 5 ms", 0.005},
                                     {"equal time steps of 0.005 s", 0.005},
                                     {"SAMPLING_INTERVAL_S: 0.005", 0.005},
                                     {"Digitized at 200 Hz", 0.005},
                                     {"digitised at 0.005 sec", 0.005},
                                     {"deltat=0.005", 0.005},
                                     {"dt 1/200 s", 0.005}}) {
        ASSERT_TRUE(heard(line).time_step_s()) << line;
        EXPECT_NEAR(*heard(line).time_step_s(), step, 1e-15) << line;
    }
    for (char const* line : {"width 3", "dt", "dt = x", "dtx = 3", "time step unknown", "at 3.2 sec"}) {
        EXPECT_FALSE(heard(line).time_step_s()) << line;
    }
}

// a list that calls its numbers velocities or displacements is refused.
TEST(Prose, OtherQuantitiesAreRefused) {
    RecordRequest request;
    request.name = "r";
    for (char const* line : {"VELOCITY in cm/s", "displacement (cm)", "Velocities, m/s"}) {
        expect_input_error([&] { heard(line).check(request); }, "r:3: velocities or displacements");
    }
    for (char const* line :
         {"peak velocity 12 cm/s", "velocity", "acceleration, velocity in cm/s", "velocity in gal"}) {
        EXPECT_NO_THROW(heard(line).check(request)) << line;
    }
}

TEST(Prose, WhatIsSaidTwiceDifferentlyIsNotSaid) {
    Prose prose;
    prose.take("PGA in g: 0.3", 1);
    prose.take("values in gal", 2);
    prose.take("in gal", 3);
    EXPECT_FALSE(prose.unit());
}

// The L'Aquila file's layout with its prose, read as a list: 5 gal instead of 507 before.
std::string const prose_list =
    "Network : X\nTime Increment (s) : 0.005\nPGA (m/s/s) : 5.0\nAccelaration time series in m/s/s\n"
    " 1.0E+00 2.0E+00 3.0E+00-5.0E+00 1.0E+00\n 1.0E+00\n";

TEST(Contradictions, ListAgainstItsProse) {
    auto const read = [](double unit, double step, bool campaign = false) {
        return testing::read_record(
            prose_list, {.name = "a.acc", .unit_mps2 = unit, .time_step_s = step, .may_be_resampled = campaign});
    };
    EXPECT_EQ(read(1, 0.005).horizontal_mps2[3], -5);
    expect_input_error([&] { (void)read(gal, 0.005); }, "a.acc:3: ", "unit m/s2 in the file, gal stated");
    expect_input_error([&] { (void)read(1, 0.02); }, "a.acc:2: ", "time step of 0.005 s in the file, 0.02 s stated");
    expect_input_error([&] { (void)read(1, 0.02, true); }, "a.acc:2: ", "0.02 s stated");
    expect_input_error([&] { (void)testing::read_record(prose_list, {.name = "a.acc", .time_step_s = 0.005}); },
                       "line 3 says m/s2");
    expect_input_error([&] { (void)testing::read_record(prose_list, {.name = "a.acc", .unit_mps2 = 1.0}); },
                       "line 2 says 0.005 s");
}

TEST(Contradictions, ColumnsAgainstTheirComments) {
    std::string const text = "# Time (s),Acceleration (g's)\n0,0.1\n0.5,-0.2\n";
    EXPECT_EQ(testing::read_record(text, {.unit_mps2 = g0}).horizontal_mps2[1], -0.2 * g0);
    expect_input_error([&] { (void)testing::read_record(text, {.name = "a.csv", .unit_mps2 = gal}); },
                       "a.csv:1: ", "unit g in the file, gal stated");
    expect_input_error([&] { (void)testing::read_record(text, {.name = "a.csv"}); }, "line 1 says g");
}

TEST(Contradictions, CampaignsArePointedToTablesOfTheirOwn) {
    expect_input_error(
        [] {
            (void)testing::read_record("t,a (g)\n0,0.1\n0.5,-0.2\n",
                                       {.name = "a.csv", .unit_mps2 = gal, .unit_conflict = "Go"});
        },
        "a.csv:1: unit g in the file, gal stated (they contradict each other). Go");
}

TEST(Contradictions, NamesOfColumnsInTheWild) {
    for (auto const& [name, si] : {std::pair{"Acceleration (g's)", g0},
                                   {"Accel[g]", g0},
                                   {"Acc(gal)", gal},
                                   {"a (cm/sec/sec)", gal},
                                   {"ax_mps2", 1.0}}) {
        EXPECT_EQ(unit_in_name(name), si) << name;
    }
    EXPECT_EQ(unit_in_name("Sv [kine]", Dimension::velocity), 0.01);
    EXPECT_EQ(unit_in_name("Sd_cm", Dimension::length), 0.01);
    EXPECT_EQ(unit_in_name("T [ms]", Dimension::time), 1e-3);
    EXPECT_FALSE(unit_in_name("period_s", Dimension::time));
}

TEST(PackedFiles, AreNamed) {
    auto const refuse = [](std::string content, char const* name, char const* advice) {
        content.resize(std::max<std::size_t>(content.size(), 700));
        expect_input_error([&] { (void)testing::read_record(content, {.name = "a"}); }, "a: ", name, advice);
    };
    refuse("\x1f\x8b\x08", "gzip", "Unpack it");
    refuse("PK\x03\x04", "zip archive", "Unpack it");
    refuse("BZh9", "bzip2", "Unpack it");
    refuse("\xfd\x37zXZ", "xz", "Unpack it");
    refuse("000001D ANMO ", "miniSEED", "Convert it to text");
    refuse("MS\x03", "miniSEED 3", "Convert it to text");
    std::string tar(700, 'a');
    tar.replace(257, 5, "ustar");
    refuse(tar, "tar archive", "Unpack it");
    std::string sac(700, '\1');
    sac.replace(304, 4, std::string_view("\6\0\0\0", 4));
    refuse(sac, "SAC", "Convert it to text");
    refuse("what is this", "binary or UTF-16", "Save it as plain text");
}

}  // namespace
}  // namespace overturn
