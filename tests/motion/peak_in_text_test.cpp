// Requirement R-107: counts and peaks that the text of a record states are held against its numbers.
#include <string>

#include "core/units.hpp"
#include "support/expect_input_error.hpp"
#include "support/read_record.hpp"

namespace overturn {
namespace {

using testing::expect_input_error;

constexpr double gal = 0.01;

// counts and peaks that the text states are held against the numbers.
TEST(TextStatements, CountsAndPeaksAreChecked) {
    auto const text = [](std::string const& line) {
        return line + "\nacceleration in gal, dt = 0.01 s\n1\n-2\n300\n4\n";
    };
    for (char const* line : {"npts: 4",
                             "NUMBER OF DATA : 4",
                             "4 samples, 100 sps",
                             "No. of points = 4",
                             "PGA (gal): 300",
                             "Peak value: 300.0",
                             "PGA = 0.31 g",
                             "PGA 299 gal",
                             "raw PGA = 250 gal",
                             "peak response: 500 gal",
                             "PGA (gal) : (N-S) 300.0 (E-W) 10",
                             "PGA (gal) : (N-S) 10 (E-W) 300.0 (U-D) 20",
                             "PGA: NS 10 gal, EW -300 gal",
                             "PGA 0.83 g before scaling",
                             "PGA 300 gal, M=6.9",
                             "Peak horizontal acceleration 300 gal",
                             "PGA 300 gal, Vs30: 400",
                             "Sustained maximum acceleration (SMA): 0.1 g",
                             "peak-to-peak: 302 gal",
                             "PGA about 0.25 g",
                             "100 samples per second"}) {
        EXPECT_NO_THROW((void)testing::read_record(text(line), {.name = "a"})) << line;
    }
    for (char const* line : {"npts: 5", "NUMBER OF DATA : 3", "40 samples, 100 sps"}) {
        expect_input_error([&] { (void)testing::read_record(text(line), {.name = "a"}); }, "a:1: ", "samples stated");
    }
    for (char const* line : {"PGA (gal): 3.0", "PGA (m/s2): 300", "peak acceleration: 0.30591"}) {
        expect_input_error([&] { (void)testing::read_record(text(line), {.name = "a"}); }, "a:1: ", "a wrong unit");
    }
    for (char const* line :
         {"PGA = 250 gal", "PGA = 0.35 g", "PEAK VALUE: 18.67", "peak acceleration of 6.0 m/s2",
          "RAW PGA VALUES (m/s2)    : (N-S) 13.2 (E-W) 12.1", "PGA 0.9 g", "Peak horizontal acceleration 0.5 g",
          "maximum absolute acceleration 500 gal", "PHA = 0.5 g", "largest value 500 gal", "peak amplitude 0.5 g"}) {
        expect_input_error([&] { (void)testing::read_record(text(line), {.name = "a"}); },
                           "a:1: ", "they contradict each other");
    }
    // Campaigns of before read them so.
    EXPECT_NO_THROW((void)testing::read_record(text("PGA = 250 gal"), {.name = "a", .by_place = true}));
    // Of a column that is left out the peak may be.
    EXPECT_NO_THROW((void)testing::read_record("# PGA = 5 gal\n0,1,2\n0.01,-3,5\n0.02,2,-1\n",
                                               {.name = "a", .unit_mps2 = gal, .columns = "time,h1,-"}));
}

}  // namespace
}  // namespace overturn
