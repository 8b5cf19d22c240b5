// Requirement R-104: a design spectrum in the JSON of the USGS is that of the part that is named, in g; nothing is
// guessed where there are several, or no document says the unit.
#include "spectra/detail/design_json.hpp"

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

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

PairTable table_of(std::string const& text, std::string const& part = {}) {
    return table_of_design_json(text, "d.json", part, TargetKind::acceleration);
}

/// The lines of text that `members` make beside a spectrum.
std::vector<std::string> said_by(std::string const& members, TargetKind kind = TargetKind::acceleration) {
    auto const table = table_of_design_json("{" + members + R"(, "spectrum": [[0.1, 2], [1, 1]]})", "d.json", "", kind);
    std::vector<std::string> said;
    std::ranges::transform(table.text, std::back_inserter(said), &TextLine::text);
    return said;
}

using Said = std::vector<std::string>;
using Points = std::vector<Pair>;

TEST(DesignJson, APartIsTakenByItsName) {
    auto const multi = table_of(two, "multiPeriodDesignSpectrum");
    EXPECT_EQ(multi.first_name, "T (s)");
    EXPECT_EQ(multi.second_name, "Sa (g)");
    EXPECT_EQ(multi.points, (Points{{0, 0.35}, {0.1, 0.8}, {1, 0.4}}));
    EXPECT_EQ(multi.names_line, 2);
    EXPECT_EQ(table_of(two, "twoPeriodDesignSpectrum").points, (Points{{0, 0.3}, {1, 0.5}}));
    EXPECT_EQ(table_of(pairs).points, (Points{{0, 0.4}, {0.2, 1}, {1, 0.6}}));
}

// R-104: without a document of the USGS the unit is asked for by whoever reads the table.
TEST(DesignJson, NoUnitIsGuessed) {
    EXPECT_EQ(table_of(R"({"spectrum": [[0.1, 2], [1, 1]]})").second_name, "ordinates");
}

// R-104: units and damping that stand anywhere in it are text of the table, at their lines, for its reader to hold
// against the rest; those of other quantities, and dampings of soils, are not.
TEST(DesignJson, UnitsAndDampingArePassedOn) {
    EXPECT_EQ(said_by(R"("units": "cm/s2", "damping": 0.02, "lengthUnits": "deg")"),
              (Said{"units: cm/s2", "damping 0.02"}));
    EXPECT_EQ(said_by(R"("meta": {"dampingRatio": "5 %"})"), Said{"damping 5 %"});
    EXPECT_EQ(said_by(R"("displacementUnits": "cm", "soil_damping": 0.12, "units": "g")"), Said{"units: g"});
    EXPECT_EQ(said_by(R"("units": {"acceleration": "g", "displacement": "cm"})"), Said{"units: g"});
    EXPECT_EQ(said_by(R"("units": {"acceleration": "g", "displacement": "cm"})", TargetKind::displacement),
              Said{"units: cm"});
    EXPECT_EQ(said_by(R"("damping": [0.05], "zeta": 0.05, "xi": 0.05)"),
              (Said{"damping 0.05", "damping 0.05", "damping 0.05"}));
    EXPECT_EQ(said_by(R"("damping": [0.02, 0.05])"), Said{"damping [0.02,0.05]"});
    EXPECT_EQ(said_by(R"("dampingPercent": 5, "structural_damping": 0.07)"),
              (Said{"damping 5 %", "structural_damping (damping): '0.07'"}));
    auto const table = table_of("{\n\"units\": [\"ms\", \"g\"],\n\"spectrum\": [[1, 2],\n[2, 1]]}");
    EXPECT_EQ(table.first_name, "T (ms)");
    ASSERT_EQ(table.text.size(), 1U);
    EXPECT_EQ(table.text[0].number, 2);
    EXPECT_EQ(table.names_line, 3);
}

// R-104: so are components, quantities, factors and statistics; those of the ground, of the site and of maps are not.
TEST(DesignJson, WhatChangesASpectrumIsPassedOn) {
    EXPECT_EQ(said_by(R"("component": "vertical", "direction": "V", "scale": 2, "factor": 0.5, "percentile": 84)"),
              (Said{"component: vertical", "direction: V", "scale: 2", "factor: 0.5", "percentile: 84"}));
    EXPECT_EQ(said_by(R"("type": "PSV", "quantity": "velocity", "title": "Floor spectrum", "normalized": true)"),
              (Said{"type: PSV", "quantity: velocity", "title: Floor spectrum", "normalized: true"}));
    EXPECT_EQ(said_by(R"("notes": ["84th percentile", "x"], "x_axis": "frequency", "ordinatesAre": "ln", "log": true,
"uncertainty": "plus one sigma", "location": "floor 3", "scaled": true)"),
              (Said{"notes: [\"84th percentile\",\"x\"]", "x_axis: frequency", "ordinatesAre: ln", "log: true",
                    "uncertainty: plus one sigma", "location: floor 3", "scaled: true"}));
    EXPECT_EQ(
        said_by(
            R"("component": "horizontal", "url": "https://x.org/floor", "method": "fast Fourier", "scale": 1, "type": "Feature", "title": "Site A", "siteFactor": 1.2,
"pgadPercentileFactor": 1.8, "pgadFloor": 0.6, "normalized": false, "siteClass": "C", "depth": 10)"),
        Said{});
    EXPECT_EQ(table_of(R"({"h": {"periods": [1, 2], "ordinates": [2, 1], "component": "H1"},
"vertical": {"periods": [1, 2], "ordinates": [1, 1], "scale": 2}})",
                       "h")
                  .text.size(),
              0U);
    auto const vertical = table_of(R"({"verticalSpectrum": [[1, 2], [2, 1]]})").text;
    ASSERT_EQ(vertical.size(), 1U);
    EXPECT_EQ(vertical[0].text, "vertical spectrum");
}

// R-104: several spectra, none, another name, a file that is cut.
TEST(DesignJson, WhatIsNotCertainIsRefused) {
    auto const refuse = [](std::string const& text, std::string const& part, std::string const& why) {
        expect_input_error([&] { (void)table_of(text, part); }, "d.json: ", why);
    };
    refuse(two, "", "2 spectra: multiPeriodDesignSpectrum, twoPeriodDesignSpectrum (which is meant?)");
    refuse(two, "mce", "'mce' is not one of them");
    refuse(two.substr(0, two.size() - 9), "", "cut short?");
    refuse(R"({"response": {"data": {"pgam": 0.5}}})", "", "without a spectrum");
    refuse(R"({"a": {"periods": [1, 2], "ordinates": [1]}})", "", "without a spectrum");
    refuse(R"({"a": {"periods": [1, "x"], "ordinates": [1, 2]}})", "", "without a spectrum");
    refuse(R"({"units": "g", "units": "gal", "spectrum": [[1, 2], [2, 1]]})", "", "'units' twice");
    EXPECT_TRUE(is_json("\xEF\xBB\xBF {"));
    EXPECT_FALSE(is_json("T,Sa\n{"));
}

}  // namespace
}  // namespace overturn
