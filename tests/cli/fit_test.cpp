// Requirement: `overturn fit` says by the contract's names what the trials hold, from a results file or
// from anybody's table; what is not identifiable is null, and bad tables are refused where they are wrong.
#include <cmath>

#include <nlohmann/json.hpp>

#include "cli/campaign_files.hpp"
#include "support/command.hpp"

namespace overturn::testing {
namespace {

using nlohmann::json;

class Fit : public ::testing::Test {
  protected:
    json table(std::string const& text, std::vector<std::string> const& more = {}) {
        folder.write("t.csv", text);
        auto const ended = overturn(folder, joined({"fit", "--stripes", "t.csv", "--json"}, more));
        EXPECT_EQ(ended.code, 0) << ended.err;
        return json::parse(ended.out);
    }
    void refuse(std::string const& text, std::string const& part) {
        folder.write("t.csv", text);
        auto const ended = overturn(folder, {"fit", "--stripes", "t.csv"});
        EXPECT_EQ(ended.code, 2) << text;
        EXPECT_TRUE(is_one_error_line(ended.err)) << text;
        EXPECT_NE(ended.err.find(part), std::string::npos) << ended.err;
    }

    Folder folder;
};

// The same numbers as tests/stats/fragility_fit_test.cpp, where their derivation stands.
TEST_F(Fit, TableOfKnownAnswer) {
    auto const fit =
        table("# three stripes\noverturned, amplitude ,trials\n\n43,2,54  # the highest\n2,1,54\n25,1.5,54\n",
              {"--design-basis", "1"});
    auto const& curve = fit["fragility"][0];

    EXPECT_EQ(curve["identifiable"], true);
    EXPECT_NEAR(curve["median"].get<double>(), 1.57247651593071, 1e-9);
    EXPECT_NEAR(curve["beta"].get<double>(), 0.270033194702542, 1e-9);
    EXPECT_NEAR(curve["median_interval"][0].get<double>(), 1.4756879325809789, 1e-6);
    EXPECT_NEAR(curve["beta_interval"][1].get<double>(), 0.3627619282471869, 1e-6);
    EXPECT_NEAR(curve["five_percent_point"].get<double>(), 1.0084829479802333, 1e-9);
    EXPECT_EQ(curve["hclpf"], nullptr);
    EXPECT_EQ(curve["one_percent_point"], nullptr);
    EXPECT_EQ(curve["confidence_curves"], json::array());
    EXPECT_EQ(curve["flags"], json::array({"no-beta-u"}));
    EXPECT_EQ(curve["interval_method"], "profile-likelihood");
    ASSERT_EQ(fit["stripes"].size(), 3U);
    EXPECT_EQ(fit["stripes"][0]["amplitude"], 1);
    EXPECT_EQ(fit["stripes"][0]["level"], 0);
    EXPECT_EQ(fit["stripes"][2]["overturned"], 43);
    EXPECT_EQ(curve["probabilities"].size(), 4U);
    EXPECT_EQ(curve["probabilities"][3]["outside_data"], true);
}

TEST_F(Fit, TablesAsOtherProgramsWriteThem) {
    auto const plain = table("amplitude,trials,overturned\n1,54,2\n1.5,54,25\n2,54,43\n");
    EXPECT_EQ(table("amplitude;trials;overturned\n1;54;2\n1.5;54;25\n2;54;43\n"), plain);
    EXPECT_EQ(table("Amplitude\tTrials\tOverturned\r\n1\t54\t2\r\n1.5\t54\t25\r\n2\t54\t43\r\n"), plain);
    EXPECT_EQ(table("\"amplitude\",\"trials\",\"overturned\"\n\"1\",54,2\n1.5,54,25\n2,54,43\n"), plain);
}

//
TEST_F(Fit, BetaUMovesHclpf) {
    std::string const stripes = "amplitude,trials,overturned\n1,54,2\n1.5,54,25\n2,54,43\n";
    auto const with = table(stripes, {"--beta-u", "0.3"})["fragility"][0];
    auto const without = table(stripes)["fragility"][0];
    double const five = without["five_percent_point"];

    EXPECT_NEAR(with["hclpf"].get<double>() / five, std::exp(-1.645 * 0.3), 1e-12);
    EXPECT_EQ(with["five_percent_point"], five);
    EXPECT_TRUE(without["hclpf"].is_null());
    ASSERT_EQ(with["confidence_curves"].size(), 3U);
    EXPECT_EQ(with["confidence_curves"][2]["confidence"], 0.95);
    EXPECT_NEAR(with["confidence_curves"][2]["median"].get<double>() / with["median"].get<double>(),
                std::exp(-1.6448536269514722 * 0.3), 1e-12);
    auto const text = overturn(folder, {"fit", "--stripes", "t.csv"}).out;
    EXPECT_NE(text.find("5 % point    HCLPF 1 % point"), std::string::npos) << text;
    EXPECT_NE(text.find("1.008        -         -"), std::string::npos) << text;
}

// Nothing overturned, everything, one level, separation: null, never a number.
TEST_F(Fit, NotIdentifiableIsNull) {
    for (std::string const rows : {"1,50,0\n2,50,0\n", "1,50,50\n2,50,50\n", "1,50,7\n", "1,50,0\n2,50,50\n",
                                   "1,50,20\n2,50,10\n", "1,50,0\n2,50,1\n3,50,0\n"}) {
        auto const fit = table("amplitude,trials,overturned\n" + rows);
        auto const& curve = fit["fragility"][0];

        EXPECT_EQ(curve["identifiable"], false) << rows;
        for (auto const* key :
             {"median", "beta", "median_interval", "beta_interval", "hclpf", "profile", "bootstrap"}) {
            ASSERT_TRUE(curve.contains(key)) << key;
            EXPECT_TRUE(curve[key].is_null()) << key << " of " << rows;
        }
        EXPECT_FALSE(curve["flags"].empty()) << rows;
        EXPECT_FALSE(curve["warnings"].empty()) << rows;
    }
}

TEST_F(Fit, BadTablesAreRefusedWhereTheyAreWrong) {
    std::string const head = "amplitude,trials,overturned\n";
    refuse("", "t.csv: empty");
    refuse(head, "no stripe");
    refuse("amplitude,trials,fell\n1,2,1\n", "t.csv:1:18: column 'fell'");
    refuse("amplitude,trials\n1,2\n", "no column 'overturned'");
    refuse("amplitude,trials,trials,overturned\n1,2,2,1\n", "t.csv:1:18: column 'trials' twice");
    refuse(head + "1,54\n", "2 columns");
    refuse(head + "1,54,x\n", "t.csv:2:6: 'x'");
    refuse(head + "\n1,54, 55\n", "t.csv:3:7: 55 overturned");
    refuse(head + "0,54,1\n", "t.csv:2:1: amplitude 0");
    refuse(head + "-1,54,1\n", "amplitude -1");
    refuse(head + "nan,54,1\n", "not a number");
    refuse(head + "1,5.5,1\n", "not a count");
    refuse(head + "1,54,-1\n", "not a count");
    refuse(head + "1,0,0\n", "no trial");
    refuse(head + "1,54,1\n1,54,2\n", "t.csv:3:1: amplitude 1 twice");
    refuse("amplitude;trials;overturned\n1,5;54;2\n", "t.csv:2:1: '1,5'");
    EXPECT_EQ(overturn(folder, {"fit"}).code, 2);
    EXPECT_EQ(overturn(folder, {"fit", "--stripes", "t.csv", "--confidence", "0"}).code, 2);
    EXPECT_EQ(overturn(folder, {"fit", "no.csv", "--stripes", "t.csv"}).code, 2);
    EXPECT_EQ(overturn(folder, {"fit", "--stripes", "none.csv"}).code, 2);
}

/// From a results file: a curve per body and measure, the criterion of both measures, a verdict in words.
TEST_F(Fit, ResultsFile) {
    folder.write("target.csv", target_csv);
    folder.write("c.toml", small_campaign("shared", 20));
    ASSERT_EQ(overturn(folder, {"run", "c.toml", "--set", "levels.values=['600 gal','1200 gal','2000 gal']"}).code, 0);
    auto const fit = json::parse(overturn(folder, {"fit", "c.h5", "--json"}).out);

    std::vector<std::string> measures;
    for (auto const& curve : fit["fragility"]) {
        if (curve["body"] == "type-b") {
            measures.push_back(curve["measure"]);
        }
        for (auto const* key : {"identifiable", "median", "beta", "median_interval", "beta_interval",
                                "five_percent_point", "hclpf", "flags"}) {
            EXPECT_TRUE(curve.contains(key)) << key;
        }
        EXPECT_EQ(curve["identifiable"].get<bool>(), !curve["median"].is_null());
        EXPECT_EQ(curve["waves"], 20);
    }
    EXPECT_EQ(measures, (std::vector<std::string>{"pga", "pgv", "v_wes", "ou_v_e", "v_wes_ratio"}));
    ASSERT_EQ(fit["criterion"].size(), 4U);
    EXPECT_EQ(fit["criterion"][0]["safe_but_overturned"]["of"].get<int>(),
              fit["criterion"][0]["false_safe"].get<int>() + fit["criterion"][0]["true_safe"].get<int>());
    ASSERT_EQ(fit["verdict"].size(), 2U);
    auto const& over_levels = fit["fragility"][0];
    EXPECT_EQ(over_levels["probabilities"][0]["multiple"], 1);
    EXPECT_EQ(over_levels["probabilities"][0]["amplitude"], 6);
    EXPECT_EQ(over_levels["probabilities"][0]["trials"], 20);
}

// Type B's restitution is drawn, type A is known exactly: beta^2 = beta_R^2 + beta_U^2, and HCLPF takes them
// apart.
TEST_F(Fit, TellsWhatTheBodyAddsToBeta) {
    folder.write("target.csv", target_csv);
    folder.write("c.toml", small_campaign("shared", 40));
    ASSERT_EQ(
        overturn(folder, {"run", "c.toml", "--set", "levels.values=['600 gal','900 gal','1200 gal','1600 gal']"}).code,
        0);
    auto const fit = json::parse(overturn(folder, {"fit", "c.h5", "--json"}).out);
    int drawn = 0;
    for (auto const& curve : fit["fragility"]) {
        if (!curve["identifiable"].get<bool>()) {
            continue;
        }
        double const r = curve["beta_r"];
        double const u = curve["beta_u"];
        double const beta = curve["beta"];
        if (curve["body"] == "type-a" || curve["drawn"].empty()) {
            EXPECT_TRUE(curve["drawn"].empty());
            EXPECT_EQ(curve["hclpf"], nullptr);
            EXPECT_EQ(u, 0);
            EXPECT_EQ(r, beta);
            continue;
        }
        ++drawn;
        if (curve["five_percent_point"].is_null()) {
            EXPECT_EQ(curve["hclpf"], nullptr);
        } else {
            EXPECT_NEAR(curve["hclpf"].get<double>() / (curve["median"].get<double>() * std::exp(-1.645 * (r + u))), 1,
                        1e-9);
            EXPECT_LE(curve["hclpf_interval"][0].get<double>(), curve["hclpf"].get<double>());
        }
        EXPECT_NEAR(std::hypot(r, u), std::max(beta, u), 1e-12);
        EXPECT_EQ(curve["drawn"][0]["quantity"], "restitution");
        EXPECT_LT(curve["drawn"][0]["log_median_per_deviation"].get<double>(), 0) << "livelier bodies fall earlier";
    }
    EXPECT_GT(drawn, 0);

    // What is stated comes on top of what was drawn, and lessens no beta_R.
    auto const both = json::parse(overturn(folder, {"fit", "c.h5", "--json", "--beta-u", "0.3"}).out);
    for (std::size_t i = 0; i < fit["fragility"].size(); ++i) {
        auto const& before = fit["fragility"][i];
        auto const& after = both["fragility"][i];
        if (before["hclpf"].is_number()) {
            EXPECT_EQ(after["beta_r"], before["beta_r"]);
            EXPECT_NEAR(after["beta_u"].get<double>(), std::hypot(before["beta_u"].get<double>(), 0.3), 1e-12);
            EXPECT_EQ(after["beta_u_drawn"], before["beta_u_drawn"]);
        }
    }
}

}  // namespace
}  // namespace overturn::testing
