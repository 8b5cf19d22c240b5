// Requirement R-107: COSMOS v1.20 files are read by what their headers state (dt: real-header value 62, in
// milliseconds), channel by channel, and raw counts or contradictions are refused by file and line.
#include <cmath>
#include <string>

#include "core/units.hpp"
#include "motion/record.hpp"
#include "support/expect_input_error.hpp"
#include "support/read_record.hpp"

namespace overturn {
namespace {

using testing::expect_input_error;

struct Parts {
    std::string data = "6 acceleration pts, approx  0 secs, units=cm/sec2(04),Format=(1E15.6)";
    double step_ms = 5, peak = 50;
    int orientation = 360;
    std::string values = {};
    std::string comments = "   1 Comment line(s) follow, each starting with a \"|\"\n| 1 2 3 \n";
    std::string end = "End-of-data for Chan 1 acceleration\n";
    bool wide = false;
};

std::string const six_lines =
    "   1.000000E+01\n  -2.000000E+01\n   3.000000E+01\n   0.000000E+00\n  -5.000000E+01\n   4.000000E+01\n";

/// One channel; reals in 17 lines of (6F13.6), or 20 of (5F15.6).
std::string channel(Parts const& parts = {}) {
    std::string text = "Corrected acceleration  (Format v01.20 with 13 text lines)\n";
    for (int i = 2; i <= 13; ++i) {
        text += "text line " + std::to_string(i) + " with 0.02 and 42 in it\n";
    }
    text += " 100 Integer-header values follow on  10 lines, Format= (10I8)\n";
    for (int i = 1; i <= 100; ++i) {
        text += fmt::format("{:8d}", i == 54 ? parts.orientation : i == 40 ? 2019 : -999) + (i % 10 == 0 ? "\n" : "");
    }
    int const per_line = parts.wide ? 5 : 6;
    text += parts.wide ? " 100 Real-header values follow on  20 lines , Format = (5F15.6)\n"
                       : " 100 Real-header values follow on  17 lines, Format= (6F13.6)\n";
    for (int i = 1; i <= 100; ++i) {
        double const value = i == 62   ? parts.step_ms
                             : i == 34 ? 0.02
                             : i == 64 ? parts.peak
                             : i == 1  ? 33.9753
                             : i == 2  ? -117.4865
                                       : -999;
        text += parts.wide ? fmt::format("{:15.6f}", value) : fmt::format("{:13.6f}", value);
        text += i % per_line == 0 || i == 100 ? "\n" : "";
    }
    return text + parts.comments + parts.data + "\n" + (parts.values.empty() ? six_lines : parts.values) + parts.end;
}

GroundMotion read(std::string const& content, RecordRequest request = {}) {
    request.name = "a.V2c";
    return testing::read_record(content, request);
}

std::vector<double> const six{10 * 0.01, -20 * 0.01, 30 * 0.01, 0.0, -50 * 0.01, 40 * 0.01};

TEST(Cosmos, StepIsRealHeaderValue62InMilliseconds) {
    for (bool const wide : {false, true}) {
        auto const motion = read(channel({.wide = wide}));
        EXPECT_EQ(motion.time_step_s, 0.005);
        EXPECT_EQ(motion.horizontal_mps2, six);
    }
    EXPECT_EQ(read(channel({.comments = ""})).horizontal_mps2, six);
}

TEST(Cosmos, StepInSecondsContradictsTheDuration) {
    Parts parts{.data = "6 acceleration pts, approx  60 secs, units=cm/sec2(04),Format=(1E15.6)", .step_ms = 10000};
    EXPECT_EQ(read(channel(parts)).time_step_s, 10);
    parts.step_ms = 10;  // of seconds
    expect_input_error([&] { (void)read(channel(parts)); }, "a.V2c:45: ", "value 62", "milliseconds");
}

TEST(Cosmos, MissingStepMustBeStated) {
    auto const text = channel({.step_ms = -999});
    expect_input_error([&] { (void)read(text); }, "a.V2c:45: ", "time step missing");
    EXPECT_EQ(read(text, {.time_step_s = 0.01}).time_step_s, 0.01);
    expect_input_error([] { (void)read(channel(), {.time_step_s = 0.01}); }, "contradict");
}

TEST(Cosmos, FieldsOfFixedWidthMayTouch) {
    auto const motion = read(channel({.data = "6 acceleration pts, approx 0 secs, units=cm/sec2(04),Format=(8F10.5)",
                                      .peak = 123.45678 * 9,
                                      .values = "1111.111021111.11102-123.45678   0.00000  -1.00000   2.00000\n"}));
    EXPECT_EQ(motion.horizontal_mps2[0], 1111.11102 * 0.01);
    EXPECT_EQ(motion.horizontal_mps2[1], 1111.11102 * 0.01);
}

// in a line that lost a blank the last field ends too early, which is no sign of a cut; elsewhere it is one.
TEST(Cosmos, ALineThatLostABlankIsWhole) {
    auto const without_one_of = [](std::string text, std::string const& part) {
        return text.erase(text.find(part), 1);
    };
    auto const placed =
        read_placed(without_one_of(channel({.orientation = 90}), "      90    -999"), {.name = "a.V2c"});
    EXPECT_EQ(placed.components, std::vector<std::string>{"90 DEG"});
    EXPECT_EQ(placed.motion.horizontal_mps2, six);
    auto cut = channel();
    auto const end = cut.find('\n', cut.find("     360    -999"));
    expect_input_error([&] { (void)read(cut.erase(end - 1, 1)); }, "a.V2c:20: ", "'-99' as value 60 of 100");
}

TEST(Cosmos, UnitsMayEndWithAStop) {
    auto const motion = read(channel({.data = "6 acceleration pts, approx 0 secs, units=g.     (02)Format=(6f9.6)",
                                      .peak = 0.3,
                                      .values = "  .100000 -.200000  .300000  .000000  .000000  .100000\n"}));
    EXPECT_EQ(motion.horizontal_mps2[2], 0.3 * g0);
}

TEST(Cosmos, ChannelsAreNamedByTheirAzimuth) {
    auto const all = channel({.orientation = 90}) + channel({.orientation = 400})
                     + channel({.data = "6 velocity     pts, approx 0 secs, units=cm/sec(05),Format=(1E15.6)"})
                     + channel({.orientation = 360, .end = "/&  ---  End of data for channel  3  ---\n"});

    auto const placed = read_placed(all, {.name = "a.V2c"});

    EXPECT_EQ(placed.says, "90 DEG, transverse 360 DEG, vertical UP");
    EXPECT_EQ(placed.motion.vertical_mps2, six);
}

TEST(Cosmos, DownwardsIsTurned) {
    auto const placed = read_placed(channel({.orientation = 90}) + channel({.orientation = 401}), {.name = "a.V2c"});
    EXPECT_EQ(placed.says, "90 DEG, vertical DOWN with its sign turned");
    EXPECT_EQ(placed.motion.vertical_mps2[0], -0.1);
    EXPECT_FALSE(std::signbit(placed.motion.vertical_mps2[3]));
}

TEST(Cosmos, CountsAreRefused) {
    expect_input_error(
        [] {
            (void)read(channel({.data = "6 raw accel.   pts, approx 0 secs, units= counts(50),Format=(1I8)",
                                .values = "       1\n       2\n       3\n       4\n       5\n       6\n"}));
        },
        "a.V2c:45: ", "raw counts", "V1 or V2");
}

TEST(Cosmos, OtherUnitsAndQuantitiesAreRefused) {
    expect_input_error([] { (void)read(channel({.data = "6 acceleration pts, units=ft/sec2(09),Format=(1E15.6)"})); },
                       "a.V2c:45: ", "'ft/sec2'");
    expect_input_error([] { (void)read(channel({.data = "6 velocity pts, units=cm/sec(05),Format=(1E15.6)"})); },
                       "no acceleration");
    EXPECT_EQ(read(channel({.data = "6 acceleration pts, units=g(02),Format=(1E15.6)",
                            .peak = 0.5,
                            .values = "   1.000000E-01\n  -2.000000E-01\n   3.000000E-01\n   0.000000E+00\n"
                                      "  -5.000000E-01\n   4.000000E-01\n"}))
                  .horizontal_mps2[4],
              -0.5 * g0);
}

// R-107: -999 marks a missing value, with or without a peak in the header, and is never read as an acceleration.
TEST(Cosmos, MissingValuesAreRefusedWithTheirLine) {
    auto const gap = six_lines.substr(0, 32) + "  -9.990000E+02\n" + six_lines.substr(48);
    for (double const peak : {-999.0, 999.0}) {
        expect_input_error([&] { (void)read(channel({.peak = peak, .values = gap})); },
                           "a.V2c:48: ", "-999 as value 3 of 6", "missing");
    }
    expect_input_error(
        [] {
            (void)read(channel({.data = "6 acceleration pts, approx 0 secs, units=cm/sec2(04),Format=(4F8.1)",
                                .peak = -999,
                                .values = "     1.0     2.0     3.0     4.0\n     5.0  -999.0\n"}));
        },
        "a.V2c:47: ", "value 6 of 6");
    EXPECT_EQ(read(channel({.peak = -999})).horizontal_mps2, six);  // the header may lack its peak
}

TEST(Cosmos, AnotherFormatIsNotTakenForVelocity) {
    expect_input_error([] { (void)read("PEER\nA, B\nNPTS= 2, DT= .02 SEC\n 0.0 .1\n", {.format = "cosmos"}); },
                       "a.V2c: ", "no line '100 Integer-header values follow'", "State another format");
}

TEST(Cosmos, DamageIsRefusedWithItsLine) {
    auto const whole = channel({.end = ""});
    expect_input_error([&] { (void)read(whole.substr(0, whole.size() - 20)); }, "a.V2c:50: ", "cut short");
    expect_input_error([&] { (void)read(whole.substr(0, whole.size() - 5)); }, "a.V2c:51: ", "cut short");
    expect_input_error([] { (void)read(channel({.peak = 80})); }, "a.V2c:45: ", "80");
    expect_input_error([] { (void)read(channel({.end = "   1.000000E+00\n"})); }, "a.V2c:52: ", "after the promised");
    expect_input_error([] { (void)read(channel({.values = six_lines.substr(0, 64) + "            NaN\n\n\n"})); },
                       "a.V2c:50: ", "'NaN'");
    expect_input_error([] { (void)read(channel({.comments = " 2 Comment line(s) follow\n| one\n"})); },
                       "a.V2c:45: ", "2 comment lines");
    expect_input_error([] { (void)read(channel().substr(0, 1500)); }, "a.V2c:");
}

}  // namespace
}  // namespace overturn
