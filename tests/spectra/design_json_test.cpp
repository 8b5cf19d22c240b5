// Requirement R-104: a design spectrum in the JSON of the USGS is that of the part that is named, in g; nothing is
// guessed where there are several, or no document says the unit.
#include "spectra/detail/design_json.hpp"

#include <string>

#include <gtest/gtest.h>

#include "support/expect_input_error.hpp"

namespace overturn {
namespace {

using testing::expect_input_error;

std::string const two = R"({"request": {"referenceDocument": "ASCE7-22"}, "response": {"data": {"pgam": 0.5,
"multiPeriodDesignSpectrum": {"periods": [0.0, 0.1, 1], "ordinates": [0.35, 0.8, 0.4]},
"twoPeriodDesignSpectrum": {"periods": [0.0, 1], "ordinates": [0.3, 0.5]}}}})";
std::string const pairs = R"({"request": {"url": "https://earthquake.usgs.gov/ws/designmaps/asce7-16.json"},
"response": {"data": {"ss": 1.5, "sdSpectrum": [[0, 0.4], [0.2, 1.0], [1, 0.6]]}}})";

TEST(DesignJson, APartIsTakenByItsName) {
    EXPECT_EQ(table_of_design_json(two, "d.json", "multiPeriodDesignSpectrum"),
              "T (s),Sa (g)\n0,0.35\n0.1,0.8\n1,0.4\n");
    EXPECT_EQ(table_of_design_json(two, "d.json", "twoPeriodDesignSpectrum"), "T (s),Sa (g)\n0,0.3\n1,0.5\n");
    EXPECT_EQ(table_of_design_json(pairs, "d.json", ""), "T (s),Sa (g)\n0,0.4\n0.2,1\n1,0.6\n");
}

// R-104: without a document of the USGS the unit is asked for by whoever reads the table.
TEST(DesignJson, NoUnitIsGuessed) {
    EXPECT_EQ(table_of_design_json(R"({"spectrum": [[0.1, 2], [1, 1]]})", "d.json", ""), "T (s),Sa\n0.1,2\n1,1\n");
}

// R-104: units and damping that stand anywhere in it are text of the table, for its reader to hold against the rest.
TEST(DesignJson, UnitsAndDampingArePassedOn) {
    EXPECT_EQ(table_of_design_json(R"({"units": "cm/s2", "damping": 0.02, "lengthUnits": "deg",
"spectrum": [[0.1, 2], [1, 1]]})",
                                   "d.json", ""),
              "# units: cm/s2\n# damping 0.02\nT (s),Sa\n0.1,2\n1,1\n");
    EXPECT_EQ(
        table_of_design_json(R"({"meta": {"dampingRatio": "5 %"}, "spectrum": [[0.1, 2], [1, 1]]})", "d.json", ""),
        "# damping 5 %\nT (s),Sa\n0.1,2\n1,1\n");
}

// R-104: several spectra, none, another name, a file that is cut.
TEST(DesignJson, WhatIsNotCertainIsRefused) {
    auto const refuse = [](std::string const& text, std::string const& part, std::string const& why) {
        expect_input_error([&] { (void)table_of_design_json(text, "d.json", part); }, "d.json: ", why);
    };
    refuse(two, "", "2 spectra: multiPeriodDesignSpectrum, twoPeriodDesignSpectrum (which is meant?)");
    refuse(two, "mce", "'mce' is not one of them");
    refuse(two.substr(0, two.size() - 9), "", "cut short?");
    refuse(R"({"response": {"data": {"pgam": 0.5}}})", "", "without a spectrum");
    refuse(R"({"a": {"periods": [1, 2], "ordinates": [1]}})", "", "without a spectrum");
    refuse(R"({"a": {"periods": [1, "x"], "ordinates": [1, 2]}})", "", "without a spectrum");
    EXPECT_TRUE(is_json("\xEF\xBB\xBF {"));
    EXPECT_FALSE(is_json("T,Sa\n{"));
}

}  // namespace
}  // namespace overturn
