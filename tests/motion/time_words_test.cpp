// Requirement R-107: the unit of times is their name's or the text's, never a guess; a first column under an unknown
// name is no time.
#include "motion/detail/time_words.hpp"

#include <string>

#include <fmt/format.h>

#include "support/expect_input_error.hpp"
#include "support/read_record.hpp"

namespace overturn {
namespace {

using testing::expect_input_error;

std::string over(std::string const& name, std::string const& line = "# station X") {
    return fmt::format("{}\n{},acc [gal]\n0,10\n10,-20\n20,30\n30,-5\n", line, name);
}

TEST(TimeWords, MillisecondsOfANameAreRead) {
    for (char const* name : {"ms", "msec", "millis", "milliseconds", "t/ms", "time_ms", "time-ms", "time.ms",
                             "Time (ms)", "tms", "t [msec]", "time millis", "Time / ms"}) {
        EXPECT_NEAR(testing::read_record(over(name), {.name = "a"}).time_step_s, 0.01, 1e-15) << name;
    }
    for (char const* name :
         {"t", "time", "T", "s", "sec", "t/s", "tsec", "Time (s)", "Time [s] (relative)", "relative time (s)", "x",
          "Zeit", "elapsed time", "Seconds from start", "Time UTC", "UTC", "time axis"}) {
        EXPECT_EQ(testing::read_record(over(name), {.name = "a"}).time_step_s, 10) << name;
    }
}

TEST(TimeWords, MillisecondsOfTheTextAreRead) {
    for (char const* line : {"# t: ms", "# time in ms", "# times in milliseconds", "# Time [ms]", "# time unit: ms",
                             "# gal, time in ms", "# t in ms; acc in gal"}) {
        auto const placed = read_placed(over("t", line), {.name = "a"});
        EXPECT_NEAR(placed.motion.time_step_s, 0.01, 1e-15) << line;
        EXPECT_TRUE(placed.unread.empty()) << line;
    }
    EXPECT_EQ(testing::read_record(over("t", "# time in minutes"), {.name = "a"}).time_step_s, 600);
    for (char const* line : {"# trigger time: 12 ms", "# station X", "# start time 14:46:18", "# time in s", "# t h v",
                             "# arrival time in ms at station X"}) {
        EXPECT_EQ(testing::read_record(over("t", line), {.name = "a"}).time_step_s, 10) << line;
    }
    expect_input_error([] { (void)testing::read_record(over("t [s]", "# time in ms"), {.name = "a"}); },
                       "a:1: ", "times in ms, column 't [s]' (they contradict each other)");
}

TEST(TimeWords, AFactorInTheNameIsRefused) {
    for (char const* name : {"t*10", "time/10 (s)", "scaled time", "time x100", "time^2", "t+t0", "time (s) x 10",
                             "t [s]/10", "Time (s) * 10"}) {
        expect_input_error([&] { (void)testing::read_record(over(name), {.name = "a"}); }, "a:2: ", "tate ", "columns");
    }
    EXPECT_EQ(testing::read_record(over("t*10"), {.name = "a", .columns = "time,h1"}).time_step_s, 10);
}

TEST(TimeWords, AnUnknownNameIsNoTime) {
    for (char const* name : {"foo", "frame", "tau"}) {
        expect_input_error([&] { (void)testing::read_record(over(name), {.name = "a"}); },
                           "a:2: ", "State --columns time,h1");
    }
    expect_input_error([] { (void)testing::read_record(over("x [m]"), {.name = "a"}); }, "a:3: ", "time step missing");
    expect_input_error([] { (void)testing::read_record(over("Period (s)"), {.name = "a"}); },
                       "a:2: column 'Period (s)' (a frequency or a period");
    EXPECT_EQ(testing::read_record(over("foo"), {.name = "a", .columns = "time,h1"}).time_step_s, 10);
}

}  // namespace
}  // namespace overturn
