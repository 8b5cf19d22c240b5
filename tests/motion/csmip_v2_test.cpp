// Requirement R-107: CSMIP/CDMG V2 files give every channel's corrected acceleration with its printed peak; uncorrected
// files are refused by name.
#include <string>

#include "motion/record.hpp"
#include "support/expect_input_error.hpp"
#include "support/read_record.hpp"

namespace overturn {
namespace {

using testing::expect_input_error;

struct Parts {
    std::string name = "90 DEG", peak = "-267.957", number = "1";
    int count = 10;
    std::string step = ".020", unit = "CM/SEC/SEC";
};

std::string block(std::string const& what, int count, std::string const& step, std::string const& unit, double start) {
    std::string text =
        fmt::format("{:5d} POINTS OF {} DATA EQUALLY SPACED AT  {} SEC.  (UNITS: {})\n", count, what, step, unit);
    for (int i = 0; i < count; ++i) {
        text += fmt::format("{:10.3f}", i == 3 ? start : 0.001 * i) + (i % 8 == 7 || i + 1 == count ? "\n" : "");
    }
    return text;
}

std::string channel(Parts const& parts = {}) {
    return "CORRECTED ACCELEROGRAM   36456-S4384-83123.01       CHAN  " + parts.number + ": " + parts.name
           + "     FROM\nUNCORRECTED ACCELEROGRAM DATA              PROCESSED:  6/06/83, CDMG QC83A456\n"
             "CHAN  "
           + parts.number + ": " + parts.name + "\n  " + std::to_string(parts.count)
           + " POINTS OF INSTRUMENT- AND BASELINE-CORRECTED ACCEL, VELOC AND DISPL DATA\n"
             "PEAK ACCELERATION =  "
           + parts.peak
           + "    CM/SEC/SEC  AT   10.940   SEC.\n"
             "PEAK   VELOCITY   =   -28.253      CM/SEC    AT   11.100   SEC.\n"
             "    1    1    1    3    3    0    1    1    0    0    0    0    0    0    0    0\n"
             "      .041      .630    65.000      .030      .100     1.870     -.275    10.947\n"
           + block("ACCEL", parts.count, parts.step, parts.unit, std::stod(parts.peak))
           + block("VELOC", parts.count, parts.step, "CM/SEC", 900)
           + block("DISPL", parts.count, parts.step, "CM", 900) + "/&  ----------  END OF DATA FOR CHANNEL  1  ------\n";
}

GroundMotion read(std::string const& content, RecordRequest request = {}) {
    request.name = "a.V2";
    return testing::read_record(content, request);
}

TEST(CsmipV2, OneChannel) {
    auto const motion = read(channel());

    EXPECT_EQ(motion.time_step_s, 0.02);
    ASSERT_EQ(motion.samples(), 10U);
    EXPECT_EQ(motion.horizontal_mps2[2], 0.002 * 0.01);
    EXPECT_EQ(motion.horizontal_mps2[3], -267.957 * 0.01);
}

// of Volume II without a unit behind its count the line on the peak says it, and the values have that peak.
TEST(CsmipV2, TheUnitMayStandAtThePeak) {
    auto const without_unit = [](Parts const& parts) {
        auto text = channel(parts);
        for (auto at = text.find("  (UNITS:"); at != std::string::npos; at = text.find("  (UNITS:")) {
            text.erase(at, text.find(')', at) + 1 - at);
        }
        return text;
    };
    EXPECT_EQ(read(without_unit({})).horizontal_mps2[3], -267.957 * 0.01);
    expect_input_error([&] { (void)read(without_unit({.peak = "0"})); }, "a.V2:", "unit other than CM/SEC/SEC");
}

TEST(CsmipV2, ChannelsFindTheirPlaces) {
    auto const three = channel({.name = "90 DEG"})
                       + channel({.name = "UP", .peak = "94.805", .number = "2", .count = 9})
                       + channel({.name = "  0 DEG", .number = "3"});
    std::string crlf;
    for (char const c : three + "\x1a\x1a\x1a") {
        crlf += c == '\n' ? std::string("\r\n") : std::string(1, c);
    }

    auto const placed = read_placed(three, {.name = "a.V2"});

    EXPECT_EQ(placed.says, "90 DEG, transverse 0 DEG, vertical UP, cut to 9 samples");
    EXPECT_EQ(placed.motion.vertical_mps2[3], 94.805 * 0.01);
    EXPECT_EQ(read(crlf).vertical_mps2, placed.motion.vertical_mps2);
    EXPECT_EQ(read(three, {.component = "0deg"}).samples(), 9U);
    auto const alone = read(three, {.component = "up", .components = ComponentChoice::horizontal});
    EXPECT_EQ(alone.horizontal_mps2[3], 94.805 * 0.01);
    EXPECT_TRUE(alone.vertical_mps2.empty());
    expect_input_error([&] { (void)read(three, {.component = "45 DEG"}); }, "a.V2: ", "'45 DEG'", "Known: 90 DEG, UP");
}

TEST(CsmipV2, ManySensorsMustBeChosenFrom) {
    auto const four = channel({.name = "90 DEG"}) + channel({.name = "90 DEG", .number = "2"})
                      + channel({.name = "0 DEG", .number = "3"}) + channel({.name = "UP", .number = "4"});
    expect_input_error([&] { (void)read(four); }, "a.V2: ", "second horizontal");
    auto const one = read(four, {.component = "90 DEG (channel 2)", .components = ComponentChoice::horizontal});
    EXPECT_EQ(one.samples(), 10U);
}

// Since about 2000 the lines are written in mixed case, with another name of the unit and the format behind it.
TEST(CsmipV2, NewerLayoutIsReadTheSameWay) {
    auto newer = channel();
    for (auto const& [older, now] :
         {std::pair{"CHAN  1", "Chan  1"},
          {"CORRECTED ACCELEROGRAM   ", "Corrected accelerogram   "},
          {"POINTS OF ACCEL DATA EQUALLY SPACED AT", "points of accel data equally spaced at"},
          {"SEC.  (UNITS: CM/SEC/SEC)", "sec, in cm/sec2. (8f10.6)"}}) {
        ASSERT_NE(newer.find(older), std::string::npos) << older;
        newer.replace(newer.find(older), std::string(older).size(), now);
    }

    EXPECT_EQ(read(newer).horizontal_mps2, read(channel()).horizontal_mps2);
    EXPECT_EQ(read_placed(newer, {.name = "a.V2"}).says, read_placed(channel(), {.name = "a.V2"}).says);
}

TEST(CsmipV2, DamageIsRefusedWithItsLine) {
    expect_input_error([] { (void)read(channel({.unit = "G/10"})); }, "a.V2:9: ", "CM/SEC/SEC");
    expect_input_error([] { (void)read(channel({.step = "0.00"})); }, "a.V2:9: ", "step above 0");
    auto const whole = channel();
    expect_input_error([&] { (void)read(whole.substr(0, whole.find("VELOC DATA") - 30)); }, "a.V2:", "cut short");
    auto other_peak = whole;
    other_peak.replace(other_peak.find("-267.957"), 8, "-267.958");
    expect_input_error([&] { (void)read(other_peak); }, "a.V2:5: ", "267.958");
    expect_input_error([] { (void)read(channel() + channel({.name = "UP", .number = "2", .step = ".010"})); },
                       "0.01 s");
    expect_input_error([] { (void)read(channel(), {.time_step_s = 0.01}); }, "a.V2:9: ", "contradict");
    expect_input_error([] { (void)read("x\n", {.format = "csmip-v2"}); }, "POINTS OF ACCEL DATA");
}

// A whole channel ends with its displacement: no cut before that may cost a component in silence.
TEST(CsmipV2, FileCutWithinAnyBlockIsRefused) {
    auto const three = channel({.name = "90 DEG"}) + channel({.name = "UP", .peak = "94.805", .number = "2"})
                       + channel({.name = "0 DEG", .number = "3"});
    auto const first = channel({.name = "90 DEG"}).size();
    auto const cut_after = [&](std::string const& text, std::size_t from, std::size_t more) {
        return three.substr(0, three.find(text, from) + more);
    };
    constexpr std::size_t into_the_block = 120;  // past its first line, into a value
    expect_input_error([&] { (void)read(cut_after("POINTS OF VELOC", first, into_the_block)); },
                       "a.V2:31: ", "as value 6 of 10", "cut short");
    expect_input_error([&] { (void)read(cut_after("POINTS OF DISPL", 0, into_the_block)); },
                       "a.V2:16: ", "value 6 of 10");
    expect_input_error([&] { (void)read(cut_after("   10 POINTS OF DISPL", 0, 0)); }, "a.V2:14: ", "channel 1",
                       "2 of 3 blocks");
    expect_input_error([&] { (void)read(cut_after("   10 POINTS OF VELOC", first, 0)); }, "a.V2:29: ", "channel 2",
                       "1 of 3 blocks");
    expect_input_error([&] { (void)read(cut_after("PEAK ACCEL", 2 * first, 0)); }, "channel 3", "0 of 3 blocks");
    auto lost = three;
    lost.erase(lost.find("   10 POINTS OF VELOC"), 2);
    EXPECT_NO_THROW((void)read(lost));
    lost.replace(lost.find(" 10 POINTS OF VELOC"), 3, " 11");
    expect_input_error([&] { (void)read(lost); }, "a.V2:12: ", "10 points belong here");
}

TEST(RefusedFormats, SayWhatToDo) {
    expect_input_error([] { (void)read("UNCORRECTED ACCELEROGRAM DATA   RAW\n 1 2 3\n"); }, "a.V2:1: ", "V2 file");
    expect_input_error([] { (void)read("2 CORRECTED ACCELEROGRAM   1979\n 1 2\n"); }, "a.V2:2: ", "header promises 48");
    expect_input_error([] { (void)read("#StationCode: A\n#Data: 4F10.3\n 0 1 2 3\n 1 1 2 3\n", {.unit_mps2 = 0.01}); },
                       "a.V2:2: ", "CWA", "time,a_horizontal");
    expect_input_error([] { (void)read("* VOL1DS FILE:\nCOMP L1\n"); }, "BHRC");
    expect_input_error([] { (void)read("x\n", {.format = "refused"}); }, "State another");
}

}  // namespace
}  // namespace overturn
