// Requirement R-702: a table of single trials is distinguished from one of counts by its rows where a name may be
// either, and what counts those that stood is no count of those that fell.
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/campaign_files.hpp"
#include "support/command.hpp"

namespace overturn::testing {
namespace {

using nlohmann::json;

class TrialsColumn : public ::testing::Test {
  protected:
    [[nodiscard]] Ended fit(std::string const& content, std::vector<std::string> further = {}) {
        folder.write("t.csv", content);
        std::vector<std::string> words{"fit", "--stripes", "t.csv", "--json"};
        words.insert(words.end(), further.begin(), further.end());
        return overturn(folder, words);
    }
    [[nodiscard]] json stripes(std::string const& content) {
        auto const done = fit(content);
        EXPECT_EQ(done.code, 0) << done.err;
        return done.code == 0 ? json::parse(done.out)["stripes"] : json();
    }
    void refuse(std::string const& content, std::string const& why, std::vector<std::string> further = {}) {
        auto const done = fit(content, std::move(further));
        EXPECT_EQ(done.code, 2) << done.out;
        EXPECT_NE(done.err.find(why), std::string::npos) << done.err;
    }
    Folder folder;
};

TEST_F(TrialsColumn, NumbersOfTrialsAreNoCounts) {
    auto const single = stripes("id,pga [g],overturned\n1,0.5,0\n2,0.7,0\n3,0.6,1\n4,0.9,1\n");
    ASSERT_EQ(single.size(), 4U);
    for (char const* name : {"wave", "record", "GM", "motion", "test", "trial", "ground motion"}) {
        EXPECT_EQ(stripes(fmt::format("{},pga [g],overturned\n1,0.5,0\n2,0.7,0\n3,0.6,1\n4,0.9,1\n", name)), single)
            << name;
    }
    EXPECT_EQ(stripes("wave,pga [g],overturned\nELC,0.5,0\nTAF,0.7,0\nKOB,0.6,1\nTOK,0.9,1\n"), single);
    EXPECT_EQ(stripes("pga [g],wave,overturned\n0.5,3,0\n0.6,1,1\n0.7,4,0\n0.9,2,1\n"), single);
    EXPECT_EQ(stripes("pga [g],record,overturned\n0.5,107,0\n0.6,100,1\n0.7,121,0\n0.9,114,1\n"), single);
    auto const twice = stripes("wave,pga [g],overturned\n1,0.6,0\n1,0.9,1\n2,0.6,0\n2,0.9,1\n");
    ASSERT_EQ(twice.size(), 2U);
    EXPECT_EQ(twice[0]["trials"], 2);
}

// a wave's name beside its one trial.
TEST_F(TrialsColumn, NamesMayStandBesideOneTrialEach) {
    auto const named = fit("wave,pga [g],overturned\nA,0.6,0\nA,0.9,1\nB,0.6,0\nB,0.9,1\n");
    EXPECT_EQ(fit("wave,pga [g],trials,overturned\nA,0.6,1,0\nA,0.9,1,1\nB,0.6,1,0\nB,0.9,1,1\n").out, named.out);
    EXPECT_EQ(fit("n,overturned,pga [g],record\n1,0,0.6,A\n1,1,0.9,A\n1,0,0.6,B\n1,1,0.9,B\n").out, named.out);
    refuse("wave,pga [g],trials,overturned\nA,0.6,1,0\nB,0.9,2,1\n",
           "t.csv:3:7: '2' trials of a named wave (which of them fell?)");
    refuse("pga [g],trials,n,overturned\n0.6,1,1,0\n", "column 'trials' twice");
    refuse("gm_id,pga [g],trials,overturned\nA,0.6,1,0\n", "trials, overturned, failed, wave, record");
}

// counts stay counts, also of few trials and without a single fall more than one.
TEST_F(TrialsColumn, CountsStayCounts) {
    auto const counted = stripes("trials,pga [g],overturned\n40,0.5,0\n40,0.7,1\n40,0.6,0\n");
    ASSERT_EQ(counted.size(), 3U);
    EXPECT_EQ(counted[0]["trials"], 40);
    EXPECT_EQ(stripes("n,pga [g],overturned\n1,0.5,0\n2,0.7,2\n3,0.9,3\n")[2]["trials"], 3);
    refuse("records,pga [g],overturned\n2,0.5,0\n1,0.7,1\n3,0.9,1\n", "it numbers the rows");
    refuse("trial,pga [g],overturned\n40,0.5,0\n20,0.7,1\n40,0.9,1\n", "it numbers the rows");
    refuse("waves,pga [g],overturned\n1,0.5,0\n2,0.7,1\n3,0.9,1\n", "it numbers the rows");
}

// Of four waves at six levels, each wave falls from a level of its own on. \param called with the wave's number
std::string of_shared_waves(std::string const& header, auto const& called, int waves = 8) {
    std::string rows = header;
    for (int wave = 0; wave < waves; ++wave) {
        for (int level = 0; level < 6; ++level) {
            rows += fmt::format("{},{:g},{}\n", called(wave), 0.5 + 0.1 * level, level > (3 * wave) % 5 ? 1 : 0);
        }
    }
    return rows;
}

// trials of one wave are judged together by its name: intervals of so many waves, and of fewer than five none.
TEST_F(TrialsColumn, TrialsOfOneWaveAreJudgedTogether) {
    auto const by_number = [](int wave) { return fmt::format("W{}", wave); };
    auto const curve = [&](std::string const& text) { return json::parse(fit(text).out)["fragility"][0]; };
    auto const eight = curve(of_shared_waves("record,pga [g],fell\n", by_number));
    EXPECT_EQ(eight["waves"], 8);
    EXPECT_EQ(eight["interval_method"], "widest");
    EXPECT_EQ(curve(of_shared_waves("record,pga [g],fell\n", by_number, 4))["state"], "few-waves");
    auto const by_direction = [](int wave) { return fmt::format("st{}_{}", wave / 2, wave % 2 == 0 ? "NS" : "EW"); };
    EXPECT_EQ(curve(of_shared_waves("record,pga [g],fell\n", by_direction))["state"], "few-waves")
        << "eight components of four recordings";
    auto const by_axis = [](int wave) { return fmt::format("st{}_{}", wave / 3, "xyz"[wave % 3]); };
    EXPECT_EQ(curve(of_shared_waves("record,pga [g],fell\n", by_axis, 24))["waves"], 8);
    auto const halves = json::parse(fit(of_shared_waves("record,pga [g],fell\n", by_direction, 16)).out);
    EXPECT_EQ(halves["fragility"][0]["waves"], 8);
    auto const& stripe = halves["stripes"][2];
    EXPECT_EQ(stripe["trials"], 16);
    auto const counted = stripes("pga [g],trials,overturned\n0.7,16," + stripe["overturned"].dump() + "\n");
    EXPECT_LT(stripe["lower"], counted[0]["lower"]) << "two components of one recording are one sample";
    EXPECT_GT(stripe["upper"], counted[0]["upper"]);
    refuse("record,pga [g],fell\nA,0.5,0\n,0.7,1\nB,0.9,1\n", "t.csv:3:1: no name");
    refuse("record,wave,pga [g],fell\nA,1,0.5,0\nB,2,0.7,1\n", "a second column that names the waves");
}

// where nobody names the waves all levels may have the same ones, unless their number is stated.
TEST_F(TrialsColumn, WavesWithoutANameMayBeTheSame) {
    std::string const counts = "pga [g],trials,overturned\n0.6,40,2\n0.8,40,14\n1.0,40,27\n1.3,40,37\n";
    auto const curve = [&](std::vector<std::string> further) {
        return json::parse(fit(counts, std::move(further)).out)["fragility"][0];
    };
    auto const open = curve({});
    auto const different = curve({"--waves", "160"});
    EXPECT_EQ(different["interval_method"], "profile-likelihood");
    EXPECT_EQ(open["interval_method"], "widest");
    EXPECT_TRUE(open["waves"].is_null()) << "not known";
    constexpr double t_of_39 = 2.0226909;
    double const half = t_of_39 * open["beta"].get<double>() / std::sqrt(39.0);
    double const upper = std::log(open["median_upper"].get<double>() / open["median"].get<double>());
    EXPECT_GE(upper, half - 1e-6) << "of 40 exact capacities, or longer";
    EXPECT_LT(upper, 1.1 * half);
    EXPECT_LT(open["five_percent_point_lower"], different["five_percent_point_lower"]);
    EXPECT_NE(overturn(folder, {"fit", "--stripes", "t.csv"}).out.find("may have the same 40"), std::string::npos);

    refuse(counts, "40 of them at one level", {"--waves", "39"});
    refuse(counts, "160 trials", {"--waves", "161"});
    refuse(of_shared_waves("record,pga [g],fell\n", [](int wave) { return wave; }), "names its waves",
           {"--waves", "48"});
    EXPECT_NE(overturn(folder, {"fit", "--median", "1 g", "--beta", "0.4", "--waves", "5"}).err.find("--stripes only"),
              std::string::npos);
    auto const single = fit("pga [g],fell\n0.6,0\n0.7,1\n0.8,0\n0.9,1\n1.0,0\n1.1,1\n");
    EXPECT_NE(json::parse(single.out)["warnings"].dump().find("these 6 trials may be of 5 alone"), std::string::npos);
}

TEST_F(TrialsColumn, ThoseThatStoodAreNotThoseThatFell) {
    for (char const* name :
         {"non-collapses", "no collapse", "no_collapses", "not overturned", "noncollapse", "stood"}) {
        refuse(fmt::format("pga [g],trials,{}\n0.6,40,0\n0.9,40,0\n", name), "(unknown)");
    }
    EXPECT_EQ(stripes("pga [g],trials,No. of collapses\n0.6,40,3\n0.9,40,30\n")[0]["overturned"], 3);
    EXPECT_EQ(stripes("pga [g],trials,no. collapses\n0.6,40,3\n0.9,40,30\n")[0]["overturned"], 3);
}

// beside a table with a unit the design basis has one; it is converted.
TEST_F(TrialsColumn, TheDesignBasisHasAUnitWhereTheTableHas) {
    std::string const table = "pga [g],trials,overturned\n0.6,40,2\n0.9,40,20\n1.2,40,38\n";
    refuse(table, "one of them states a unit", {"--design-basis", "0.6"});
    refuse(table, "cannot be converted", {"--design-basis", "6 kine"});
    refuse(table, "must be a number above 0", {"--design-basis", "-0.6 g"});
    auto const in_g = fit(table, {"--design-basis", "0.6 g"});
    ASSERT_EQ(in_g.code, 0) << in_g.err;
    auto const in_gal = fit(table, {"--design-basis", "588.399 gal"});
    EXPECT_EQ(json::parse(in_g.out)["fragility"][0]["quotes"].size(),
              json::parse(in_gal.out)["fragility"][0]["quotes"].size());
}

// a unit among other words of the text is none of the intensities.
TEST_F(TrialsColumn, AUnitAmongOtherWordsIsAskedFor) {
    for (char const* line : {"# not in gal", "# g: 9.81 (m/s2)", "# to get gal multiply by 981"}) {
        refuse(fmt::format("{}\npga,trials,overturned\n300,40,2\n600,40,20\n900,40,38\n", line), "among other words");
    }
    EXPECT_EQ(fit("# intensities in gal\npga,trials,overturned\n300,40,2\n600,40,20\n900,40,38\n").code, 0);
}

// an operation in the name of the intensities is refused.
TEST_F(TrialsColumn, OperationsInNamesAreRefused) {
    for (char const* name : {"pga [gal]/2", "pga [gal] x 0.5"}) {
        refuse(fmt::format("{},trials,overturned\n300,40,2\n600,40,20\n900,40,38\n", name), "an operation in its name");
    }
}

}  // namespace
}  // namespace overturn::testing
