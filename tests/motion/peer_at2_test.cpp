// Requirement R-107: PEER AT2 files are read in all their variants, and damaged or mistaken ones are refused by file
// and line.
#include <string>

#include "core/units.hpp"
#include "motion/record.hpp"
#include "support/expect_input_error.hpp"
#include "support/read_record.hpp"

namespace overturn {
namespace {

using testing::expect_input_error;

std::string at2(std::string const& size_line, std::string const& data,
                std::string const& quantity = "ACCELERATION TIME SERIES IN UNITS OF G") {
    return "PEER NGA STRONG MOTION DATABASE RECORD\nSomewhere, 1/16/1995, A-B, 090\n" + quantity + "\n" + size_line
           + "\n" + data;
}

std::string const six = "  .1000000E-01  -.2000000E-01   .3000000E-01   .0000000E+00  -.5000000E-01\n   .4000000E-01\n";

GroundMotion read(std::string const& content, RecordRequest request = {}) {
    request.name = "a.AT2";
    return testing::read_record(content, request);
}

void expect_six(GroundMotion const& motion, double step = 0.02) {
    EXPECT_EQ(motion.time_step_s, step);
    EXPECT_EQ(motion.horizontal_mps2, (std::vector{0.01 * g0, -0.02 * g0, 0.03 * g0, 0.0, -0.05 * g0, 0.04 * g0}));
    EXPECT_TRUE(motion.vertical_mps2.empty());
}

class SizeLine : public ::testing::TestWithParam<char const*> {};

TEST_P(SizeLine, IsUnderstood) { expect_six(read(at2(GetParam(), six))); }

INSTANTIATE_TEST_SUITE_P(Variants, SizeLine,
                         ::testing::Values("NPTS=      6, DT=   .0200 SEC,                   ",
                                           "NPTS=   6, DT=   .0200 SEC", "NPTS =   6 , DT =   .020 SEC ,      ",
                                           "NPTS=  6, DT=   0.020 SEC", "NPTS=  6, DT= .02000 SEC",
                                           "NPTS=   6, dt=  .02000", "NPTS=6,DT=.02SEC", "6 0.0200 NPTS, DT",
                                           "     6    0.0200    NPTS, DT", "npts = 6, dt = 2.D-2"));

// a step in another unit than seconds is read in it, and one in no time is refused.
TEST(PeerAt2, TheStepHasItsUnit) {
    for (char const* size : {"NPTS= 6, DT= 20.0 MSEC", "NPTS= 6, DT= 20 ms", "NPTS= 6, DT= .0200 SEC, MSEC",
                             "NPTS= 6, DT= .02 S", "NPTS= 6, DT=.0200SEC", "NPTS= 6, DT= 20.0MSEC"}) {
        expect_six(read(at2(size, six)));
    }
    for (char const* size : {"NPTS= 6, DT= 50 HZ", "NPTS= 6, DT= 1 MIN"}) {
        expect_input_error([&] { (void)read(at2(size, six)); }, "a.AT2:4: no time step in 'npts=");
    }
}

TEST(PeerAt2, LineEndsMarksAndBlanksChangeNothing) {
    auto const lf = at2("NPTS=  6, DT= .02000 SEC", six);
    auto const with_ends = [&](std::string const& end) {
        std::string text;
        for (char const c : lf) {
            text += c == '\n' ? end : std::string(1, c);
        }
        return text;
    };
    for (std::string const end : {"\r\n", "\r\r\n", "\r", "        \n"}) {
        expect_six(read(with_ends(end)));
    }
    expect_six(read("\xEF\xBB\xBF" + lf));
    expect_six(read(lf.substr(0, lf.size() - 1)));
    expect_six(read("\x93\x8C\x8B\x9E\n" + lf));  // a Shift_JIS title
}

TEST(PeerAt2, ProseHeaderAndTrailer) {
    expect_six(
        read("Data of 1940 (a version of 1559 points at 0.02 sec)\nPoints are listed in the format of 8F10.5\n"
             "a row with 5 decimal places\nThe units are (g)\n*** Begin data ***\nNPTS=  6, DT= .02000 SEC\n"
             + six + "*** End Data ***\n\n1 2 3 after the end\n"));
}

TEST(PeerAt2, FiltersNamedBesideTheUnit) {
    expect_six(read(at2("NPTS=  6, DT= .02000 SEC", six,
                        "ACCELERATION TIME HISTORY IN UNITS OF G. FILTER POINTS: HP=0.2 Hz LP=12.5 Hz")));
}

TEST(PeerAt2, GluedNumbers) {
    expect_six(read(at2("NPTS=  6, DT= .02000 SEC", "1.0000000E-02-2.0000000E-02 3.0000000E-02+0.\n-.5D-01 .4E-1\n")));
}

TEST(PeerAt2, VelocityAndDisplacementAreRefused) {
    for (char const* quantity : {"VELOCITY TIME SERIES IN UNITS OF CM/S", "DISPLACEMENT TIME SERIES IN UNITS OF CM"}) {
        expect_input_error([&] { (void)read(at2("NPTS= 6, DT= .02 SEC", six, quantity)); },
                           "a.AT2:3: ", "an acceleration is needed");
    }
}

TEST(PeerAt2, AnotherEventsHeaderIsRefused) {
    expect_input_error([] { (void)read(at2("NPTS= 10102, DT= .02 SEC", six)); },
                       "a.AT2:6: ", "6 values where NPTS promises 10102");
    expect_input_error([] { (void)read(at2("NPTS= 6, DT= .02 SEC", "1 2 818. 3 4 5\n")); },
                       "a.AT2:4: ", "peak of 818 g");
}

TEST(PeerAt2, MoreValuesThanPromisedAreRefused) {
    expect_input_error([] { (void)read(at2("NPTS= 5, DT= .02 SEC", six)); }, "6 values where NPTS promises 5");
}

// count and step above the names of columns make no AT2.
TEST(PeerAt2, NamesBelowItsCountMakeATable) {
    std::string const rows = "0,10\n0.01,-20\n0.02,30\n0.03,-5\n";
    for (char const* head :
         {"# NPTS= 4, DT= 0.01 SEC\ntime [s],acc [gal]\n", "# NPTS= 4, DT= 0.01 SEC\n# time [s],acc [gal]\n",
          "NPTS= 4, DT= 0.01 SEC\n\"time [s]\",\"acc [gal]\"\n"}) {
        auto const recording = read_recording(head + rows, {.name = "a.csv"});
        EXPECT_EQ(recording.format, "columns") << head;
        EXPECT_EQ(recording.components[0].acceleration_mps2, (std::vector{0.1, -0.2, 0.3, -0.05})) << head;
    }
    expect_input_error([&] { (void)read("# NPTS= 5, DT= 0.01 SEC\ntime [s],acc [gal]\n" + rows); }, "5 samples stated");
    expect_input_error([&] { (void)read("# NPTS= 4, DT= 0.02 SEC\ntime [s],acc [gal]\n" + rows); }, "time step 0.02 s");
}

TEST(PeerAt2, DamagedHeadersAreRefused) {
    for (char const* step : {"0", "-.02", "nan", "inf", "", "0.0E0"}) {
        expect_input_error([&] { (void)read(at2("NPTS= 6, DT= " + std::string(step) + " SEC", six)); },
                           "a.AT2:4: ", "no time step");
    }
    for (char const* count : {"0", "-6", "6.5", "x"}) {
        expect_input_error([&] { (void)read(at2("NPTS= " + std::string(count) + ", DT= .02", six)); },
                           "a.AT2:4: ", "no count of values");
    }
    expect_input_error([] { (void)read(at2("nothing", six), {.format = "peer-at2"}); }, "no line with NPTS and DT");
}

TEST(PeerAt2, DamagedDataAreRefusedWithTheirLine) {
    for (char const* bad : {"nan", "inf", "-Inf", "***************", "1.0E", "abc"}) {
        expect_input_error([&] { (void)read(at2("NPTS= 7, DT= .02 SEC", six + bad + "\n")); },
                           "a.AT2:7: ", "not a finite number");
    }
    expect_input_error([] { (void)read(at2("NPTS= 6, DT= .02 SEC", six.substr(0, 40))); }, "a.AT2:5: ", "cut short");
    expect_input_error([] { (void)read(at2("NPTS= 6, DT= .02 SEC", six.substr(0, six.size() - 3))); },
                       "a.AT2:6: ", "'.4000000E-'");
    expect_input_error([] { (void)read(at2("NPTS= 6, DT= .02 SEC", six.substr(0, six.size() - 2))); },
                       "a.AT2:6: ", "'.4000000E-0' at the end", "cut short");
    expect_input_error([] { (void)read(at2("NPTS= 6, DT= .02 SEC", "")); }, "a.AT2:4: ", "0 values");
}

TEST(PeerAt2, UnitMustBeGAndMustNotBeContradicted) {
    auto const plain = at2("NPTS= 6, DT= .02 SEC", six, "CORRECTED");
    expect_input_error([&] { (void)read(plain); }, "unit missing", "State --unit gal|g|m/s2");
    expect_six(read(plain, {.unit_mps2 = g0}));

    auto const in_g = at2("NPTS= 6, DT= .02 SEC", six);
    expect_six(read(in_g, {.unit_mps2 = unit_factor("g", Dimension::acceleration)}));
    expect_input_error([&] { (void)read(in_g, {.unit_mps2 = 0.01}); }, "a.AT2:4: ", "contradict");
    expect_input_error([&] { (void)read(in_g, {.time_step_s = 0.01}); }, "a.AT2:4: ", "contradict");
    expect_input_error([] { (void)read(at2("NPTS= 6, DT= .02", six, "ACCELERATION IN UNITS OF CM/S2")); },
                       "a.AT2:3: ", "'cm/s2'");
}

}  // namespace
}  // namespace overturn
