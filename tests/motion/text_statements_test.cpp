// Requirement R-107: a stated unit or time step that contradicts a file's own prose or column names is an error, never
// a silent reading in the wrong unit; what is packed or binary is named.
#include "motion/text_statements.hpp"

#include <string>
#include <utility>

#include <fmt/format.h>

#include "core/units.hpp"
#include "motion/column_unit.hpp"
#include "support/expect_input_error.hpp"
#include "support/read_record.hpp"

namespace overturn {
namespace {

using testing::expect_input_error;

constexpr double gal = 0.01;

TextStatements heard(std::string const& line) {
    TextStatements prose;
    prose.take(line, 3);
    return prose;
}

TEST(TextStatements, UnitsAreHeardInEverySpelling) {
    struct Said {
        char const* line;
        double si;
    };
    for (auto const& [line, si] : {Said{"Accelaration time series in m/s/s", 1},
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
    for (char const* line : {"station G, block g", "Mg 6.1 M", "Gallipoli 1992", "velocity in cm/s", "0.3 g",
                             "acceleration 9.81 m/s2", "in m", "g = 9.81 m/s2", "PGA = 300. gal",
                             "PGA (m/s/s)                   : 6.7694000E-01", "Max .028 g , at 32.570 sec"}) {
        EXPECT_FALSE(heard(line).unit()) << line;
    }
}

// of a table of velocities or displacements their own units are heard, and accelerations are another quantity.
TEST(TextStatements, OfOtherDimensions) {
    TextStatements velocities(Dimension::velocity);
    velocities.take("# pseudo velocity (cm/s)", 2);
    EXPECT_EQ(velocities.unit(), 0.01);
    EXPECT_TRUE(velocities.other().empty());
    TextStatements wrong(Dimension::velocity);
    wrong.take("units: gal", 2);
    EXPECT_EQ(wrong.other(), "accelerations");
    expect_input_error([&] { wrong.check_unit_of("pgv", "t"); }, "t:2: a unit of accelerations, column 'pgv'");
    TextStatements lengths(Dimension::length);
    lengths.take("displacement in cm", 1);
    EXPECT_EQ(lengths.unit(), 0.01);
    expect_input_error([&] { (void)lengths.unit_beside(1.0, {}, {"t", 3}); }, "t:1: unit cm, line 3 says m");
    expect_input_error([&] { (void)lengths.unit_beside({}, 1.0, {"t", 3}); }, "t:1: unit cm in the file, m stated");
    EXPECT_EQ(lengths.unit_beside({}, {}, {"t", 3}), 0.01);
    EXPECT_EQ(TextStatements(Dimension::length).unit_beside({}, {}, {"t", 3}), std::nullopt);
    EXPECT_EQ(not_understood(std::vector<std::string>{}), "");
    EXPECT_EQ(not_understood(std::vector<std::string>{"a", "b", "c", "d", "e"}), " (not understood: a; b; c; 2 more)");
}

// a unit between commas, as a whole line or of several words is heard; one that is not known stands for none.
TEST(TextStatements, UnitsOfSeveralWords) {
    for (auto const& [line, si] : {std::pair{"units: m s-2", 1.0},
                                   {"dt = 0.01, g", g0},
                                   {"G", g0},
                                   {"acceleration (% g)", 1e-2 * g0},
                                   {"units: % g", 1e-2 * g0},
                                   {"acceleration in meters/second^2", 1.0},
                                   {"units: metre per second squared", 1.0},
                                   {"acceleration ($m/s^{2}$)", 1.0},
                                   {"Acceleration g", g0}}) {
        ASSERT_TRUE(heard(line).unit()) << line;
        EXPECT_DOUBLE_EQ(*heard(line).unit(), si) << line;
    }
    for (char const* line : {"units: g/10", "acceleration (1e-3 g)", "acceleration in g*1000", "units: 9.81 m/s2",
                             "acceleration in gn", "acceleration [10^-2 m/s2], 100 sps", "acceleration (cm)", "g/10"}) {
        EXPECT_FALSE(heard(line).unit()) << line;
        expect_input_error([&] { heard(line).check_unit_is_known("r"); }, "r:3: '",
                           "no unit of acceleration that is known");
    }
    for (char const* line : {"acceleration (corrected)", "acceleration (N)", "acceleration in 3 directions", "in s",
                             "acceleration, 0.01 s", "Unit No. 3"}) {
        EXPECT_NO_THROW(heard(line).check_unit_is_known("r")) << line;
    }
    expect_input_error(
        [] { (void)testing::read_record("acceleration (g/10)\n0,1\n0.5,-2\n", {.name = "r", .unit_mps2 = gal}); },
        "r:1: 'g/10'");
}

// a factor before a unit in a name, or a fraction of one, is no unit; "acc_g" may be of the ground.
TEST(TextStatements, NamesWithOddUnits) {
    for (char const* name : {"acc 9.81 m/s2", "acc 1e-3 g", "acc_g/10", "acc g*1000", "acc_g", "Acceleration g"}) {
        expect_input_error(
            [&] {
                (void)testing::read_record(fmt::format("t,{}\n0,1\n0.5,-2\n", name), {.name = "r", .unit_mps2 = gal});
            },
            "r:1: column '");
    }
    for (char const* name : {"a_g", "acc", "acc_EW"}) {
        EXPECT_NO_THROW((void)testing::read_record(fmt::format("t,{}\n0,1\n0.5,-2\n", name), {.unit_mps2 = gal}));
    }
}

TEST(TextStatements, StepsAreHeardInEverySpelling) {
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
                                     {"dt 1/200 s", 0.005},
                                     {"fs=100", 0.01},
                                     {"Sampling rate,100", 0.01},
                                     {"Sampling Rate(Hz);200", 0.005},
                                     {"Intervalo: 0.01 s", 0.01},
                                     {"offset removed, fs = 100 Hz", 0.01},
                                     {"delta=0.01", 0.01},
                                     {"delta: 0.005 s", 0.005},
                                     {"DELTA = 5 ms", 0.005},
                                     {"sps: 200", 0.005},
                                     {"Abtastrate: 200 Hz", 0.005},
                                     {"Frequenza di campionamento: 200", 0.005},
                                     {"Intervalo de tiempo (s): 0.01", 0.01},
                                     {"\xC3\x96rnekleme: fs=100", 0.01},
                                     {"\xE9\x87\x87\xE6\xA0\xB7\xE7\x8E\x87: 200Hz", 0.005},
                                     {"\xE3\x82\xB5\xE3\x83\xB3\xE3\x83\x97\xE3\x83\xAA\xE3\x83\xB3\xE3\x82\xB0"
                                      "\xE5\x91\xA8\xE6\xB3\xA2\xE6\x95\xB0: 100 Hz",
                                      0.01}}) {
        ASSERT_TRUE(heard(line).time_step_s()) << line;
        EXPECT_NEAR(*heard(line).time_step_s(), step, 1e-15) << line;
    }
    for (char const* line : {"width 3", "dt", "dt = x", "dtx = 3", "time step unknown", "at 3.2 sec", "delta = 35 km",
                             "Delta: 35", "delta 0.01", "fs", "fs 16", "fs = 0.5"}) {
        EXPECT_FALSE(heard(line).time_step_s()) << line;
    }
}

// a list that calls its numbers velocities or displacements is refused.
TEST(TextStatements, OtherQuantitiesAreRefused) {
    RecordRequest request;
    request.name = "r";
    for (char const* line :
         {"VELOCITY in cm/s", "displacement (cm)", "Velocities, m/s", "TIMESERIES X, 200 sps, FLOAT, M/S",
          "units: counts", "velocity", "type: VEL", "Velocity time history", "# disp in cm", "units: cm", "Unit: V",
          "units: cts", "Response spectrum, 5 % damping", "Spectral acceleration in g", "hazard curve",
          "D\xC3\xA9placement (m)", "\xE9\x80\x9F\xE5\xBA\xA6\xE6\xB3\xA2\xE5\xBD\xA2", "rotation rate (rad/s)"}) {
        expect_input_error([&] { heard(line).check(request); }, "r:3: ", "says the text (accelerations are read)");
    }
    for (char const* line :
         {"peak velocity 12 cm/s", "acceleration, velocity in cm/s", "velocity in gal", "velocity sensor",
          "shear wave velocity 300", "compatible with a response spectrum", "unit: gal", "location: Displacement Bay",
          "integrated once to its velocity and twice to its displacement, then fitted"}) {
        EXPECT_NO_THROW(heard(line).check(request)) << line;
    }
}

TEST(TextStatements, TwoDifferentStatementsAreNone) {
    TextStatements prose;
    prose.take("values in g", 1);
    prose.take("values in gal", 2);
    prose.take("in gal", 3);
    EXPECT_FALSE(prose.unit());
    TextStatements of_peak;
    of_peak.take("PGA in g: 0.3", 1);
    of_peak.take("values in gal", 2);
    EXPECT_EQ(of_peak.unit(), gal);
}

// a component that the text names is that of the numbers, and what says nothing known is listed.
TEST(TextStatements, ComponentsAreNamedAndTheRestIsListed) {
    auto const placed = read_placed("COMP. EW\nstation X\nblue ink\nin gal, dt = 0.01 s\n1\n-2\n3\n", {.name = "a"});
    EXPECT_EQ(placed.components, std::vector<std::string>{"EW"});
    EXPECT_EQ(placed.unread, std::vector<std::string>{"line 3: 'blue ink'"});
    EXPECT_EQ(placed.statements, (std::vector<std::string>{"line 4: gal", "line 4: 0.01 s"}));
    auto const three =
        read_placed("components: E N Z\nunits: cm/s^2\n100 Hz sampling rate: 100 Hz\n1 2 3\n4 5 6\n", {.name = "a"});
    EXPECT_EQ(three.components, (std::vector<std::string>{"E", "N", "Z"}));
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
    expect_input_error([&] { (void)read(gal, 0.005); }, "a.acc:4: ", "unit m/s2 in the file, gal stated");
    expect_input_error([&] { (void)read(1, 0.02); }, "a.acc:2: ", "time step of 0.005 s in the file, 0.02 s stated");
    expect_input_error([&] { (void)read(1, 0.02, true); }, "a.acc:2: ", "0.02 s stated");
    auto const in_text = testing::read_record(prose_list, {.name = "a.acc"});
    EXPECT_EQ(in_text.time_step_s, 0.005);
    EXPECT_EQ(in_text.horizontal_mps2[3], -5);
}

TEST(Contradictions, ColumnsAgainstTheirComments) {
    std::string const text = "# Time (s),Acceleration (g's)\n0,0.1\n0.5,-0.2\n";
    EXPECT_EQ(testing::read_record(text, {.unit_mps2 = g0}).horizontal_mps2[1], -0.2 * g0);
    expect_input_error([&] { (void)testing::read_record(text, {.name = "a.csv", .unit_mps2 = gal}); },
                       "a.csv:1: ", "unit g in the file, gal stated");
    EXPECT_EQ(testing::read_record(text, {.name = "a.csv"}).horizontal_mps2[1], -0.2 * g0);
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
