// Requirement: `fit` gives annual frequencies of anybody's stripes and of a stated curve, bounded where
// hazard curve or levels end; units are demanded.
#include <cmath>
#include <filesystem>
#include <sstream>

#include <nlohmann/json.hpp>

#include "cli/campaign_files.hpp"
#include "support/command.hpp"

namespace overturn::testing {
namespace {

using nlohmann::json;

class HazardOfTables : public ::testing::Test {
  protected:
    HazardOfTables() {
        folder.write("two.csv", ended);
        folder.write("eight.csv", ended + "4,3e-8\n8,3e-9\n");
        folder.write("gal.csv", "pga [gal], annual_exceedance\n0.1,1e-3\n0.3,1e-4\n1,1e-6\n");
    }
    json answer(std::vector<std::string> const& arguments) {
        auto const end = overturn(folder, joined({"fit", "--json"}, arguments));
        EXPECT_EQ(end.code, 0) << end.err;
        return json::parse(end.out);
    }
    void refuse(std::vector<std::string> const& arguments, std::string const& part) {
        auto const end = overturn(folder, joined({"fit"}, arguments));
        EXPECT_EQ(end.code, 2) << end.out;
        EXPECT_TRUE(is_one_error_line(end.err)) << end.err;
        EXPECT_NE(end.err.find(part), std::string::npos) << end.err;
    }
    void write_stripes(std::string const& name) {
        folder.write("t.csv", name + ",trials,overturned\n0.4,100,1\n0.7,100,16\n1.0,100,50\n1.5,100,88\n2.1,100,99\n");
    }

