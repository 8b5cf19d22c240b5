// Requirement R-107: K-NET and KiK-net counts become accelerations whose peak is the header's own, or the file is
// refused.
#include <cmath>
#include <string>

#include "core/units.hpp"
#include "motion/record.hpp"
#include "support/expect_input_error.hpp"
#include "support/read_record.hpp"
#include "support/tolerance.hpp"

namespace overturn {
namespace {

using testing::exact_formula;
using testing::expect_input_error;
using testing::near;

struct Parts {
    std::string frequency = "100Hz", duration = "1", direction = "N-S", scale = "2000(gal)/1000", peak = "42.0";
};

/// 100 counts of 1000 +/- 1, one peak of 22 above and one below: mean 1000, peak 21 counts of 2 gal.
std::string knet(Parts const& parts = {}, int values = 100) {
    std::string text =
        "Origin Time       2018/01/24 19:51:00\nLat.              41.0\nLong.             142.5\n"
        "Depth. (km)       30\nMag.              6.2\nStation Code      XXX008\n"
        "Station Lat.      41.0840\nStation Long.     141.2552\nStation Height(m) 502.5\n"
        "Record Time       2018/01/24 19:51:36\nSampling Freq(Hz) "
        + parts.frequency + "\nDuration Time(s)  " + parts.duration + "\nDir.              " + parts.direction
        + "\nScale Factor      " + parts.scale + "\nMax. Acc. (gal)   " + parts.peak
        + "\nLast Correction   2018/01/24 19:51:36\nMemo.             \n";
    for (int i = 0; i < values; ++i) {
        int const peak = i == 40 ? 20 : i == 41 ? -20 : 0;
        text += fmt::format("{:8d} ", 1000 + peak + (i % 2 == 0 ? 1 : -1));
        text += i % 8 == 7 || i + 1 == values ? "\n" : "";
    }
    return text;
}

GroundMotion read(std::string const& content, RecordRequest request = {}) {
    request.name = "a.NS";
    return testing::read_record(content, request);
}

TEST(Knet, CountsTimesScaleWithoutTheirMean) {
    auto const motion = read(knet());

    EXPECT_EQ(motion.time_step_s, 0.01);
    ASSERT_EQ(motion.samples(), 100U);
    EXPECT_TRUE(near(motion.horizontal_mps2[0], 0.02, exact_formula));
    EXPECT_TRUE(near(motion.horizontal_mps2[40], 0.42, exact_formula));
    EXPECT_TRUE(near(motion.horizontal_mps2[41], -0.42, exact_formula));
}

TEST(Knet, DirectionAndLineEndsChangeNothing) {
    auto const plain = read(knet()).horizontal_mps2;
    for (char const* direction : {"U-D", "E-W", "5"}) {
        EXPECT_EQ(read(knet({.direction = direction})).horizontal_mps2, plain);
    }
    std::string crlf;
    for (char const c : knet()) {
        crlf += c == '\n' ? std::string("\r\n") : std::string(1, c);
    }
    EXPECT_EQ(read(crlf).horizontal_mps2, plain);
    EXPECT_EQ(read(knet({.frequency = "200Hz", .duration = "0.5"})).time_step_s, 0.005);
}

TEST(Knet, PeakMustBeTheHeadersToItsPrintedDigits) {
    EXPECT_NO_THROW((void)read(knet({.peak = "42"})));
    EXPECT_NO_THROW((void)read(knet({.peak = "42.000"})));
    expect_input_error([] { (void)read(knet({.peak = "42.1"})); }, "a.NS:15: ", "42 gal", "42.1");
    expect_input_error([] { (void)read(knet({.scale = "2003(gal)/1000"})); }, "a.NS:15: ");
}

TEST(Knet, TruncatedFileIsRefused) {
    expect_input_error([] { (void)read(knet({.duration = "3"})); }, "100 values where the header promises 3 s",
                       "a.NS:30");
    expect_input_error([] { (void)read(knet().substr(0, knet().find("Duration"))); }, "a.NS:11: ", "11 header lines");
    expect_input_error([] { (void)read(knet({}, 0)); }, "0 values");
    for (int const lost : {1, 4, 12, 28, 52}) {  // the last value; 1, 2, 4 and 7 lines
        expect_input_error([&] { (void)read(knet({}, 100 - lost)); }, std::to_string(100 - lost) + " values",
                           "at 100 Hz, 100 values", "cut short");
    }
    expect_input_error([] { (void)read(knet({}, 101)); }, "101 values", "too many");
}

TEST(Knet, FileCutWithinItsLastCountIsRefused) {
    auto const whole = knet();
    EXPECT_EQ(read(whole.substr(0, whole.size() - 1)).samples(), 100U);  // the line end
    EXPECT_EQ(read(whole.substr(0, whole.size() - 2)).samples(), 100U);  // and the blank
    for (std::size_t const lost : {3U, 4U, 5U}) {                        // digits of 999
        expect_input_error([&] { (void)read(whole.substr(0, whole.size() - lost)); }, "a.NS:30: ", "cut short");
    }
}

TEST(Knet, EveryHeaderLineMustHaveItsKey) {
    auto const whole = knet();
    std::size_t begin = 0;
    for (int line = 1; line <= 17; ++line) {
        auto const end = whole.find('\n', begin) + 1;
        auto without = whole;
        without.erase(begin, end - begin);
        expect_input_error([&] { (void)read(without, {.format = "knet"}); }, fmt::format("a.NS:{}: ", line),
                           "a K-NET header has '" + whole.substr(begin, 4));
        begin = end;
    }
}

TEST(Knet, DamagedHeaderOrDataAreRefusedWithTheirLine) {
    expect_input_error([] { (void)read(knet({.frequency = "0Hz"})); }, "a.NS:11: ", "above 0");
    expect_input_error([] { (void)read(knet({.frequency = "nanHz"})); }, "a.NS:11: ");
    expect_input_error([] { (void)read(knet({.scale = "2000/1000"})); }, "a.NS:14: ", "3920(gal)/6182761");
    expect_input_error([] { (void)read(knet({.scale = "2000(gal)/0"})); }, "a.NS:14: ", "above 0");
    expect_input_error([] { (void)read(knet({.peak = ""})); }, "a.NS:15: ");
    expect_input_error([] { (void)read(knet() + "    nan\n"); }, "a.NS:31: ", "'nan'");
    auto missing_line = knet();
    missing_line.erase(0, missing_line.find('\n') + 1);
    expect_input_error([&] { (void)read(missing_line, {.format = "knet"}); }, "a.NS:1: ", "'Origin Time' here");
}

TEST(Knet, StatedUnitAndStepMustNotContradict) {
    EXPECT_NO_THROW(
        (void)read(knet(), {.unit_mps2 = unit_factor("gal", Dimension::acceleration), .time_step_s = 0.01}));
    expect_input_error([] { (void)read(knet(), {.unit_mps2 = g0}); }, "a.NS:14: ", "contradict");
    expect_input_error([] { (void)read(knet(), {.time_step_s = 0.02}); }, "a.NS:11: ", "contradict");
}

}  // namespace
}  // namespace overturn
