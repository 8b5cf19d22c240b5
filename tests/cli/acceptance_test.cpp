// Requirement R-106: the program says of each wave how right it is, clause by clause, and of a run how many waves it
// refused.
#include <cmath>
#include <sstream>

#include <nlohmann/json.hpp>

#include "cli/campaign_files.hpp"
#include "support/command.hpp"

namespace overturn::testing {
namespace {

class Acceptance : public ::testing::Test {
  protected:
    void SetUp() override {
        folder.write("target.csv", target_csv);
        auto text = small_campaign();
        text.replace(text.find("count=12"), 8, "count=4");
        text.replace(text.find("match_iterations=3"), 18, "acceptance='japan'");
        folder.write("c.toml", text);
    }
    Folder folder;
};

TEST_F(Acceptance, WaveReportsEveryClause) {
    auto const ended = overturn(folder, {"wave", "c.toml", "--wave", "1", "--json"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    auto const json = nlohmann::json::parse(ended.out);
    auto const& acceptance = json.at("acceptance");
    EXPECT_EQ(acceptance.at("rule"), "japan");
    bool all = true;
    bool band = false;
    for (auto const& clause : acceptance.at("clauses")) {
        double const figure = clause.at("figure");
        double const limit = clause.at("limit");
        bool const met = clause.at("at_least").get<bool>() ? figure >= limit : figure <= limit;
        EXPECT_EQ(clause.at("passed").get<bool>(), met) << clause;
        all = all && met;
        band = band || clause.at("name") == "rocking band [T0, T1] of type-b";
    }
    EXPECT_TRUE(band);
    EXPECT_EQ(acceptance.at("accepted").get<bool>(), all);
    EXPECT_EQ(json.at("bands").size(), 2U);
    EXPECT_GT(json.at("vertical_match").at("mean_misfit").get<double>(), 0);
    EXPECT_LT(std::abs(json.at("correlation").get<double>()), 0.16);
    EXPECT_FALSE(json.contains("transverse_match"));
    EXPECT_GT(json.at("vertical_pga_mps2").get<double>(), 0);

    auto const csv = overturn(folder, {"wave", "c.toml", "--wave", "1"});
    double pga = 0;
    std::istringstream lines(csv.out);
    for (std::string line; std::getline(lines, line);) {
        auto const comma = line.find(',');
        pga = std::max(pga, std::abs(std::strtod(line.c_str() + comma + 1, nullptr)));
    }
    EXPECT_NEAR(json.at("pga_mps2").get<double>(), pga, 1e-12 * pga);
    EXPECT_GT(json.at("pgv_mps").get<double>(), 0);
    EXPECT_GT(json.at("pgd_m").get<double>(), 0);

    auto const written = overturn(folder, {"wave", "c.toml", "--wave", "1", "-o", "w.csv"});
    EXPECT_NE(written.err.find("japan: SI ratio"), std::string::npos) << written.err;
    EXPECT_NE(written.err.find(all ? "japan: accepted" : "japan: NOT accepted"), std::string::npos) << written.err;
}

/// Without a rule a wave that missed its match is used, and counted in plain words.
TEST_F(Acceptance, RunAndStatusCountWavesThatMissedTheirMatch) {
    auto const run = overturn(folder, {"run", "c.toml", "--set", "waves.match_iterations=1", "--set",
                                       "waves.acceptance=none", "--set", "waves.match_tolerance=0.001"});
    ASSERT_EQ(run.code, 0) << run.err;
    std::string const counted = "4 waves, 4 missed match_tolerance and are used as they are";
    EXPECT_NE(run.out.find(counted), std::string::npos) << run.out;
    auto const status = overturn(folder, {"status", "c.h5"});
    EXPECT_NE(status.out.find(counted), std::string::npos) << status.out;
}

TEST_F(Acceptance, RunPlanAndStatusCountRefusedWaves) {
    std::string const starve = "waves.match_iterations=1";
    auto const plan = overturn(folder, {"plan", "c.toml", "--set", starve});
    EXPECT_NE(plan.out.find("4 waves, 4 not accepted by japan"), std::string::npos) << plan.out;
    auto const run = overturn(folder, {"run", "c.toml", "--set", starve});
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_NE(run.out.find("4 waves, 4 not accepted by japan (their trials are failed rows)"), std::string::npos);
    auto const status = overturn(folder, {"status", "c.h5"});
    EXPECT_EQ(status.code, 0);
    EXPECT_NE(status.out.find("4 not accepted by japan"), std::string::npos) << status.out;
    EXPECT_NE(status.out.find("failed trials: 24 (wave-not-accepted 24)"), std::string::npos) << status.out;
    EXPECT_NE(status.out.find("  trial 4: wave 0, type-b, pga 600 gal: wave-not-accepted ("), std::string::npos);
    EXPECT_NE(status.out.find("  not met by 4 waves: judged to\n"), std::string::npos) << status.out;
    EXPECT_EQ(run.out.find("rungs: 24 at-rest"), std::string::npos) << "what failed was on no rung";
    EXPECT_NE(status.out.find("  and 4 more"), std::string::npos) << status.out;
}

}  // namespace
}  // namespace overturn::testing
