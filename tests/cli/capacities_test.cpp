// Requirement R-711: `fit --capacities` takes a row per wave, with ties and with those not reached, and refuses what it
// cannot read where it stands.
#include <cmath>
#include <string>

#include <nlohmann/json.hpp>

#include "cli/campaign_files.hpp"
#include "support/command.hpp"

namespace overturn::testing {
namespace {

using nlohmann::json;

// The example of Baker (2015), Earthquake Spectra 31(1), tried up to 1.3.
std::string const published =
    "IM "
    "[g]\n0.49\n0.62\n0.63\n0.63\n0.65\n0.70\n0.71\n0.72\n0.77\n0.79\n0.80\n0.84\n0.91\n0.92\n0.93\n0.97\n1.04\n1.04\n"
    "1.05\n1.08\n1.08\n1.09\n1.12\n1.13\n1.22\n>1.3\n>1.3\n>1.3\n>1.3\n>1.3\n>1.3\n>1.3\n>1.3\n>1.3\n>1.3\n>1.3\n>1."
    "3\n";

class Capacities : public ::testing::Test {
  protected:
    void refuse(std::string const& text, std::string const& part) {
        folder.write("c.csv", text);
        auto const ended = overturn(folder, {"fit", "--capacities", "c.csv"});
        EXPECT_EQ(ended.code, 2) << text;
        EXPECT_TRUE(is_one_error_line(ended.err)) << ended.err;
        EXPECT_NE(ended.err.find(part), std::string::npos) << ended.err;
    }
    Folder folder;
};

TEST_F(Capacities, OfThePublishedExample) {
    folder.write("c.csv", published);
    auto const ended = overturn(folder, {"fit", "--capacities", "c.csv", "--json"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    auto const answer = json::parse(ended.out);
    EXPECT_NEAR(answer["fragility"][0]["median"].get<double>(), 1.0582, 5e-5);
    EXPECT_NEAR(answer["fragility"][0]["beta"].get<double>(), 0.3821, 5e-5);
    EXPECT_EQ(answer["capacities"]["count"], 37);
    EXPECT_EQ(answer["capacities"]["not_reached"], 12);
    EXPECT_TRUE(answer["capacities"]["moments_median"].is_null());
}

TEST_F(Capacities, AColumnOfVerdictsGivesTheSame) {
    folder.write("c.csv", "record;collapsed;pga [g]\nA;1;0.7\nB;1;0.9\nC;0;1.3\nD;1;1.1\n");
    auto const by_column = overturn(folder, {"fit", "--capacities", "c.csv", "--json"});
    for (auto const* measure :
         {"cav [m/s]", "standardised_cav [m/s]", "sa-average [g]", "vector-pga [g]", "pgd [cm]"}) {
        folder.write("c.csv", std::string(measure) + "\n0.7\n0.9\n>1.3\n1.1\n");
        EXPECT_EQ(overturn(folder, {"fit", "--capacities", "c.csv"}).code, 0) << measure << " is one of the registry";
    }
    folder.write("c.csv", "pga [g]\n0.7\n0.9\n>1.3\n1.1\n");
    auto const by_sign = overturn(folder, {"fit", "--capacities", "c.csv", "--json"});
    EXPECT_EQ(by_column.code, 0) << by_column.err;
    EXPECT_EQ(by_column.out, by_sign.out);
}

// Under the names of others; of those that a program writes as Inf it is not known up to where they stood.
TEST_F(Capacities, UnderTheirUsualNames) {
    folder.write("c.csv", "pga [g]\n0.7\n0.9\n>1.3\n1.1\n");
    auto const plain = json::parse(overturn(folder, {"fit", "--capacities", "c.csv", "--json"}).out);
    for (char const* text :
         {"No.,Sa_g\n1,0.7\n2,0.9\n3,>1.3\n4,1.1\n", "record;collapse capacity (g)\nA;0.7\nB;0.9\nC;>1.3\nD;1.1\n",
          "IDA of Smith\nGM  IM_collapse [g]\nA 0.7\nB 0.9\nC >1.3\nD 1.1\n"}) {
        folder.write("c.csv", text);
        auto const ended = overturn(folder, {"fit", "--capacities", "c.csv", "--json"});
        ASSERT_EQ(ended.code, 0) << text << ended.err;
        EXPECT_EQ(json::parse(ended.out)["fragility"][0]["median"], plain["fragility"][0]["median"]) << text;
    }
    for (char const* cell : {"Inf", "NaN", "-"}) {
        refuse(std::string("pga [g]\n0.7\n") + cell + "\n0.9\n",
               "c.csv:3:1: '" + std::string(cell) + "' (it stood: up to which");
    }
    refuse("pga [g]\n0,7\n0,9\n", "decimal comma");
}

// fewer than five hold no curve; of nine the interval of the median is Student's where that is the longest.
TEST_F(Capacities, FewGiveNoCurveOrWideIntervals) {
    auto const fit = [&](std::string const& rows) {
        folder.write("few.csv", "pga [g], collapsed\n" + rows);
        auto const ended = overturn(folder, {"fit", "--capacities", "few.csv", "--beta-u", "0.3", "--json"});
        EXPECT_EQ(json::parse(ended.out)["capacities"]["moments_median"].is_null(), std::ranges::count(rows, '\n') < 5);
        EXPECT_EQ(ended.code, 0) << ended.err;
        return json::parse(ended.out)["fragility"][0];
    };
    auto const four = fit("0.8,1\n1.0,1\n1.1,1\n1.4,1\n");
    EXPECT_EQ(four["state"], "few-waves");
    EXPECT_TRUE(four["median"].is_null()) << four;
    EXPECT_TRUE(four["hclpf"].is_null()) << four;
    auto const nine = fit("0.5,1\n0.6,1\n0.7,1\n0.8,1\n0.9,1\n1.0,1\n1.2,1\n1.4,1\n1.8,1\n");
    EXPECT_EQ(nine["interval_method"], "widest");
    double const deviation = nine["beta"].get<double>() * std::sqrt(9.0 / 8);
    double const half = 2.3060041 * deviation / 3;  // Student's t of 8 degrees of freedom, 97.5 %
    EXPECT_LE(nine["median_upper"].get<double>() / nine["median"].get<double>(), std::exp(half) * 1.05);
    EXPECT_GE(nine["median_upper"].get<double>() / nine["median"].get<double>(), std::exp(half) * (1 - 1e-6));
    EXPECT_LE(nine["median_lower"].get<double>() / nine["median"].get<double>(), std::exp(-half) * (1 + 1e-6));
}

TEST_F(Capacities, ThatAreEqualHaveNoSpread) {
    folder.write("equal.csv", "pga [g]\n0.3\n0.3\n0.3\n0.3\n0.3\n0.3\n0.3\n");
    auto const text = overturn(folder, {"fit", "--capacities", "equal.csv"}).out;
    EXPECT_NE(text.find("  moments: all capacities equal 0.3 g: no spread\n"), std::string::npos) << text;
    EXPECT_EQ(text.find("e-1"), std::string::npos) << text;
}

TEST_F(Capacities, GiveAnAnnualFrequency) {
    folder.write("c.csv", published);
    folder.write("h.csv", "IM [g], annual_exceedance\n0.1,2e-3\n0.3,1e-4\n0.5,2.5e-5\n1.0,3e-6\n2.0,3e-7\n");
    auto const ended = overturn(folder, {"fit", "--capacities", "c.csv", "--hazard", "h.csv", "--json"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    auto const row = json::parse(ended.out)["frequency"][0];
    EXPECT_LT(row["frequency_lower_per_year"], row["mean_per_year"]);
    EXPECT_TRUE(row["frequency_upper_per_year"].is_null()) << "beta_U is not known";
}

TEST_F(Capacities, WhatCannotBeReadIsRefusedWhereItStands) {
    refuse("pga [g]\n0.7\nx\n", "c.csv:3:1: 'x' (not a number)");
    refuse("pga [g]\n0.7\n-1\n", "must be above 0");
    refuse("pga [g],collapsed\n0.7,2\n", "must be 1 or 0");
    refuse("pga [g],collapsed\n>0.7,1\n", "marked as overturned");
    refuse("pga [g],drift\n0.7,2\n", "'drift' (unknown)");
    refuse("collapsed\n1\n", "no column of intensities");
    refuse("pga [g]\n", "no capacity");
}

// each row counts as a sample, which two components of one recording are not.
TEST_F(Capacities, TwoRowsOfOneRecordingAreRefused) {
    refuse("record,pga [g]\nA,0.7\nq_NS,0.8\nB,1.1\nq_EW,0.9\n",
           "c.csv:5:1: 'q_EW' beside 'q_NS' in line 3 (components of one recording");
    refuse("pga [g],wave\n0.7,A\n0.8,B\n0.9,A\n", "c.csv:4:5: 'A' beside 'A' in line 2 (one wave twice");
    refuse("name,record,pga [g]\nKobe,a,0.7\nKobe,a,0.8\n", "'a' beside 'a'");
    refuse("record,name,pga [g]\na,Kobe,0.7\na,Tokachi,0.8\n", "'a' beside 'a'");
    for (char const* text : {"name,record,pga [g]\nKobe,a,0.7\nKobe,b,0.8\n",
                             "record,name,pga [g]\na,Kobe,0.7\nb,Kobe,0.8\n", "pga [g],record\n0.7,\n0.8,\n"}) {
        folder.write("c.csv", text);
        auto const ended = overturn(folder, {"fit", "--capacities", "c.csv"});
        EXPECT_EQ(ended.code, 0) << text << ended.err;
    }
}

}  // namespace
}  // namespace overturn::testing
