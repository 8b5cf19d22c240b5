// Requirement R-701: fit states for several bodies under one wave how likely any falls and whether they fall together,
// and fits a curve over two measures where it is asked to.
#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "cli/campaign_files.hpp"
#include "support/command.hpp"

namespace overturn::testing {
namespace {

using nlohmann::json;

class Together : public ::testing::Test {
  protected:
    Together() {
        folder.write("target.csv", target_csv);
        folder.write("c.toml", small_campaign("shared", 40));
        auto const run =
            overturn(folder, {"run", "c.toml", "--set", "levels.values=['600 gal','900 gal','1200 gal','1600 gal']"});
        EXPECT_EQ(run.code, 0) << run.err;
    }
    Folder folder;
};

/// Any falls at least as often as each, at most as often as both counts together; counted again from the stripes.
TEST_F(Together, AnyOfTheBodies) {
    auto const fit = json::parse(overturn(folder, {"fit", "c.h5", "--json"}).out);
    auto const levels = fit["together"].size();
    ASSERT_EQ(fit["pairs"].size(), levels);
    EXPECT_EQ(fit["pairs"][0]["first"], "type-a");
    EXPECT_EQ(fit["pairs"][0]["second"], "type-b");
    ASSERT_EQ(2 * levels, fit["stripes"].size());
    for (std::size_t l = 0; l < levels; ++l) {
        auto const& any = fit["together"][l];
        EXPECT_EQ(any["limit"], "overturning");
        int const a = fit["stripes"][l]["overturned"];
        int const b = fit["stripes"][levels + l]["overturned"];
        EXPECT_EQ(any["amplitude"], fit["stripes"][l]["amplitude"]);
        EXPECT_EQ(any["waves"], 40);
        EXPECT_GE(any["overturned"].get<int>(), std::max(a, b));
        EXPECT_LE(any["overturned"].get<int>(), a + b);
        EXPECT_LE(any["lower"].get<double>(), any["probability"].get<double>());
    }
    auto const text = overturn(folder, {"fit", "c.h5", "--section", "together"}).out;
    EXPECT_NE(text.find("any of 2 bodies overturns under one wave"), std::string::npos) << text;
    EXPECT_NE(text.find("phi pooled over levels: type-a/type-b "), std::string::npos) << text;
}

//
TEST_F(Together, SaysWhatItNeedsOfOneBody) {
    auto one = small_campaign("shared", 12);
    auto const second = one.rfind("[[bodies]]");
    folder.write("one.toml", one.erase(second, one.find("[levels]") - second));
    ASSERT_EQ(overturn(folder, {"run", "one.toml", "-o", "one.h5"}).code, 0);
    auto const text = overturn(folder, {"fit", "one.h5", "--section", "together"}).out;
    EXPECT_NE(text.find("needs several bodies (and no grid), or two measures"), std::string::npos) << text;
}

// what `new` writes without a friction: one cask in two cases, which never stand together.
TEST_F(Together, SaysWhatItMeansOfOneCaskInTwoCases) {
    auto const told = [&](std::string const& second) {
        folder.write("two.toml",
                     "seed=3\n[waves]\nsource='filtered-noise'\nmodel='kanai-tajimi'\nrms='1 m/s2'\ncount=24\n"
                     "duration='4 s'\ntime_step='0.02 s'\n[levels]\nmeasure='pga'\nvalues=['6 m/s2']\n"
                     "[[bodies]]\nname='slides'\nmass='1 t'\nbase_width='0.4 m'\ncentre_height='0.8 m'\n"
                     "inertia='uniform-block'\nfriction=0.2\n[[bodies]]\nname='rocks'\nbase_width='0.4 m'\n"
                     "centre_height='0.8 m'\ninertia='uniform-block'\nfriction=0.8\n"
                         + second);
        std::filesystem::remove(folder / "two.h5");
        EXPECT_EQ(overturn(folder, {"run", "two.toml"}).code, 0);
        return unwrapped(overturn(folder, {"fit", "two.h5", "--section", "together"}).out);
    };
    std::string const note =
        "note: slides, rocks have one mass and one shape. If they are one cask under several "
        "assumptions, P of any of them means nothing";
    EXPECT_NE(told("mass='1 t'\n").find(note), std::string::npos);
    EXPECT_EQ(told("mass='1.1 t'\n").find(note), std::string::npos);
}

//
TEST_F(Together, CurveOverTwoMeasures) {
    auto const plain = json::parse(overturn(folder, {"fit", "c.h5", "--json"}).out);
    EXPECT_FALSE(plain.contains("two_measures"));
    auto const fit = json::parse(overturn(folder, {"fit", "c.h5", "--json", "--measures", "pga,v_wes"}).out);
    ASSERT_EQ(fit["two_measures"].size(), 2U);
    auto const& b = fit["two_measures"][1];
    EXPECT_EQ(b["body"], "type-b");
    EXPECT_EQ(b["first"], "pga");
    EXPECT_EQ(b["second"], "v_wes");
    ASSERT_TRUE(b["identifiable"].get<bool>()) << b;
    EXPECT_GE(b["deviance_gain"].get<double>(), 0);
    double const along = b["slope_first"].get<double>() + b["slope_second"].get<double>();
    EXPECT_NEAR(b["beta"].get<double>(), 1 / along, 1e-12);
    auto const text = overturn(folder, {"fit", "c.h5", "--measures", "pga,v_wes"}).out;
    EXPECT_NE(text.find("type-b: P = Phi("), std::string::npos) << text;
    EXPECT_NE(text.find(" alone, the better one"), std::string::npos) << text;
}

// The cross-check by hand finds type A the harder to overturn, and says what it is.
TEST_F(Together, IsCheckedByHand) {
    auto const fit = json::parse(overturn(folder, {"fit", "c.h5", "--json"}).out);
    auto const& hand = fit["hand_check"];
    ASSERT_EQ(hand.size(), 2U);
    EXPECT_EQ(hand[0]["waves"], 32);
    double const a = hand[0]["overturning_level"];
    double const b = hand[1]["overturning_level"];
    EXPECT_GT(a, b);
    for (auto const& check : hand) {
        EXPECT_GT(check["rotation_ratio"].get<double>(), 0);
        EXPECT_LE(check["rotation_ratio"].get<double>(), 1);
        auto const& median = check["simulated_median"];
        EXPECT_EQ(check["unsafe"].is_null(), median.is_null()) << check;
        if (!median.is_null()) {
            EXPECT_EQ(check["unsafe"].get<bool>(), check["overturning_level"] > median) << check;
        }
    }
    auto const text = overturn(folder, {"fit", "c.h5", "--section", "hand"}).out;
    EXPECT_NE(text.find("hand calculation: energy balance under the 84th-percentile spectrum of the first"),
              std::string::npos)
        << text;
    auto const line = hand[1]["unsafe"] == true ? "  type-b: unsafe, do not quote (half overturn at "
                                                : "  type-b: overturns above pga ";
    EXPECT_NE(text.find(line), std::string::npos) << text;
}

TEST_F(Together, MeasuresThatAreNoneAreRefused) {
    auto const refuse = [&](std::vector<std::string> const& args, std::string const& part) {
        auto const ended = overturn(folder, args);
        EXPECT_EQ(ended.code, 2);
        EXPECT_TRUE(is_one_error_line(ended.err)) << ended.err;
        EXPECT_NE(ended.err.find(part), std::string::npos) << ended.err;
    };
    refuse({"fit", "c.h5", "--measures", "pga"},
           "'pga' is not two measures (a comma parts them). State for example pga,pgv");
    refuse({"fit", "c.h5", "--measures", "pga,pgx"},
           "'pgx' is no measure of this campaign (its curves are over others). State two of pga, pgv, v_wes");
    refuse({"fit", "c.h5", "--measures", "pga,pga"}, "'pga' twice");
    folder.write("t.csv", "amplitude,trials,overturned\n1,54,2\n2,54,43\n");
    refuse({"fit", "--stripes", "t.csv", "--measures", "pga,pgv"}, "--measures without a results file");
}

}  // namespace
}  // namespace overturn::testing
