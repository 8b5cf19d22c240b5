// Requirement R-107: numbers that names or text call strain, pressure, force, rotation or the like are no
// accelerations, whatever unit is stated; text that speaks of such a thing beside accelerations is no reason to refuse
// them.
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "motion/record.hpp"
#include "support/expect_input_error.hpp"
#include "support/read_record.hpp"

namespace overturn {
namespace {

using testing::expect_input_error;

RecordRequest const stated{.name = "f", .unit_mps2 = 1, .time_step_s = 0.01};

constexpr auto labels =
    std::to_array<char const*>({"Strain time history",
                                "Pore pressure (kPa)",
                                "Excess pore water pressure",
                                "Temperature record",
                                "Seismic intensity (JMA)",
                                "Force (kN)",
                                "Base shear force",
                                "Moment kNm",
                                "Rotation (deg)",
                                "Rotation rate rad/s",
                                "Tilt [rad]",
                                "Stress history MPa",
                                "Interstory drift ratio",
                                "data type: torque",
                                "Load cell",
                                "mV",
                                "Wind speed",
                                "Dehnung",
                                "\xE3\x81\xB2\xE3\x81\x9A\xE3\x81\xBF",              // strain
                                "\xE9\x96\x93\xE9\x9A\x99\xE6\xB0\xB4\xE5\x9C\xA7",  // pore pressure
                                "\xE9\x9C\x87\xE5\xBA\xA6",                          // seismic intensity
                                "\xE8\xA7\x92\xE9\x80\x9F\xE5\xBA\xA6"});            // angular velocity

TEST(OtherQuantities, LabelsOfThemAreRefused) {
    for (auto const* label : labels) {
        SCOPED_TRACE(label);
        expect_input_error([&] { (void)read_placed(fmt::format("{}\n1\n-2\n3\n", label), stated); },
                           "f:1: ", "accelerations are read");
        expect_input_error([&] { (void)read_placed(fmt::format("# {}\n0 1\n0.01 -2\n0.02 3\n", label), stated); },
                           "f:1: ");
        expect_input_error([&] { (void)read_placed(fmt::format("t,{}\n0,1\n0.01,-2\n0.02,3\n", label), stated); },
                           "f:1: column '");
    }
}

// one value, an earthquake's size, an instrument; and what is beside accelerations.
TEST(OtherQuantities, TextThatMerelyMentionsThemIsNone) {
    for (char const* line :
         {"JMA intensity: 5.2", "Seismic intensity (JMA): 5.3", "Seismic Intensity,5.3", "Intensity VIII",
          "MMI intensity = VII", "Housner intensity (cm) 120", "Intensity: V", "Max. intensity 5+",
          "Arias intensity = 1.3", "temperature 20 C", "Seismic moment tensor", "moment magnitude",
          "Strain gauge transducer", "Reinforced structure", "Stress drop", "constrained", "forced vibration",
          "Rotation: 30 deg", "Pressure waves arrive first at this place and shake it for long"}) {
        EXPECT_NO_THROW((void)read_placed(fmt::format("{}\n1\n-2\n3\n", line), stated)) << line;
    }
    EXPECT_NO_THROW((void)read_placed("Acceleration\nSeismic intensity (JMA)\n1\n-2\n3\n", stated));
    EXPECT_NO_THROW((void)read_placed("t,acc,pressure (kPa)\n0,1,5\n0.01,-2,6\n0.02,3,5\n", stated));
}

// a value of intensity beside accelerations is a fact about the record; a column or a label of it is none.
TEST(OtherQuantities, AnIntensityOfTheRecordIsNoQuantityOfItsNumbers) {
    std::string const rows = "0,1,2\n0.01,-2,3\n0.02,3,-1\n";
    for (char const* line : {"Seismic intensity (JMA): 5.3", "# Max. intensity", "# \xE9\x9C\x87\xE5\xBA\xA6: 5",
                             "# Instrumental intensity = 5.1 (JMA)", "Seismic intensity of this record 5.1"}) {
        auto const placed = read_placed(fmt::format("{}\ntime (s),NS (gal),UD (gal)\n{}", line, rows), {.name = "f"});
        EXPECT_EQ(placed.motion.horizontal_mps2[1], -0.02) << line;
        EXPECT_EQ(placed.motion.vertical_mps2[1], 0.03) << line;
    }
    for (char const* head :
         {"Seismic intensity\ntime,NS,UD\n", "# Intensity (JMA)\ntime,NS,UD\n", "time,intensity,UD\n",
          "time,NS,JMA intensity\n", "time,NS,\xE9\x9C\x87\xE5\xBA\xA6\n", "# JMA intensity, running\n"}) {
        expect_input_error([&] { (void)read_placed(head + rows, stated); }, "f:1: ");
    }
}

// a velocity by a letter before its direction, by words of its unit, or by what was done to accelerations.
TEST(OtherQuantities, VelocitiesInDisguiseAreRefused) {
    std::string const rows = "0,1\n0.01,-2\n0.02,3\n";
    for (char const* head : {"t,V_NS\n", "t,vEW\n", "t,v-ud\n", "t,D_EW\n", "t,NS (V)\n", "t,NS (um/s)\n",
                             "# Integrated acceleration\nt,NS\n", "# integrated once\nt,NS\n",
                             "# micrometers per second\nt,NS\n", "# nm/s\nt,NS\n"}) {
        expect_input_error([&] { (void)read_placed(head + rows, stated); }, "f:1: ");
    }
    for (char const* name : {"UD", "U-D", "Ver", "acc (V)", "Comp (V)"}) {
        EXPECT_NO_THROW((void)read_placed(fmt::format("t,NS,{}\n0,1,2\n0.01,-2,3\n0.02,3,-1\n", name), stated)) << name;
    }
    for (char const* line : {"# Normalised acceleration", "# Relative acceleration"}) {
        EXPECT_EQ(read_placed(fmt::format("{}\nt,NS\n{}", line, rows), stated).unread.size(), 1U) << line;
    }
}

// a line of names that parts as the rows do, but into more or fewer, is not dropped, known names or not.
TEST(OtherQuantities, NamesOfAnotherNumberAreNotDropped) {
    for (char const* text :
         {"foo,bar,baz\n0,1\n0.01,-2\n", "foo;bar\n0;1;2\n0.01;-2;3\n", "# one\ttwo\tthree\n0\t1\n0.01\t-2\n"}) {
        expect_input_error([&] { (void)read_placed(text, stated); }, "f:1: ", "another number of columns");
    }
    EXPECT_NO_THROW((void)read_placed("Recorded at the dam, far from here, by nobody\n0,1\n0.01,-2\n", stated));
    EXPECT_NO_THROW((void)read_placed("One, two, three\n0 1\n0.01 -2\n", stated));
}

// a decimal comma is called so, whatever parts the columns.
TEST(OtherQuantities, DecimalCommasAreNamed) {
    for (char const* rows :
         {"0,00;1,5\n0,01;-1,25\n", "0,00\t1,5\n0,01\t-1,25\n", "0,00 1,5\n0,01 -1,25\n", "0,00,1,5\n0,01,1,25\n"}) {
        expect_input_error([&] { (void)read_placed(fmt::format("time\tacc\n{}", rows), stated); }, "f:2: '0,00",
                           "Write decimal points");
    }
    expect_input_error([] { (void)read_placed("acc\n0,015\n", stated); }, "f:2: '0,015'", "Write decimal points");
    for (char const* rows : {"0, 1\n1, -2\n", "0,10\n1,-20\n"}) {
        EXPECT_NO_THROW((void)read_placed(rows, {.name = "f", .unit_mps2 = 1, .columns = "time,h1"}).motion) << rows;
    }
}

}  // namespace
}  // namespace overturn
