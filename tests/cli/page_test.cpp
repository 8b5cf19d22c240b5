// Requirement: a page says what was run, holds the campaign word for word, draws what is known of the
// bodies, and is sound in a browser: nothing loaded, nothing on the console, nothing cut on a phone, on a desk or in
// print.
#include <cstdlib>
#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/campaign_files.hpp"
#include "support/command.hpp"

namespace overturn::testing {
namespace {

using nlohmann::json;

/// Quick waves without a target; two bodies, one assembled from parts.
std::string quick_campaign(std::string const& more = "") {
    return "title='quick'\nseed=3\n"
           "[waves]\nsource='filtered-noise'\nmodel='kanai-tajimi'\nrms='1 m/s2'\ncount=64\nduration='8 s'\n"
           "time_step='0.02 s'\n[waves.envelope]\nshape='constant'\n"
           "[[bodies]]\nname='cask'\nbase_width='0.5 m'\n"
           "[[bodies.parts]]\nkind='cylinder'\nmass='1 t'\ndiameter='0.4 m'\nheight='1.5 m'\nbottom='0.1 m'\n"
           "[[bodies.parts]]\nkind='box'\nmass='0.3 t'\nwidth='0.5 m'\nheight='0.1 m'\n"
           "[[bodies]]\nname='block'\nmass='1 t'\nbase_width='0.4 m'\ncentre_height='0.8 m'\ninertia='uniform-block'\n"
           "friction=0.5\n[levels]\nmeasure='pga'\nvalues=['3 m/s2', '6 m/s2', '12 m/s2']\ndesign_basis='6 m/s2'\n"
           + more;
}

class Page : public ::testing::Test {
  protected:
    Page() { ::unsetenv("OVERTURN_PYTHON"); }
    ~Page() override { ::unsetenv("OVERTURN_PYTHON"); }

    void run(std::string const& campaign, std::vector<std::string> const& more = {}) {
        folder.write("c.toml", campaign);
        auto const ended = overturn(folder, joined({"run", "c.toml", "-o", "c.h5"}, more));
        ASSERT_EQ(ended.code, 0) << ended.err;
    }
    /// The data that a page would be made of.
    json data_of(std::vector<std::string> const& command, std::string const& output) {
        folder.write("interpreter", "#!/bin/sh\ncp \"$4\" \"$5\"\n");
        std::filesystem::permissions(folder / "interpreter", std::filesystem::perms::owner_all);
        ::setenv("OVERTURN_PYTHON", (folder / "interpreter").c_str(), 1);
        said = overturn(folder, joined(command, {output}));
        EXPECT_EQ(said.code, 0) << said.err;
        ::unsetenv("OVERTURN_PYTHON");
        return json::parse(folder.read(output));
    }
    bool drawable() { return execute(folder, {OVERTURN_PYTHON, "-c", "import matplotlib, h5py"}).code == 0; }
    /// What the browser finds wrong; nothing where all is well.
    std::string faults(std::string const& page) {
        auto const ended = execute(folder, {OVERTURN_PYTHON, "-B", OVERTURN_BROWSER_SCRIPT, browser(), page});
        EXPECT_EQ(ended.code, 0) << ended.err;
        return ended.out;
    }
    static std::string browser() {
        for (auto const* path : {"/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"}) {
            if (std::filesystem::exists(path)) {
                return path;
            }
        }
        return "";
    }