    std::string const ended =
        "pga [g], annual_exceedance\n0.05,1e-2\n0.1,2e-3\n0.3,1e-4\n0.5,2.5e-5\n1.0,3e-6\n2.0,3e-7\n";
    Folder folder;
};

TEST_F(HazardOfTables, ProlongedHazardLiesWithinTheFirstInterval) {
    write_stripes("pga [g]");
    auto const first = answer({"--stripes", "t.csv", "--beta-u", "0.2", "--hazard", "two.csv"})["frequency"][0];
    auto const second = answer({"--stripes", "t.csv", "--beta-u", "0.2", "--hazard", "eight.csv"})["frequency"][0];
    auto const of = [](json const& row, std::string const& key) { return row[key + "_per_year"].get<double>(); };
    EXPECT_LE(of(first, "frequency_lower"), of(second, "frequency_lower"));
    EXPECT_GE(of(first, "frequency_upper"), of(second, "frequency_upper"));
    EXPECT_LE(of(first, "frequency_lower"), of(second, "mean"));
    EXPECT_GE(of(first, "frequency_upper"), of(second, "mean"));
    EXPECT_DOUBLE_EQ(of(first, "above_levels_most"), 3e-7);
}

// The same numbers in gal, and against a hazard curve in another unit, are the same answer.
TEST_F(HazardOfTables, UnitsOfTableAndHazardAreTheirOwn) {
    write_stripes("pga [g]");
    auto const in_g = answer({"--stripes", "t.csv", "--beta-u", "0.2", "--hazard", "two.csv"})["frequency"][0];
    folder.write("gal.csv",
                 "pga [gal], annual_exceedance\n49.03325,1e-2\n98.0665,2e-3\n294.1995,1e-4\n490.3325,2.5e-5\n"
                 "980.665,3e-6\n1961.33,3e-7\n");
    auto const in_gal = answer({"--stripes", "t.csv", "--beta-u", "0.2", "--hazard", "gal.csv"})["frequency"][0];
    auto const upper = in_g["frequency_upper_per_year"].get<double>();
    EXPECT_NEAR(in_gal["frequency_upper_per_year"].get<double>() / upper, 1, 1e-9);
    auto const mean = in_g["mean_per_year"].get<double>();
    EXPECT_NEAR(in_gal["mean_per_year"].get<double>() / mean, 1, 1e-9);
}

TEST_F(HazardOfTables, WhatIsNotStatedIsAskedFor) {
    write_stripes("pga");
    refuse({"--stripes", "t.csv", "--hazard", "two.csv"}, "states no unit");
    write_stripes("sa [g]");
    refuse({"--stripes", "t.csv", "--hazard", "two.csv"}, "states no period (of which oscillator?)");
    write_stripes("sa(1 s) [g]");
    refuse({"--stripes", "t.csv", "--hazard", "two.csv"}, "levels are sa(1 s)");
    write_stripes("pga [g]");
    refuse({"--stripes", "t.csv", "--hazard", "gal.csv"}, "nothing in common");
    write_stripes("IM [g]");
    refuse({"--stripes", "t.csv", "--hazard", "two.csv"}, "Name the column 'pga [g]' if it is");
    folder.write("im.csv", "intensity [g], annual_exceedance\n0.1,1e-2\n1,1e-4\n3,1e-6\n");
    auto const said = overturn(folder, {"fit", "--stripes", "t.csv", "--hazard", "im.csv"});
    EXPECT_EQ(said.code, 0) << said.err;
    EXPECT_NE(said.out.find("'IM [g]' of the table names no measure"), std::string::npos) << said.out;
}

// Of a power law: Cornell (1996), k0 median^-k exp(k^2 beta^2 / 2).
TEST_F(HazardOfTables, AStatedCurveUnderAPowerLawIsTheClosedForm) {
    folder.write("law.csv", "pga [g], annual_exceedance\n0.01,1\n100,1e-12\n");  // 1e-6 a^-3
    auto const row = answer({"--median", "0.9 g", "--beta", "0.3", "--hazard", "law.csv"})["frequency"][0];
    double const closed = 1e-6 * std::pow(0.9, -3) * std::exp(9 * 0.09 / 2);
    EXPECT_NEAR(row["mean_per_year"].get<double>() / closed, 1, 1e-6);
    EXPECT_NEAR(row["frequency_lower_per_year"].get<double>() / closed, 1, 1e-6);
    EXPECT_TRUE(row["frequency_upper_per_year"].is_null()) << "beta_U is not known";
    auto const unsure = answer({"--median", "90 cm/s2", "--beta", "0.3", "--beta-u", "0.25", "--hazard", "law.csv"});
    EXPECT_NEAR(unsure["stated_curve"]["hclpf"].get<double>() / (90 * std::exp(-1.645 * 0.55)), 1, 1e-12);
    double const fractile = 1e-6 * std::pow(0.9 / 9.80665, -3) * std::exp(9 * 0.09 / 2);
    EXPECT_NEAR(unsure["frequency"][0]["fractile_50_per_year"].get<double>() / fractile, 1, 1e-6);
    double const mean = 1e-6 * std::pow(0.9 / 9.80665, -3) * std::exp(9 * (0.09 + 0.0625) / 2);
    EXPECT_NEAR(unsure["frequency"][0]["frequency_upper_per_year"].get<double>() / mean, 1, 1e-6);
}

TEST_F(HazardOfTables, AStatedCurveStatesItsUnit) {
    refuse({"--median", "0.9", "--beta", "0.3"}, "no unit");
    refuse({"--median", "0.9 s", "--beta", "0.3"}, "no unit");
    refuse({"--median", "0.9 g"}, "--median without --beta");
    refuse({"--beta", "0.3"}, "nothing to fit");
    refuse({"--median", "0.9 g", "--beta", "0"}, "must be above 0");
    refuse({"--median", "0.9 g", "--beta", "0.3", "--hazard", "gal.csv"}, "nothing in common");
    refuse({"--median", "90 cm/s", "--beta", "0.3", "--hazard", "two.csv"}, "states no unit of velocity");
    auto const said = overturn(folder, {"fit", "--median", "0.9 g", "--beta", "0.3"});
    EXPECT_NE(said.out.find("5 % point 0.5494 g"), std::string::npos) << said.out;
}

// what is hardly meant is a line wherever the number stands, a slip is refused.
TEST_F(HazardOfTables, WhatIsHardlyMeantIsALine) {
    refuse({"--median", "0.9 g", "--beta", "30"}, "--beta: 30 (more than 5");
    refuse({"--median", "0.9 g", "--beta", "0.4", "--beta-u", "30"}, "--beta-u: 30 (more than 5");
    auto const far = overturn(folder, {"fit", "--median", "90 g", "--beta", "0.4"});
    EXPECT_NE(far.out.find("note: median 90 g (the strongest records stay below 5 g"), std::string::npos) << far.out;
    write_stripes("pga [g]");
    refuse({"--stripes", "t.csv", "--beta-u", "30"}, "--beta-u: 30 (more than 5");
    auto const wide = std::string("note: beta_U 3 divides HCLPF by 139");
    for (auto const& curve : {std::vector<std::string>{"--median", "0.9 g", "--beta", "0.4"}, {"--stripes", "t.csv"}}) {
        EXPECT_NE(overturn(folder, joined({"fit", "--beta-u", "3"}, curve)).out.find(wide), std::string::npos);
        EXPECT_EQ(overturn(folder, joined({"fit", "--beta-u", "0.3"}, curve)).out.find("divides"), std::string::npos);
    }
    folder.write("often.csv", "pga [g], annual_exceedance\n0.1,1000\n0.5,1e-3\n2,1e-6\n");
    auto const often = overturn(folder, {"fit", "--stripes", "t.csv", "--hazard", "often.csv"}).out;
    EXPECT_NE(often.find("note: hazard curve: it begins at 1e+03 exceedances a year"), std::string::npos) << often;
    EXPECT_EQ(answer({"--stripes", "t.csv", "--hazard", "often.csv"})["hazard_notes"].size(), 1U);
    EXPECT_EQ(answer({"--stripes", "t.csv", "--hazard", "two.csv"})["hazard_notes"].size(), 0U);
}

// a campaign states its own hazard curve; fit and report take another one in its place.
TEST(HazardOfCampaign, AnswersAnnualFrequencies) {
    Folder const folder;
    std::string const curve = "pga [g], annual_exceedance\n0.05,1e-2\n0.5,2.5e-5\n2.0,3e-7\n";
    folder.write("hz.csv", curve);
    folder.write("rarer.csv", "pga [g], annual_exceedance\n0.05,1e-3\n0.5,2.5e-6\n2.0,3e-8\n");
    folder.write("pgv.csv", "pgv [m/s], annual_exceedance\n0.05,1e-3\n0.5,2.5e-6\n");
    folder.write("target.csv", target_csv);
    auto campaign = small_campaign("shared", 24);
    campaign.replace(campaign.find("'1200 gal'"), 10, "'800 gal','1200 gal','1500 gal'");
    std::string const scatter = "restitution={distribution='lognormal',median=0.85,beta=0.1}\n";
    campaign.erase(campaign.find(scatter), scatter.size());
    campaign.insert(campaign.find("[levels]"),
                    "[[bodies]]\nname='a third body, with a name wider than its column'\nmass='12.6 t'\n"
                    "base_width='0.8 m'\ncentre_height='1.045 m'\ninertia='uniform-block'\n");
    folder.write("c.toml", "hazard='hz.csv'\n" + campaign);
    auto const ran = overturn(folder, {"run", "c.toml"});
    ASSERT_EQ(ran.code, 0) << ran.err;
    auto const fitted = overturn(folder, {"fit", "c.h5"}).out;
    EXPECT_EQ(ran.out, fitted + "results: c.h5\n");
    std::filesystem::remove(folder / "hz.csv");
    EXPECT_EQ(overturn(folder, {"fit", "c.h5"}).out, fitted) << "the file holds the curve";
    auto const frequencies = fitted.substr(fitted.find("annual frequency [1/a]"));
    std::istringstream lines(fitted);
    for (std::string line; std::getline(lines, line);) {
        EXPECT_LE(line.size(), 100U) << line;
    }
    // Without beta_U a curve gives no upper end; what the stripes alone give stands apart.
    EXPECT_NE(frequencies.find("\ntype-b                               > "), std::string::npos) << frequencies;
    EXPECT_NE(frequencies.find("no upper end, because beta_U is not known (--beta-u, or"), std::string::npos)
        << frequencies;
    EXPECT_NE(overturn(folder, {"fit", "c.h5", "--beta-u", "0.3"}).out.find("at 5, 50, 95 % confidence: "),
              std::string::npos);
    auto const mean = [&](std::vector<std::string> const& more) {
        auto const json = json::parse(overturn(folder, joined({"fit", "c.h5", "--json"}, more)).out);
        return json.at("frequency").at(1).at("mean_per_year").get<double>();
    };
    EXPECT_NEAR(mean({}) / mean({"--hazard", "rarer.csv"}), 10, 1e-6) << "exceedances of a tenth";

    // It moves no trial: another curve keeps all of them. What is wrong with it is known before any is computed.
    folder.write("hz.csv", curve + "4.0,3e-8\n");
    auto const verified = overturn(folder, {"verify", "c.h5", "--sample", "3"});
    EXPECT_EQ(verified.code, 0) << verified.out << verified.err;
    auto const extended = overturn(folder, {"run", "c.toml", "--extend", "--set", "waves.count=25"});
    EXPECT_EQ(extended.code, 0) << extended.err;
    EXPECT_NE(extended.err.find(" trials of 24 waves are kept, "), std::string::npos) << extended.err;
    for (auto const* verb : {"plan", "run"}) {
        auto const refused = overturn(folder, {verb, "c.toml", "--set", "hazard=pgv.csv"});
        EXPECT_EQ(refused.code, 2);
        EXPECT_TRUE(is_one_error_line(refused.err)) << refused.err;
        EXPECT_NE(refused.err.find("pgv.csv:1: "), std::string::npos) << refused.err;
    }
}

}  // namespace
}  // namespace overturn::testing
