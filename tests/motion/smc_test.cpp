// Requirement R-107: SMC files of the USGS and those of CWA are read as their headers say, and refused where they
// contradict themselves. The files here are made in their layouts.
#include <string>

#include "motion/record.hpp"
#include "support/expect_input_error.hpp"
#include "support/read_record.hpp"

namespace overturn {
namespace {

using testing::expect_input_error;

constexpr double gal = 0.01;

Recording read(std::string const& content, RecordRequest request = {}) {
    request.name = "a.smc";
    return read_recording(content, request);
}

std::string replaced(std::string text, std::string const& from, std::string const& to) {
    return text.replace(text.find(from), from.size(), to);
}

struct Smc {
    std::string title = "2 CORRECTED ACCELEROGRAM", component = "270";
    int vertical = 90, azimuth = 270, comments = 1, samples = 10, layout = -32768;
    double rate = 200, high = 4.0909, low = -5.8486;
    std::string data =
        "-5.8486E+0-3.0157E+0-4.4924E+0 1.8382E+0 2.8186E+0 2.8317E+0 4.0909E+0 9.4531E-1\r\n"
        "-1.8449E-1-2.6224E-1\r\n";

    [[nodiscard]] std::string text() const {
        std::string all = title + "\r\n*\r\nSAF0C\r\n     1989  10  18    0004 Somewhere\r\nMoment Mag=\r\n"
                          + "station = A hill, F   component=    " + component + "\r\n*\r\n*\r\n*\r\n*\r\n*\r\n";
        for (int i = 1; i <= 48; ++i) {
            int const value = i == 13   ? vertical
                              : i == 14 ? azimuth
                              : i == 16 ? comments
                              : i == 17 ? samples
                              : i == 47 ? layout
                                        : -32768;
            all += fmt::format("{:10}{}", value, i % 8 == 0 ? "\r\n" : "");
        }
        for (int i = 1; i <= 50; ++i) {
            double const value = i == 2 ? rate : i == 30 ? high : i == 32 ? low : 1.7e38;
            all += fmt::format("{:15.7E}{}", value, i % 5 == 0 ? "\r\n" : "");
        }
        for (int i = 0; i < comments; ++i) {
            all += "| a remark\r\n";
        }
        return all + data;
    }
};

TEST(Smc, HeadersSayEverything) {
    auto const recording = read(Smc().text());
    ASSERT_EQ(recording.components.size(), 1U);
    EXPECT_EQ(recording.format, "smc");
    EXPECT_EQ(recording.time_step_s, 0.005);
    EXPECT_EQ(recording.components[0].name, "270");
    EXPECT_EQ(recording.components[0].direction, Direction::horizontal);
    EXPECT_EQ(recording.components[0].acceleration_mps2,
              (std::vector{-5.8486 * gal, -3.0157 * gal, -4.4924 * gal, 1.8382 * gal, 2.8186 * gal, 2.8317 * gal,
                           4.0909 * gal, 0.94531 * gal, -0.18449 * gal, -0.26224 * gal}));
}

TEST(Smc, OtherLayoutsAreThoseOfTheReport) {
    Smc wide;
    wide.layout = 8;
    wide.samples = 2;
    wide.data = " -5.848600E+00  4.090900E+00\r\n";
    EXPECT_EQ(read(wide.text()).components[0].acceleration_mps2, (std::vector{-5.8486 * gal, 4.0909 * gal}));
    Smc unknown;
    unknown.title = "UNKNOWN";
    EXPECT_EQ(read(unknown.text()).format, "smc");
    Smc up;
    up.vertical = 0;
    EXPECT_EQ(read(up.text()).components[0].direction, Direction::up);
    up.vertical = 180;
    EXPECT_EQ(read(up.text()).components[0].direction, Direction::down);
    Smc none;
    none.vertical = -32768;
    none.component = "V";
    EXPECT_EQ(read(none.text()).components[0].name, "V");
}

TEST(Smc, ContradictionsAreRefused) {
    auto const refuse = [](Smc const& file, char const* part) {
        expect_input_error([&] { (void)read(file.text()); }, "a.smc:", part);
    };
    Smc cut;
    cut.samples = 11;
    refuse(cut, "value 11 of 11");
    Smc peak;
    peak.low = -6.8;
    refuse(peak, "where the header says 6.8");
    Smc rate;
    rate.rate = 0;
    refuse(rate, "samples a second");
    Smc velocity;
    velocity.title = "3 VELOCITY";
    refuse(velocity, "a velocity file");
    Smc comments;
    expect_input_error([&] { (void)read(replaced(comments.text(), "| a remark", "a remark")); }, "beginning with |");
    expect_input_error([&] { (void)read(comments.text(), {.unit_mps2 = 1}); }, "unit gal in the file, m/s2 stated");
    expect_input_error([&] { (void)read(comments.text(), {.time_step_s = 0.01}); }, "contradict");
}

std::string const cwa =
    "#Earthquake Information\r\n#Magnitude(Ml): 6.0\r\n\r\n#StationCode: EGF\r\n#RecordLength(sec): 0.08\r\n"
    "#SampleRate(Hz): 50\r\n#AmplitudeUnit:  gal. DCoffset(corr)\r\n#AmplitudeMAX. U:    6.999~   -7.118\r\n"
    "#AmplitudeMAX. N:    3.828~   -4.546\r\n#DataSequence: Time U(+); N(+); E(+)\r\n#Data: 4F10.3 \r\n"
    "     0.000     6.999     3.828     0.100\r\n     0.020    -7.118    -4.546     0.200\r\n"
    "     0.040     0.000     0.000     0.300\r\n     0.060     0.000     0.000    -0.400\r\n";

TEST(Cwa, ComponentsAreThoseOfTheHeader) {
    auto const placed = read_placed(cwa, {.name = "a.dat"});
    EXPECT_EQ(placed.says, "N, transverse E, vertical U");
    EXPECT_EQ(placed.read_as(), "cwa, N, E, U, gal, 0.02 s, 4 samples, 0.06 s");
    EXPECT_EQ(placed.motion.horizontal_mps2, (std::vector{3.828 * gal, -4.546 * gal, 0.0, 0.0}));
    EXPECT_EQ(placed.motion.transverse_mps2[3], -0.4 * gal);
    EXPECT_EQ(placed.motion.vertical_mps2[1], -7.118 * gal);
}

TEST(Cwa, ContradictionsAreRefused) {
    auto const refuse = [](char const* from, char const* to, char const* part) {
        expect_input_error([&] { (void)read(replaced(cwa, from, to)); }, "a.smc:", part);
    };
    refuse("gal.", "count", "files are in gal");
    refuse("(Hz): 50", "(Hz): 100", "a row is lost");
    refuse("(Hz): 50", "(Hz): 0", "above 0");
    refuse("(sec): 0.08", "(sec): 120", "0.08 s where the header promises 120 s");
    refuse("-7.118\r\n", "-9.118\r\n", "where the header says 9.118");
    refuse("U(+); N", "U(-); N", "with (+)");
    refuse("4F10.3", "3F10.3", "four numbers");
    refuse("     0.020", "     0.030", "a row is lost");
    refuse("    -4.546     0.200", "    -4.546      x.00", "not a finite number");
}

}  // namespace
}  // namespace overturn
