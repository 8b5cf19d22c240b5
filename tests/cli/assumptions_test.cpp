// Requirement R-906: what is assumed is reported by list, plan, fit and report, and cost says what it decides.
#include <string>

#include <nlohmann/json.hpp>

#include "cli/campaign_files.hpp"
#include "cli/python.hpp"
#include "support/command.hpp"

namespace overturn::testing {
namespace {

using nlohmann::json;

class Assumptions : public ::testing::Test {
  protected:
    Assumptions() {
        folder.write("target.csv", target_csv);
        auto campaign = small_campaign("shared", 4);
        campaign.insert(campaign.find("[levels]"),
                        "basis = {centre_height = {basis = 'assumed', source = 'A & B'}, mass = "
                        "'published: <paper>', others = 'measured'}\n");
        folder.write("c.toml", campaign);
    }
    Folder folder;
};

TEST_F(Assumptions, AreListed) {
    auto listed = overturn(folder, {"list", "assumptions"});
    ASSERT_EQ(listed.code, 0) << listed.err;
    listed.out = unwrapped(listed.out);
    auto const table = json::parse(overturn(folder, {"list", "assumptions", "--json"}).out);

    ASSERT_GE(table.size(), 15U);
    for (auto const& one : table) {
        EXPECT_NE(listed.out.find(one["name"].get<std::string>()), std::string::npos);
        EXPECT_NE(listed.out.find(one["assumed"].get<std::string>()), std::string::npos);
        auto const direction = one["direction"].get<std::string>();
        EXPECT_TRUE(direction == "safe" || direction == "unsafe" || direction == "unknown") << direction;
        EXPECT_TRUE(one["key"].is_string() && one["effect"].is_string() && one["evidence"].is_string());
    }
    auto const wrong = overturn(folder, {"list", "assumption"});
    EXPECT_EQ(wrong.code, 2);
    EXPECT_NE(wrong.err.find("Choose keys, columns FILE.h5, assumptions, sources"), std::string::npos) << wrong.err;
    EXPECT_EQ(overturn(folder, {"list", "--json"}).code, 2);
}

TEST_F(Assumptions, ArePlannedWithTheirCounts) {
    auto const plan = planned(folder, {"c.toml"});
    ASSERT_EQ(plan.code, 0) << plan.err;
    auto const stated = json::parse(planned(folder, {"c.toml", "--json"}).out)["assumptions"];
    auto const& counts = stated["counts"];

    EXPECT_EQ(counts["assumed"], 1);
    EXPECT_EQ(counts["published"], 1);
    EXPECT_EQ(counts["inputs"], stated["inputs"].size());
    auto const line = "\ninputs    " + counts["inputs"].dump() + ": 1 assumed, 1 published, "
                      + counts["measured"].dump() + " measured, " + counts["not_stated"].dump() + " without a source, ";
    EXPECT_NE(plan.out.find(line), std::string::npos) << plan.out;
    EXPECT_NE(plan.out.find("assumed   bodies[1].centre_height (values and reasons: --full)"), std::string::npos)
        << plan.out;
    EXPECT_NE(planned(folder, {"c.toml", "--full"}).out.find("assumed   bodies[1].centre_height = 1.045 m (A & B)"),
              std::string::npos);
    EXPECT_NE(plan.out.find(" unsafe (if false, more bodies overturn)"), std::string::npos);
    auto const& first = stated["inputs"][0];
    EXPECT_EQ(first["key"], "bodies[1].centre_height");
    EXPECT_EQ(first["si"], 1.045);
    EXPECT_EQ(first["file"], "c.toml");
    EXPECT_GT(first["line"], 0);
}

TEST_F(Assumptions, AreReadBackFromAResultsFile) {
    ASSERT_EQ(overturn(folder, {"run", "c.toml", "-o", "r.h5"}).code, 0);
    auto const before = json::parse(planned(folder, {"c.toml", "--json"}).out)["assumptions"];
    auto const fitted = json::parse(overturn(folder, {"fit", "r.h5", "--json"}).out)["assumptions"];

    EXPECT_EQ(fitted["counts"], before["counts"]);
    EXPECT_EQ(fitted["model"], before["model"]);
    EXPECT_EQ(fitted["inputs"].size(), before["inputs"].size());
}

TEST_F(Assumptions, AreASectionOfTheReport) {
    if (!has_python(folder, "matplotlib, h5py")) {
        GTEST_SKIP() << "no matplotlib and h5py to draw with";
    }
    ASSERT_EQ(overturn(folder, {"run", "c.toml", "-o", "r.h5"}).code, 0);
    auto const ended = overturn(folder, {"report", "r.h5", "-o", "p.html", "--figures", "f"});
    ASSERT_EQ(ended.code, 0) << ended.err;

    auto const page = folder.read("p.html");
    auto const section = page.substr(page.find("<section id=\"assumptions\">"));
    EXPECT_NE(section.find("1 of "), std::string::npos);
    EXPECT_LT(section.find("A &amp; B"), section.find("&lt;paper&gt;")) << "assumed ones come first";
    EXPECT_NE(section.find("one-spectrum"), std::string::npos);
    EXPECT_EQ(section.find("independent-components") != std::string::npos, true);
    EXPECT_TRUE(folder.has("f/inputs.csv"));
    EXPECT_TRUE(folder.has("f/assumptions.csv"));
}

TEST_F(Assumptions, AreMovedByCost) {
    auto const table = overturn(folder, {"cost", "c.toml", "--sensitivity"});
    ASSERT_EQ(table.code, 0) << table.err;
    EXPECT_NE(table.err.find("100 %"), std::string::npos) << "no word of progress: " << table.err;
    EXPECT_NE(table.out.find("bodies[1].centre_height"), std::string::npos) << table.out;
    auto const study = json::parse(overturn(folder, {"cost", "c.toml", "--sensitivity", "--json"}).out);
    ASSERT_EQ(study["rows"].size(), 2U) << "both ends of one input";
    EXPECT_EQ(study["rows"][0]["body"], "type-b");
    EXPECT_EQ(study["rows"][0]["end"], "low");
    EXPECT_EQ(study["rows"][1]["end"], "high");
    EXPECT_EQ(study["study"][0]["waves"], 4);

    auto const wrong = overturn(folder, {"cost", "c.toml", "--sensitivity", "-o", "x.h5"});
    EXPECT_EQ(wrong.code, 2);
    EXPECT_NE(wrong.err.find("-o beside --sensitivity"), std::string::npos) << wrong.err;
}

TEST_F(Assumptions, MovedAreAPageOfTheirOwn) {
    if (!has_python(folder, "matplotlib")) {
        GTEST_SKIP() << "no matplotlib to draw with";
    }
    auto const ended =
        overturn(folder, {"cost", "c.toml", "--sensitivity", "--html", "s.html", "--set", "waves.count=16", "--set",
                          "levels.values=['900 gal', '1200 gal', '1600 gal', '2200 gal']"});
    ASSERT_EQ(ended.code, 0) << ended.err;

    auto const page = folder.read("s.html");
    EXPECT_NE(page.find("<svg"), std::string::npos);
    EXPECT_NE(page.find("bodies[1].centre_height"), std::string::npos);
    for (char const* loads : {"src=", "<link", "@import", "url(http"}) {
        EXPECT_EQ(page.find(loads), std::string::npos) << loads;
    }
}

}  // namespace
}  // namespace overturn::testing
