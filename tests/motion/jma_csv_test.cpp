// Requirement R-107: JMA csv files (Shift_JIS, any line ends) give three named components, or are refused by file and
// line.
#include <string>

#include "motion/record.hpp"
#include "support/expect_input_error.hpp"
#include "support/read_record.hpp"

namespace overturn {
namespace {

using testing::expect_input_error;

std::string const shift_jis_name = "\x93\x8C\x8B\x9E\x90\xE7\x91\xE3\x93\x63\x8B\xE6";

std::string jma(std::string const& rows, std::string const& rate = "100Hz ", std::string const& unit = "gal(cm/s/s) ",
                std::string const& names = " NS,EW,UD") {
    return "SITE CODE= X1X" + shift_jis_name + "        ,38.1033,142.8600, 24,9.0,40613.6154873, 54.13, 94.51\n"
           + " LAT.=   35.6890\n LON.=  139.7559\n SAMPLING RATE= " + rate + "\n UNIT  = " + unit
           + "\nINITIAL TIME = 2011 03 11 14 47 10\n" + names + "\n" + rows;
}

std::string const rows = "-0.012,0.064,-0.010\n0.005,0.028,-0.011\n0.003,-0.007,-0.002\n";

GroundMotion read(std::string const& content, RecordRequest request = {}) {
    request.name = "a.csv";
    return testing::read_record(content, request);
}

void expect_the_rows(GroundMotion const& motion) {
    EXPECT_EQ(motion.time_step_s, 0.01);
    EXPECT_EQ(motion.horizontal_mps2, (std::vector{-0.012 * 0.01, 0.005 * 0.01, 0.003 * 0.01}));
    EXPECT_EQ(motion.transverse_mps2, (std::vector{0.064 * 0.01, 0.028 * 0.01, -0.007 * 0.01}));
    EXPECT_EQ(motion.vertical_mps2, (std::vector{-0.010 * 0.01, -0.011 * 0.01, -0.002 * 0.01}));
}

TEST(JmaCsv, ThreeColumnsInGal) {
    expect_the_rows(read(jma(rows)));
    EXPECT_EQ(read(jma(rows, "50Hz")).time_step_s, 0.02);
}

TEST(JmaCsv, LineEndsMarksAndEmptyColumnsChangeNoBit) {
    for (std::string const end : {"\r\n", "\r\r\n", ",,,,\n", "   \n"}) {
        std::string text;
        for (char const c : jma(rows)) {
            text += c == '\n' ? end : std::string(1, c);
        }
        expect_the_rows(read(end == ",,,,\n" ? jma("-0.012,0.064,-0.010,,,,\n0.005,0.028,-0.011,,,,\n"
                                                   "0.003,-0.007,-0.002,,,,")
                                             : text));
    }
    expect_the_rows(read("\xEF\xBB\xBF" + jma(rows) + "\n\n"));
}

TEST(JmaCsv, NamesOfTheColumnsAreObeyed) {
    auto const motion = read(jma(rows, "100Hz", "gal", "UD,NS,EW"));
    EXPECT_EQ(motion.vertical_mps2[0], -0.012 * 0.01);
    EXPECT_EQ(motion.horizontal_mps2[0], 0.064 * 0.01);
}

TEST(JmaCsv, VerticalColumnIsNoHorizontalShaking) {
    expect_input_error([] { (void)read(jma(rows), {.component = "UD"}); }, "a.csv: ", "component 'UD'",
                       "it is vertical", "State a horizontal component");
    EXPECT_EQ(read(jma(rows), {.component = "EW"}).vertical_mps2[0], -0.010 * 0.01);
}

TEST(JmaCsv, DamageIsRefusedWithItsLine) {
    expect_input_error([] { (void)read(jma(rows + "0.1,0.2\n")); }, "a.csv:11: ", "under UD", "cut short");
    expect_input_error([] { (void)read(jma(rows + "0.1,nan,0.2\n")); }, "a.csv:11: ", "'nan' under EW");
    expect_input_error([] { (void)read(jma(rows + "0.1,0.2,inf\n")); }, "a.csv:11: ", "'inf'");
    expect_input_error([] { (void)read(jma(rows + "1,2,3,4\n")); }, "a.csv:11: ", "after the third column");
    expect_input_error([] { (void)read(jma(rows.substr(0, rows.size() - 2))); }, "a.csv:10: ", "'-0.00' at the end");
    expect_input_error([] { (void)read(jma("")); }, "no row of numbers");
    expect_input_error([] { (void)read(jma(rows, "0Hz")); }, "a.csv:4: ", "SAMPLING RATE");
    expect_input_error([] { (void)read(jma(rows, "nanHz")); }, "a.csv:4: ", "SAMPLING RATE");
    expect_input_error([] { (void)read(jma(rows, "100")); }, "a.csv:4: ", "must read like 100Hz");
    expect_input_error([] { (void)read(jma(rows, "100Hz", "kine")); }, "a.csv:5: ", "'kine'");
    expect_input_error([] { (void)read(jma(rows, "100Hz", "gal", "A,B,C")); }, "a.csv:7: ", "NS,EW,UD");
    expect_input_error([] { (void)read(jma(rows).substr(0, 120)); }, "a.csv:");
    expect_input_error([] { (void)read(jma(rows), {.unit_mps2 = 1}); }, "a.csv:5: ", "contradict");
    expect_input_error([] { (void)read(jma(rows), {.time_step_s = 0.02}); }, "a.csv:4: ", "contradict");
}

}  // namespace
}  // namespace overturn
