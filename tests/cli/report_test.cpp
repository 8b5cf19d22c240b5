// Requirement R-905: a results file becomes one page that needs no network, with figures and tables as files if wanted.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/campaign_files.hpp"
#include "support/command.hpp"
#include "support/csv_of_json.hpp"

namespace overturn::testing {
namespace {

class Report : public ::testing::Test {
  protected:
    static void SetUpTestSuite() {
        ::unsetenv("OVERTURN_PYTHON");
        folder = new Folder;
        folder->write("target.csv", target_csv);
        folder->write("c.toml", small_campaign("shared", 6));
        ASSERT_EQ(overturn(*folder, {"run", "c.toml", "-o", "c.h5"}).code, 0);
        drawable = execute(*folder, {OVERTURN_PYTHON, "-c", "import matplotlib, h5py"}).code == 0;
    }
    static void TearDownTestSuite() {
        delete folder;
        folder = nullptr;
    }
    void TearDown() override { ::unsetenv("OVERTURN_PYTHON"); }

    static void skip_without_packages() {
        if (!drawable) {
            GTEST_SKIP() << "nothing to draw with (install python3-matplotlib python3-h5py)";
        }
    }
    static bool there(std::string const& name) { return std::filesystem::exists(*folder / name); }

    static inline Folder* folder = nullptr;
    static inline bool drawable = false;
};

TEST_F(Report, IsOnePageThatNeedsNoNetwork) {
    skip_without_packages();
    if (IsSkipped()) {
        return;
    }
    auto const ended = overturn(*folder, {"report", "c.h5", "-o", "a.html"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    auto const page = folder->read("a.html");
    for (auto const* section : {"asked", "inputs", "bodies", "waves", "method", "assumptions", "answers", "fragility",
                                "criterion", "checks", "trials", "campaign", "provenance"}) {
        EXPECT_NE(page.find(std::string("<section id=\"") + section), std::string::npos) << section;
    }
    EXPECT_NE(page.find("<svg"), std::string::npos);
    // by what the waves differ stands right behind the fits, before any other table.
    auto const fits = page.find("<th scope=col>HCLPF</th>", page.find("<section id=\"fragility\">"));
    auto const differ = page.find("Variability of the waves: random phases only", fits);
    ASSERT_NE(fits, std::string::npos);
    EXPECT_LT(differ, page.find("<table ", fits)) << "of the next table";
    // Texts begin at the left, numbers end at the right. The last sheet of a print is more than one short table.
    EXPECT_NE(page.find("<th scope=col class=text>remark</th>"), std::string::npos);
    EXPECT_NE(page.find("<th scope=col>amplitude</th>"), std::string::npos);
    EXPECT_LT(page.find("<section id=\"provenance\">"), page.find("<section id=\"campaign\">"));
    // Addresses name the svg's language, nothing to be fetched.
    for (auto const* fetched : {"src=\"http", "href=\"http", "@import", "<script src", "url(http"}) {
        EXPECT_EQ(page.find(fetched), std::string::npos) << fetched;
    }
}

// Its sentences are the program's, in one place with those of the terminal.
TEST_F(Report, HoldsNoSentenceOfItsOwn) {
    auto const sentences_in = [](std::string const& place) {
        auto const ended = execute(*folder, {OVERTURN_PYTHON, "-B", OVERTURN_SENTENCES_SCRIPT, place});
        EXPECT_EQ(ended.code, 0) << ended.err;
        return ended.out;
    };
    EXPECT_EQ(sentences_in(OVERTURN_PACKAGE "/overturn/report"), "");
    folder->write("wrong_sections.py",
                  "\"Documentation of more than six words may stand in it.\"\n"
                  "head = 'one body'\n"
                  "note = f'the page alone says what {head} did under all waves'\n");
    for (auto const* name : {"campaign_page.py", "grid_map.py", "page_parts.py"}) {
        folder->write(name, "");
    }
    EXPECT_EQ(sentences_in("."), "wrong_sections.py:3: the page alone says what   did under all waves\n");
}

TEST_F(Report, IsTheSameForTheSameFileButForItsCost) {
    skip_without_packages();
    if (IsSkipped()) {
        return;
    }
    ASSERT_EQ(overturn(*folder, {"report", "c.h5", "-o", "a.html"}).code, 0);
    ASSERT_EQ(overturn(*folder, {"report", "c.h5", "-o", "b.html"}).code, 0);
    EXPECT_EQ(folder->read("a.html"), folder->read("b.html"));
}

// what was not wanted is missing from every answer, and breaks none.
TEST_F(Report, DoesWithoutWhatWasNotMeasured) {
    auto const ran = overturn(*folder, {"run", "c.toml", "-o", "bare.h5", "--set", "measures.energy=false", "--set",
                                        "measures.wave_quality=false"});
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(ran.out.find("V_WES"), std::string::npos) << ran.out;
    EXPECT_EQ(ran.out.find("criterion"), std::string::npos) << ran.out;
    for (std::vector<std::string> const& command :
         {std::vector<std::string>{"status", "bare.h5"}, {"fit", "bare.h5"}, {"replay", "bare.h5", "--trial", "3"}}) {
        auto const ended = overturn(*folder, command);
        EXPECT_EQ(ended.code, 0) << command.front() << ended.out << ended.err;
    }
    auto const fitted = nlohmann::json::parse(overturn(*folder, {"fit", "bare.h5", "--json"}).out);
    EXPECT_TRUE(fitted.at("criterion").empty());
    EXPECT_FALSE(fitted.at("stripes").empty());
    if (drawable) {
        auto const ended = overturn(*folder, {"report", "bare.h5", "-o", "bare.html"});
        ASSERT_EQ(ended.code, 0) << ended.err;
        auto const page = folder->read("bare.html");
        EXPECT_EQ(page.find("<section id=\"criterion"), std::string::npos);
        EXPECT_EQ(page.find("<section id=\"limits\""), std::string::npos) << "it has no limit state of its own";
        EXPECT_NE(page.find("<section id=\"fragility"), std::string::npos);
    }
    EXPECT_EQ(overturn(*folder, {"cost", "c.toml", "--waves", "2", "--set", "measures.energy=false", "--set",
                                 "measures.wave_quality=false"})
                  .code,
              0);
}

TEST_F(Report, WritesFiguresAndTablesBesideIt) {
    skip_without_packages();
    if (IsSkipped()) {
        return;
    }
    auto const ended = overturn(*folder, {"report", "c.h5", "-o", "c.html", "--figures", "some figures/here"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    for (auto const* name : {"bodies", "fragility", "wave-0"}) {
        EXPECT_TRUE(there(std::string("some figures/here/") + name + ".svg")) << name;
        EXPECT_TRUE(there(std::string("some figures/here/") + name + ".png")) << name;
    }
    auto const fitted = nlohmann::ordered_json::parse(overturn(*folder, {"fit", "c.h5", "--json"}).out);
    for (auto const* name : {"stripes", "criterion", "telling_trials"}) {
        expect_rows(folder->read(fmt::format("some figures/here/{}.csv", name)),
                    fitted.at(name).get<std::vector<nlohmann::ordered_json>>());
    }
    EXPECT_TRUE(there("some figures/here/fragility.csv"));
}

// with a hazard curve the page states annual frequencies, those of `fit`, the interval first.
TEST_F(Report, ShowsAnnualFrequenciesByAHazardCurve) {
    skip_without_packages();
    if (IsSkipped()) {
        return;
    }
    folder->write("hz.csv", "pga [gal], annual_exceedance\n100,1e-2\n300,1e-3\n600,1e-4\n1200,1e-5\n2000,1e-6\n");
    auto const ended = overturn(
        *folder, {"report", "c.h5", "-o", "f.html", "--hazard", "hz.csv", "--beta-u", "0.3", "--figures", "f"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    auto const fitted = nlohmann::ordered_json::parse(
        overturn(*folder, {"fit", "c.h5", "--hazard", "hz.csv", "--beta-u", "0.3", "--json"}).out);
    expect_rows(folder->read("f/frequency.csv"), fitted.at("frequency").get<std::vector<nlohmann::ordered_json>>());
    auto const page = folder->read("f.html");
    EXPECT_NE(page.find("<section id=\"frequency\">"), std::string::npos);
    EXPECT_LT(page.find(" times a year (95 %: "), page.find("<nav>")) << "a headline";
    // It has a row of its own, and the columns of all levels: no number is broken.
    auto const row = page.find(">annual frequency</td><td class=short colspan=");
    EXPECT_LT(row, page.find("<nav>"));
    EXPECT_NE(page.substr(row, page.find("</tr>", row) - row).find(" a year"), std::string::npos);
    auto const table = page.substr(page.find("<section id=\"frequency\">"));
    bool const is_bounded = std::ranges::any_of(
        fitted.at("frequency"), [](auto const& row) { return !row.at("fractile_95_most_per_year").is_null(); });
    EXPECT_EQ(table.find(" (≤ ") != std::string::npos, is_bounded) << "the upper end at 95 % confidence";
    EXPECT_NE(page.find("lowest to highest"), std::string::npos);
    EXPECT_NE(page.find("hz.csv: 5 points from 100 gal (0.01 1/a) to 2000 gal (1e-06 1/a)"), std::string::npos);
    auto const without = overturn(*folder, {"report", "c.h5", "-o", "g.html"});
    ASSERT_EQ(without.code, 0) << without.err;
    EXPECT_EQ(folder->read("g.html").find("times a year"), std::string::npos);
}

// how many waves a percentile needs is the program's rule: of six there is a median, and no 84 or 95 %.
TEST_F(Report, GivesNoPercentileOfFewWaves) {
    skip_without_packages();
    if (IsSkipped()) {
        return;
    }
    auto const cells_of = [](std::string const& file, char const* waves) {
        auto const ran =
            overturn(*folder, {"run", "c.toml", "-o", file + ".h5", "--set", std::string("waves.count=") + waves,
                               "--set", "levels.values=['600 gal']", "--set", "levels.design_basis='600 gal'"});
        EXPECT_EQ(ran.code, 0) << ran.err;
        EXPECT_EQ(overturn(*folder, {"report", file + ".h5", "-o", file + ".html"}).code, 0);
        auto const page = folder->read(file + ".html");
        auto const section = page.find("<section id=\"responses\">");
        auto const row = page.find("<tbody>", section);
        EXPECT_NE(section, std::string::npos);
        std::vector<std::string> cells;
        for (auto at = row; cells.size() < 4;) {
            at = page.find('>', page.find("<td", at)) + 1;
            cells.push_back(page.substr(at, page.find('<', at) - at));
        }
        return cells;
    };
    auto const six = cells_of("six", "6");
    EXPECT_NE(six[1].substr(0, 3), "–") << "the median";
    EXPECT_EQ(six[2].substr(0, 3), "–") << "84 %, which needs seven";
    EXPECT_EQ(six[3].substr(0, 3), "–") << "95 %, which needs twenty";
    auto const seven = cells_of("seven", "7");
    EXPECT_NE(seven[2].substr(0, 3), "–");
    EXPECT_EQ(seven[3].substr(0, 3), "–");
}

// of HCLPF and the 5 % point the safe end comes first, in the table and in words, and no estimate stands alone.
TEST_F(Report, GivesTheSafeEndOfLowPointsFirst) {
    skip_without_packages();
    if (IsSkipped()) {
        return;
    }
    auto const ran = overturn(*folder, {"run", "c.toml", "-o", "many.h5", "--set", "waves.count=40", "--set",
                                        "levels.values=['500 gal','600 gal','700 gal','800 gal','900 gal']"});
    ASSERT_EQ(ran.code, 0) << ran.err;
    auto const ended = overturn(*folder, {"report", "many.h5", "-o", "many.html", "--beta-u", "0.3"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    auto const fitted = nlohmann::json::parse(overturn(*folder, {"fit", "many.h5", "--beta-u", "0.3", "--json"}).out);
    // In JSON too, table by table.
    auto const ordered =
        nlohmann::ordered_json::parse(overturn(*folder, {"fit", "many.h5", "--beta-u", "0.3", "--json"}).out);
    for (auto const* table : {"answer", "fragility"}) {
        auto const row = ordered.at(table).at(0).dump();
        EXPECT_LT(row.find("\"hclpf_lower\""), row.find("\"hclpf\"")) << table;
    }
    auto const page = folder->read("many.html");
    auto const gal = [](nlohmann::json const& mps2) {
        return fmt::format("{:g} gal", std::floor(100 * mps2.get<double>()));
    };
    int told = 0;
    for (auto const& row : fitted.at("fragility")) {
        if (row.at("measure") != "pga" || row.at("hclpf").is_null()) {
            continue;
        }
        for (std::string const point : {"five_percent_point", "hclpf"}) {
            auto const text = fmt::format("&gt;= {} (estimate {})", gal(row.at(point + "_lower")), gal(row.at(point)));
            auto const words = page.find(text, page.find("<section id=\"answers\">"));
            EXPECT_LT(words, page.find("<section id=\"fragility\">")) << text;
            EXPECT_NE(page.find("<td>" + text + "</td>", words), std::string::npos) << text;
            ++told;
        }
    }
    EXPECT_GE(told, 2);
    // So does the calculation by hand beside the simulated median.
    auto const four_digits_gal = [](nlohmann::json const& mps2) {
        return fmt::format("{:g} gal", std::floor(1000 * mps2.get<double>()) / 10);
    };
    int checked = 0;
    for (auto const& row : fitted.at("hand_check")) {
        if (!row.at("simulated_median").is_null() && row.at("overturning_level") < 10) {
            auto const cells =
                fmt::format("<td class=short>{}</td><td class=short>{}</td>",
                            four_digits_gal(row.at("overturning_level")), four_digits_gal(row.at("simulated_median")));
            EXPECT_NE(page.find(cells), std::string::npos) << cells;
            ++checked;
        }
    }
    EXPECT_GE(checked, 1);
}

// what `fit` refuses of a hazard curve the page refuses, before any of it is drawn.
TEST_F(Report, RefusesAHazardCurveOfAnotherMeasureOrRange) {
    folder->write("sa.csv", "sa(1 s) [g], annual_exceedance\n0.1,1e-2\n1,1e-4\n");
    folder->write("far.csv", "pga [gal], annual_exceedance\n0.1,1e-2\n1,1e-4\n");
    for (auto const* name : {"sa.csv", "far.csv"}) {
        auto const ended = overturn(*folder, {"report", "c.h5", "-o", "h.html", "--hazard", name});
        EXPECT_EQ(ended.code, 2) << name << ended.err;
        EXPECT_TRUE(is_one_error_line(ended.err)) << ended.err;
        EXPECT_FALSE(there("h.html"));
    }
}

/// Names are drawn as they stand, whatever they would mean to a typesetter or a legend.
TEST_F(Report, DrawsAnyName) {
    skip_without_packages();
    if (IsSkipped()) {
        return;
    }
    auto text = small_campaign("shared", 2);
    text.replace(text.find("name='type-a'"), 13, "name='x$\\foo$'");
    text.replace(text.find("name='type-b'"), 13, "name='_<b>&\"y'");
    folder->write("odd.toml", text);
    ASSERT_EQ(overturn(*folder, {"run", "odd.toml", "-o", "odd.h5"}).code, 0);
    auto const ended =
        overturn(*folder, {"report", "odd.h5", "-o", "odd.html", "--beta-u", "0.2", "--confidence", "0.9"});
    EXPECT_EQ(ended.code, 0) << ended.err;
    auto const page = folder->read("odd.html");
    EXPECT_NE(page.find("x$\\foo$"), std::string::npos);
    EXPECT_NE(page.find("beta_U as stated"), std::string::npos);
    EXPECT_NE(page.find("90 %"), std::string::npos);
}

// trials to inspect are listed with their numbers by fit and on the page, and replay finds them by these.
TEST_F(Report, ShowsTrialsToInspect) {
    auto const text = overturn(*folder, {"fit", "c.h5", "--section", "trials"}).out;
    EXPECT_NE(text.find("trials to inspect (overturn replay c.h5 --trial N)"), std::string::npos) << text;
    auto const told = nlohmann::json::parse(overturn(*folder, {"fit", "c.h5", "--json"}).out).at("telling_trials");
    ASSERT_FALSE(told.empty());
    std::set<std::string> kinds;
    for (auto const& t : told) {
        kinds.insert(t.at("kind"));
        auto const again = overturn(*folder, {"replay", "c.h5", "--trial", std::to_string(t.at("trial").get<int>())});
        EXPECT_NE(again.out.find("verdict " + t.at("verdict").get<std::string>()), std::string::npos) << again.out;
        EXPECT_NE(again.out.find("body " + t.at("body").get<std::string>() + ","), std::string::npos) << again.out;
        EXPECT_NE(again.out.find(fmt::format("({:.4f} alpha)", t.at("peak_rotation_ratio").get<double>())),
                  std::string::npos)
            << again.out;
    }
    EXPECT_TRUE(kinds.contains("first-overturned"));
    EXPECT_TRUE(kinds.contains("nearest-miss"));
    EXPECT_TRUE(kinds.contains("largest-slip"));
}

TEST_F(Report, StatesWhatToInstallWherePythonIsMissing) {
    ::setenv("OVERTURN_PYTHON", "/nonexistent/python3", 1);
    auto const ended = overturn(*folder, {"report", "c.h5", "-o", "d.html"});
    EXPECT_EQ(ended.code, 1);
    EXPECT_NE(ended.err.find("apt-get install python3 python3-matplotlib python3-h5py"), std::string::npos)
        << ended.err;
    EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
    EXPECT_FALSE(there("d.html"));
}

TEST_F(Report, RefusesAnotherNameOrFile) {
    auto const name = overturn(*folder, {"report", "c.h5", "-o", "d.pdf"});
    EXPECT_EQ(name.code, 2);
    EXPECT_NE(name.err.find("End it in .html"), std::string::npos) << name.err;
    auto const file = overturn(*folder, {"report", "c.toml", "-o", "d.html"});
    EXPECT_EQ(file.code, 2);
    EXPECT_EQ(overturn(*folder, {"report", "c.h5", "-o", "nowhere/d.html"}).code, 2);
    auto const figures = overturn(*folder, {"report", "c.h5", "-o", "d.html", "--figures", "c.toml"});
    EXPECT_EQ(figures.code, 2);
    EXPECT_TRUE(is_one_error_line(figures.err));
}

}  // namespace
}  // namespace overturn::testing