    Folder folder;
    Ended said;
};

TEST_F(Page, ReportsWhatRanOfACampaignThatEndedEarly) {
    run(quick_campaign("[statistics]\ntarget_half_width=0.45\n"));
    auto const facts = data_of({"report", "c.h5", "-o"}, "c.html").at("facts");
    json told;
    for (auto const& fact : facts) {
        told[fact[0].get<std::string>()] = fact[1];
    }
    EXPECT_TRUE(told["waves"].get<std::string>().starts_with("32 of 64 planned: it ended early, precise enough ("))
        << told;
    EXPECT_EQ(told["trials"], "192 of 384 planned: it ended early, precise enough");

    std::filesystem::remove(folder / "c.h5");
    run(quick_campaign(), {"--set", "waves.count=4"});
    auto const data = data_of({"report", "c.h5", "-o"}, "c.html");
    for (auto const& fact : data.at("facts")) {
        EXPECT_EQ(fact[1].get<std::string>().find("planned"), std::string::npos) << fact;
        EXPECT_TRUE(fact[0] != "trials" || fact[1] == "24") << fact;
    }
}

TEST_F(Page, DrawsABodyFromItsParts) {
    run(quick_campaign(), {"--set", "waves.count=3"});
    auto const parts = data_of({"report", "c.h5", "-o"}, "c.html").at("parts");
    EXPECT_EQ(parts.at("cask"), json({{0.4, 1.5, 0.1}, {0.5, 0.1, 0.0}}));
    EXPECT_TRUE(parts.at("block").empty());
}

//
TEST_F(Page, StatesHowABodyStandsThatIsNotStraight) {
    run(quick_campaign(), {"--set", "bodies.1.slope=\"1 deg\"", "--set", "bodies.1.initial_tilt=\"-2 deg\""});
    auto const lines = data_of({"report", "c.h5", "-o"}, "page.html").at("placements");
    ASSERT_EQ(lines.size(), 1U);  // the cask stands straight
    // atan(0.2 / 0.8) = 14.04 deg, less and more one
    EXPECT_EQ(lines.at(0),
              "block: on ground that falls by 1° towards +x; let go at -2°. It tips at 13.04° towards +x and at "
              "15.04° towards -x; what the table says is of the weaker side.");
}

// The restitution of a rim is not that of the table of bodies: the page states the one that was computed with.
TEST_F(Page, StatesFrictionAndTheRestitutionOfABase) {
    run(quick_campaign(), {"--set", "bodies.1.base={shape=\"round\"}", "--set", "waves.count=3"});
    auto const lines = data_of({"report", "c.h5", "-o"}, "page.html").at("supports");
    ASSERT_EQ(lines.size(), 3U) << lines;
    EXPECT_EQ(lines.at(0), "cask: no friction stated: it does not slide.");
    EXPECT_TRUE(lines.at(1).get<std::string>().starts_with("block: friction 0.5 ")) << lines;
    auto const base = lines.at(2).get<std::string>();
    EXPECT_TRUE(
        base.starts_with("block: round base on its continuous rim; pad 98 Hz, elastic; rocks with restitution 0."))
        << base;
    EXPECT_TRUE(base.ends_with("(from base and pad; e is not used).")) << base;
}

// A body of 12 m under a length ratio of 0.4 is drawn at 0.4 of its size.
TEST_F(Page, DrawsAModelAtItsOwnSize) {
    auto campaign = quick_campaign();
    campaign.insert(campaign.find("[[bodies.parts]]"), "similarity={direction='to-model', length=0.4}\n");
    run(campaign, {"--set", "waves.count=3"});
    auto const parts = data_of({"report", "c.h5", "-o"}, "c.html").at("parts").at("cask");
    EXPECT_NEAR(parts[0][0].get<double>(), 0.16, 1e-12);
    EXPECT_NEAR(parts[0][1].get<double>(), 0.6, 1e-12);
    EXPECT_NEAR(parts[0][2].get<double>(), 0.04, 1e-12);
}

// The band of SRP 3.7.1 stands beside a target only where the campaign asks to be held to it.
TEST_F(Page, ShowsABandOnlyWhereARuleIsAsked) {
    folder.write("target.csv", target_csv);
    folder.write("c.toml", small_campaign("shared", 1));
    auto const bands = [&](std::string const& rule) {
        return data_of({"wave", "c.toml", "--wave", "0", "--set", "waves.acceptance='" + rule + "'", "--plot"}, "w.svg")
            .at("target")
            .at("bands");
    };
    EXPECT_TRUE(bands("none").empty());
    EXPECT_TRUE(bands("japan").empty());
    ASSERT_EQ(bands("srp-3.7.1").size(), 1U);
    EXPECT_EQ(bands("srp-3.7.1")[0].at("lower"), 0.9);
}

TEST_F(Page, HoldsTheCampaignWordForWord) {
    if (!drawable()) {
        GTEST_SKIP() << "nothing to draw with (install python3-matplotlib python3-h5py)";
    }
    run("# a < b & \"c\"\n" + quick_campaign(), {"--set", "waves.count=3"});
    ASSERT_EQ(overturn(folder, {"report", "c.h5", "-o", "c.html"}).code, 0);
    auto const page = folder.read("c.html");
    auto const begin = page.find("<pre>\n");
    ASSERT_NE(begin, std::string::npos);
    auto text = page.substr(begin + 6, page.find("</pre>", begin) - begin - 6);
    for (auto const& [entity, letter] :
         {std::pair{"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&#x27;", "'"}, {"&amp;", "&"}}) {
        for (auto at = text.find(entity); at != std::string::npos; at = text.find(entity, at + 1)) {
            text.replace(at, std::string(entity).size(), letter);
        }
    }
    EXPECT_EQ(text, folder.read("c.toml"));
    EXPECT_EQ(page.find("<details"), std::string::npos) << "folded away, so not in print";
    EXPECT_NE(page.find("<th scope=col>pga 12\u00a0m/s2 = 2\u00a0x</th>"), std::string::npos)
        << "a number and its unit stay on one line";
}

// V_WES was not wanted, so that a history shows none and says so.
TEST_F(Page, HistoryDoesWithoutWhatWasNotWanted) {
    run(quick_campaign("[measures]\nenergy=false\n"), {"--set", "waves.count=3"});
    auto const bare = data_of({"replay", "c.h5", "--trial", "5", "--plot"}, "h.svg");
    EXPECT_FALSE(bare.contains("v_wes"));
    EXPECT_NE(said.err.find("h.svg: without V_WES (the campaign states [measures] energy = false)"), std::string::npos)
        << said.err;
    std::filesystem::remove(folder / "c.h5");
    run(quick_campaign(), {"--set", "waves.count=3"});
    EXPECT_TRUE(data_of({"replay", "c.h5", "--trial", "5", "--plot"}, "h.svg").contains("v_wes"));
    EXPECT_EQ(said.err.find("without V_WES"), std::string::npos);
}

// More bodies than histories: they are shared, and the page says of how many bodies they are.
TEST_F(Page, SharesItsHistoriesAmongBodies) {
    std::string campaign = quick_campaign();
    auto const block = campaign.find("[[bodies]]\nname='block'");
    auto const levels = campaign.find("[levels]");
    auto const body = campaign.substr(block, levels - block);
    for (int i = 0; i < 13; ++i) {
        auto further = body;
        further.replace(further.find("'block'"), 7, fmt::format("'b{}'", i));
        campaign.insert(campaign.find("[levels]"), further);
    }
    run(campaign, {"--set", "waves.count=8"});
    auto const data = data_of({"report", "c.h5", "-o"}, "c.html");
    EXPECT_EQ(data.at("histories_of"), "");
    EXPECT_EQ(data.at("histories").size(), 15U);
}

class InABrowser : public Page {
  protected:
    void SetUp() override {
        if (browser().empty() || !drawable()) {
            GTEST_SKIP() << "no browser to look with, or nothing to draw with (install chromium python3-matplotlib "
                            "python3-h5py)";
        }
    }
    /// For pages that may have nothing to draw.
    static std::string but_for_figures(std::string const& found) {
        return std::regex_replace(found, std::regex("at [0-9]+ px: no figure\n"), "");
    }
    /// For pages with a title of ten thousand letters, behind which a sheet may end early.
    static std::string but_for_sheets(std::string const& found) {
        return std::regex_replace(found, std::regex("in print: sheet [0-9]+ of [0-9]+ is filled to [0-9]+%\n"), "");
    }
    std::string faults_of_report() {
        auto const ended = overturn(folder, {"report", "c.h5", "-o", "c.html"});
        EXPECT_EQ(ended.code, 0) << ended.err;
        return faults("c.html");
    }
};

TEST_F(InABrowser, ReportIsSound) {
    run(quick_campaign("[[limits]]\nname='touches'\nquantity='peak_slip'\nabove='0.01 m'\n"),
        {"--set", "waves.count=12"});
    EXPECT_EQ(faults_of_report(), "");
}

// In space a history has its plan beside it, so that neither is small in print.
TEST_F(InABrowser, ReportOfARoundBodyIsSound) {
    folder.write("target.csv", target_csv);
    run(campaign_on_points(3));
    EXPECT_EQ(faults_of_report(), "");
    auto const page = folder.read("c.html");
    EXPECT_NE(page.find(": history of round, trial "), std::string::npos);
    EXPECT_NE(page.find(": base in plan of round, trial "), std::string::npos);
}

TEST_F(InABrowser, ReportOfAGridIsSound) {
    run("title='grid'\nseed=1\n[waves]\nsource='harmonic'\namplitude=1\nfrequencies=[0.5, 1, 2]\ncycles=6\n"
        "[[bodies]]\nname='block'\nmass='1 t'\nbase_width=0.4\ncentre_height=1\ninertia='uniform-block'\n"
        "[levels]\nmeasure='pga'\nvalues=['300 gal', '600 gal']\n");
    EXPECT_EQ(faults_of_report(), "");
    // Where no script runs, or its library is missing, the page is whole.
    auto page = folder.read("c.html");
    if (auto const begin = page.rfind("<script>"); begin != std::string::npos) {
        page.erase(begin, page.find("</script>", begin) + 9 - begin);
        folder.write("c.html", page);
    }
    EXPECT_EQ(faults("c.html"), "");
}

// R-1106: names and titles are text, whatever they hold; a script among them would speak on the console.
TEST_F(InABrowser, WordsOfTheCampaignAreNoScript) {
    std::string const script =
        "</title></pre></svg><script>console.error(1)</script><img src=x onerror=console.error(2)>";
    auto campaign = quick_campaign();
    auto const put = [&](std::string const& from, std::string const& to) {
        ASSERT_NE(campaign.find(from), std::string::npos) << from;
        campaign.replace(campaign.find(from), from.size(), to);
    };
    put("title='quick'", "title='" + script + "\u202E\"&amp;" + std::string(10'000, 'w') + "'");
    put("name='block'", "name='" + script.substr(script.find("<img")) + "'");
    put("friction=0.5", "friction={value=0.5, basis='assumed', source='" + script + "', range=[0.4, 0.6]}");
    run(campaign, {"--set", "waves.count=8"});
    EXPECT_EQ(but_for_sheets(faults_of_report()), "");
    for (auto const& study : {std::vector<std::string>{"--waves", "1"}, {"--sensitivity"}}) {
        auto const ended =
            overturn(folder, joined({"cost", "c.toml", "--set", "waves.count=16", "--html", "p.html"}, study));
        ASSERT_EQ(ended.code, 0) << ended.err;
        EXPECT_EQ(but_for_figures(faults("p.html")), "") << study.front();
    }
    // a folder may be named as it likes too
    std::filesystem::create_directory(folder / "<img src=x onerror=console.error(3)>\n<b>");
    ASSERT_EQ(overturn(folder, {"qualify", "<img src=x onerror=console.error(3)>\n<b>", "--html", "q.html"}).code, 0);
    EXPECT_EQ(but_for_figures(faults("q.html")), "");
    EXPECT_EQ(folder.read("q.html").find("<img"), std::string::npos);
}

TEST_F(InABrowser, CostPageIsSound) {
    folder.write("target.csv", target_csv);
    folder.write("c.toml", small_campaign("shared", 4));
    ASSERT_EQ(overturn(folder, {"cost", "c.toml", "--waves", "1", "--html", "p.html"}).code, 0);
    EXPECT_EQ(faults("p.html"), "");
}

// The looking itself sees what it must: one page with every fault.
TEST_F(InABrowser, FaultsAreSeen) {
    folder.write(
        "bad.html",
        "<!DOCTYPE html><body><script>console.error('oh'); undefined_name()</script>"
        "<img src='missing.png'><figure><svg aria-label='small' width='1' height='1'></svg></figure><h3>low</h3>"
        "<p style='color:#999;background:#fff'>pale</p><a href='#x'></a><p tabindex=2>forced</p><p "
        "tabindex=0>stop</p><table class=sortable>"
        "<caption>still</caption><thead><tr><th>a</th></tr></thead><tbody><tr><td>1</td></tr></tbody></table>"
        "<div style='width:99px;overflow:auto'><p style='width:999px'>box</p></div>"
        "<div style='width:2000px'>wide</div><details><summary>folded</summary><table><tr><td>1</td></tr></table>"
        "</details><div style='break-inside:avoid;height:950px'>high</div></body>");
    auto const found = faults("bad.html");
    for (auto const* fault : {"console: ",
                              "loads ",
                              "figure 'small' is 1 x 1 px",
                              "at 400 px: DIV wide reaches beyond",
                              "at 1400 px: DIV wide reaches beyond",
                              "in print: TABLE 1 is cut",
                              "at 400 px, light: no language",
                              "at 1400 px, dark: no language",
                              "no title",
                              "not one main landmark",
                              "outside of landmarks: <div style=\"width:2000px",
                              "heading skips a level: <h3>low",
                              "not one h1",
                              "table without a name: <table><tbody><tr><td>1",
                              "table without headings",
                              "heading of a table without scope: <th>a",
                              "drawing without a name: <svg",
                              "picture without a name: <img",
                              "control without a name: <a href",
                              "order of the keyboard",
                              "scrolls and does not show it: <div style=\"width:99px",
                              "in print: sheet 1 of 2 is filled to ",
                              "scrolls without keyboard: <div style=\"width:99px",
                              "stop of the keyboard without role",
                              "contrast 2.85: <p style=\"color:#999",
                              "a table does not sort: still"}) {
        EXPECT_NE(found.find(fault), std::string::npos) << fault << " not in:\n" << found;
    }
}

}  // namespace
}  // namespace overturn::testing
