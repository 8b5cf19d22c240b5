// Requirement R-107: where no name and no line states the component of a single column, a word of the vertical anywhere
// in the text leaves it open: it is asked for, and no vertical rocks anything unseen.
#include <string>

#include <fmt/format.h>

#include "support/expect_input_error.hpp"
#include "support/read_record.hpp"

namespace overturn {
namespace {

using testing::expect_input_error;

std::string under(std::string const& line, std::string const& names = "time,acc [gal]") {
    return fmt::format("# {}\n{}\n0,10\n0.01,-20\n0.02,30\n0.03,-5\n", line, names);
}

// Refused, or placed as the vertical: never as a motion along the ground.
TEST(VerticalTokens, LeaveTheComponentOpen) {
    for (char const* line : {"Z-component of acceleration",
                             "Acceleration (Z-component)",
                             "Acceleration, Vertical-component",
                             "Acceleration V-comp",
                             "acc Z+",
                             "Acceleration along z-axis",
                             "Channel 3 UD",
                             "Comp 3 Vert",
                             "component Z, station ABC",
                             "Component: vertical upwards",
                             "Record name ABCHNZ",
                             "Acceleration_UD",
                             "Direction: Z (vertical)",
                             "Comp: V(UP)",
                             "file: 20110311_MYG004.UD",
                             "orientation -90 (vertical)",
                             "XX.ABC.00.HNZ",
                             "station of the vertical array",
                             "azimuth 0, dip -90",
                             "Dip: 90"}) {
        Direction direction = Direction::up;
        try {
            direction = read_placed(under(line), {.name = "a"}).direction;
        } catch (InputError const& error) {
            EXPECT_NE(std::string(error.what()).find("a:1: "), std::string::npos) << error.what();
        }
        EXPECT_EQ(direction, Direction::up) << line;
        RecordRequest stated{.name = "a"};
        stated.columns = "time,v";
        EXPECT_EQ(read_placed(under(line), stated).direction, Direction::up) << line;
    }
    expect_input_error([] { (void)read_placed(under("Channel 3 UD"), {.name = "a"}); }, "a:1: ", "--columns");
    expect_input_error([] { (void)read_placed("Channel 3 UD, gal, dt = 0.01 s\n1\n-2\n3\n", {.name = "a"}); },
                       "a:1: ", "--columns");
}

TEST(VerticalTokens, BesideAHorizontalOneSayNothing) {
    for (char const* line : {"NS of the components NS, EW, UD", "gal, N, E, Z", "altitude Z: 300 m",
                             "horizontal, corrected for vertical drift", "supper", "Mendoza", "fault dip 80",
                             "strike 30, dip 90, rake 0", "dip 45"}) {
        EXPECT_NO_THROW((void)read_placed(under(line), {.name = "a"})) << line;
    }
    expect_input_error([] { (void)read_placed(under("Channel 3 UD", "time,NS [gal]"), {.name = "a"}); },
                       "a:1: component 'UD'", "contradict");
    RecordRequest stated{.name = "a"};
    stated.columns = "time,h1";
    EXPECT_EQ(read_placed(under("Channel 3 UD"), stated).direction, Direction::horizontal);
}

}  // namespace
}  // namespace overturn
