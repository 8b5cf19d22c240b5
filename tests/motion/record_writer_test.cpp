// Requirement R-903: what is written as AT2 or csv is read back by our own readers, component by component.
#include "motion/record_writer.hpp"

#include <cmath>

#include "core/units.hpp"
#include "motion/station.hpp"
#include "support/expect_input_error.hpp"
#include "support/read_record.hpp"
#include "support/waves.hpp"

namespace overturn {
namespace {

constexpr double eight_digits = 5e-8;  // of the value

TEST(At2Text, IsReadBackToItsEightDigits) {
    auto values = testing::broad_wave(1003, 0.005);
    values[7] = -1.2345678e-104;  // fields of fifteen characters touch
    values[8] = -9.87654321e-103;
    auto const read = testing::read_record(at2_text(values, 1.0 / 60, "c.toml, seed 1, wave 2", "H1"), {});

    EXPECT_EQ(read.time_step_s, 1.0 / 60);
    ASSERT_EQ(read.samples(), values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        ASSERT_NEAR(read.horizontal_mps2[i], values[i], eight_digits * std::abs(values[i])) << i;
    }
    EXPECT_EQ(at2_text(std::vector{g0, -0.5 * g0}, 0.01, "a", "UP"),
              "ACCELEROGRAM IN THE LAYOUT OF PEER AT2\na, UP\nACCELERATION TIME SERIES IN UNITS OF G\n"
              "NPTS= 2, DT= 0.01 SEC\n  1.0000000E+00 -5.0000000E-01\n");
}

TEST(At2Text, ComponentsFindEachOther) {
    std::vector const a{0.0, 1.0}, b{0.0, 2.0}, c{0.0, -3.0};
    InputFiles files({{"w-H1.at2", at2_text(a, 0.01, "c.toml, seed 1, wave 2", "H1")},
                      {"w-H2.at2", at2_text(b, 0.01, "c.toml, seed 1, wave 2", "H2")},
                      {"w-UP.at2", at2_text(c, 0.01, "c.toml, seed 1, wave 2", "UP")},
                      {"v-UP.at2", at2_text(b, 0.01, "c.toml, seed 1, wave 3", "UP")}});

    auto const placed = StationFiles(files).read("w-H1.at2", {.components = ComponentChoice::station});

    EXPECT_EQ(placed.says, "w-H1.at2, transverse w-H2.at2, vertical w-UP.at2");
    EXPECT_NEAR(placed.motion.transverse_mps2[1], 2, 2 * eight_digits);
    EXPECT_NEAR(placed.motion.vertical_mps2[1], -3, 3 * eight_digits);
}

TEST(CsvText, IsReadBackBitForBit) {
    GroundMotion motion;
    motion.time_step_s = 0.01;
    motion.horizontal_mps2 = testing::broad_wave(300, 0.01);
    for (int components = 1; components <= 4; ++components) {
        motion.transverse_mps2 = components == 2 || components == 4 ? motion.horizontal_mps2 : std::vector<double>{};
        motion.vertical_mps2 = components >= 3 ? motion.horizontal_mps2 : std::vector<double>{};
        auto const read = testing::read_record(csv_text(motion), {.unit_mps2 = 1});
        EXPECT_EQ(read.horizontal_mps2, motion.horizontal_mps2);
        EXPECT_EQ(read.transverse_mps2, motion.transverse_mps2);
        EXPECT_EQ(read.vertical_mps2, motion.vertical_mps2);
        EXPECT_NEAR(read.time_step_s, 0.01, 1e-15);
    }
}

}  // namespace
}  // namespace overturn
