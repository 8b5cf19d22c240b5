// Requirement R-904: what was accepted in silence though it was hardly meant is an error or a line that begins
// "warning", in plan and run (and where one record or body is all there is, in rock and spectrum).
#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/campaign_files.hpp"
#include "support/command.hpp"
#include "support/single_blanks.hpp"

namespace overturn::testing {
namespace {

std::string const body = "mass='12.6 t'\nbase_width='0.9 m'\ncentre_height='1.045 m'\ninertia='uniform-block'\n";

std::string replaced(std::string text, std::string const& from, std::string const& to) {
    return text.replace(text.find(from), from.size(), to);
}

std::string record(double step_s, int samples, int peak_gal = 100) {
    std::string text = "time_s,acc (gal)\n";
    for (int i = 0; i < samples; ++i) {
        text += fmt::format("{},{}\n", step_s * i, i % 2 == 0 ? 0 : i % 4 == 1 ? peak_gal : -peak_gal);
    }
    return text;
}

std::string records_campaign(std::string const& measure = "pga", std::string const& values = "'300 gal'",
                             std::string const& of_body = body) {
    return "seed=1\n[waves]\nsource='records'\nfiles=['r.csv']\n[[bodies]]\nname='b'\n" + of_body
           + "[levels]\nmeasure='" + measure + "'\nvalues=[" + values + "]\n";
}

class Warnings : public ::testing::Test {
  protected:
    Warnings() {
        folder.write("r.csv", record(0.01, 401));
        folder.write("body.toml", body);
    }

    /// What plan and run say of a campaign beginning with "warning".
    std::vector<std::string> said_of(std::string const& campaign) {
        folder.write("c.toml", campaign);
        std::filesystem::remove(folder / "c.h5");
        auto const plan = planned(folder, {"c.toml"});
        auto const run = overturn(folder, {"run", "c.toml"});
        EXPECT_EQ(plan.code, 0) << plan.err;
        EXPECT_EQ(run.code, 0) << run.err;
        return {lines_of(plan.out, "warning   "), lines_of(run.err, "warning: ")};
    }

    static std::string lines_of(std::string const& text, std::string const& beginning) {
        std::string found;
        std::istringstream lines(text);
        for (std::string line; std::getline(lines, line);) {
            found += line.starts_with(beginning) ? line + "\n" : "";
        }
        return found;
    }

    void expect_warned(std::string const& campaign, std::vector<std::string> const& parts) {
        for (auto const& all : said_of(campaign)) {
            std::string said;  // but that levels scale a record far, which such levels do
            std::istringstream lines(all);
            for (std::string line; std::getline(lines, line);) {
                said += line.find("is scaled by up to") == std::string::npos ? line + "\n" : "";
            }
            EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
            for (auto const& part : parts) {
                EXPECT_NE(said.find(part), std::string::npos) << "no '" << part << "' in: " << said;
            }
        }
    }

    void expect_refused(std::vector<std::string> const& arguments, std::vector<std::string> const& parts) {
        auto const ended = overturn(folder, arguments);
        EXPECT_EQ(ended.code, 2) << ended.err;
        std::istringstream lines(ended.err);
        for (std::string line; std::getline(lines, line);) {  // one for each fault
            EXPECT_TRUE(is_one_error_line(line + "\n")) << ended.err;
        }
        for (auto const& part : parts) {
            EXPECT_NE(ended.err.find(part), std::string::npos) << "no '" << part << "' in: " << ended.err;
        }
    }

    Folder folder;
};

TEST_F(Warnings, NoneForWhatIsUsual) {
    for (auto const& said : said_of(records_campaign())) {
        EXPECT_EQ(said, "");
    }
    folder.write("target.csv", replaced(target_csv, "0.02,2.5", "0.02,6"));  // 600 gal, as the design basis
    for (auto const& said : said_of(replaced(small_campaign("shared", 2), "longest=6", "longest=10"))) {
        EXPECT_EQ(said, "");
    }
    EXPECT_EQ(overturn(folder, {"rock", "--body", "body.toml", "--wave", "r.csv"}).err.find("warning"),
              std::string::npos);
}

TEST_F(Warnings, InertiaOfThreeKilogramSquareMetres) {
    auto const tiny = replaced(body, "'uniform-block'", "3");
    expect_warned(records_campaign("pga", "'300 gal'", tiny), {"b: inertia 3 kg m2", "radius of gyration of 0.0154 m"});
    folder.write("f.toml", records_campaign("pga", "'300 gal'", tiny + "friction=0.5\n"));
    EXPECT_NE(planned(folder, {"f.toml"}).err.find("so low because inertia 3 kg m2"), std::string::npos);
    folder.write("tiny.toml", tiny);
    EXPECT_NE(overturn(folder, {"rock", "--body", "tiny.toml", "--wave", "r.csv"}).err.find("radius of gyration"),
              std::string::npos);
}

TEST_F(Warnings, MassOf138Kilogram) {
    auto const light = "mass=138\nbase_width='3.4 m'\ncentre_height='2.6 m'\ninertia='uniform-block'\n";
    expect_warned(records_campaign("pga", "'300 gal'", light), {"b: mass 138 kg", "2.3 kg/m3", "kg, t or lb?"});
}

//
TEST_F(Warnings, CaskLooseOnItsPallet) {
    auto const stacked =
        records_campaign("pga", "'300 gal'",
                         "base_width='3.4 m'\nparts=[{kind='cylinder', mass='117 t', diameter=2.5, "
                         "height=5.4, bottom=0.35}, {kind='box', mass='21 t', width=3.4, height=0.35}]\n");
    expect_warned(stacked, {"b: part 1 tips on the part below at 0.463 g", "before the whole body tips at 0.651 g"});
    ASSERT_EQ(overturn(folder, {"report", "c.h5", "-o", "c.html"}).code, 0);
    EXPECT_NE(folder.read("c.html").find("part 1 tips on the part below at 0.463 g"), std::string::npos);
}

// the answer itself says under what its numbers hold: printed, in JSON, and on the page's first sheet.
TEST_F(Warnings, CaskLooseOnItsPalletStandsWithTheAnswer) {
    std::string const caution =
        "b: part 1 tips on the part below at 0.462 g: these numbers hold only if it is fastened.";
    auto const stacked = [](std::string const& of_cask, std::string const& level) {
        return records_campaign("pga", level,
                                "axes=1\nbase_width='3.4 m'\nparts=[{kind='cylinder', mass='117 t', diameter=2.5, "
                                "height=5.4, bottom=0.35"
                                    + of_cask + "}, {kind='box', mass='21 t', width=3.4, height=0.35}]\n");
    };
    auto const ran = [&](std::string const& of_cask, std::string const& level) {
        folder.write("c.toml", stacked(of_cask, level));
        std::filesystem::remove(folder / "c.h5");
        auto const ended = overturn(folder, {"run", "c.toml"});
        EXPECT_EQ(ended.code, 0) << ended.err;
        return ended.out;
    };
    EXPECT_NE(ran("", "'600 gal'").find("caution: " + caution + "\n"), std::string::npos);
    EXPECT_NE(overturn(folder, {"fit", "c.h5"}).out.find("caution: " + caution + "\n"), std::string::npos);
    auto const cautions = nlohmann::json::parse(overturn(folder, {"fit", "c.h5", "--json"}).out)["cautions"];
    EXPECT_EQ(cautions[0].get<std::string>() + '.', caution);
    ASSERT_EQ(overturn(folder, {"report", "c.h5", "-o", "c.html"}).code, 0);
    auto const page = folder.read("c.html");
    auto const cover = page.substr(0, page.find("class=identity"));
    EXPECT_NE(cover.find(caution), std::string::npos);
    EXPECT_EQ(ran(", fastened=true", "'600 gal'").find("tips on the part below"), std::string::npos);
    EXPECT_EQ(ran("", "'450 gal'").find("tips on the part below"), std::string::npos)
        << "0.459 g part nothing by statics";
}

// statics says nothing of parts that keep together until the whole body rocks: the answer says so, where they
// may still part. A body that slides first passes no more on than its friction.
TEST_F(Warnings, PartsThatMayMoveAsTheBodyRocksStandWithTheAnswer) {
    auto const cautioned = [&](std::string const& of_lid, std::string const& of_body, std::string const& level) {
        folder.write("c.toml", records_campaign("pga", level,
                                                "axes=1\nbase_width='3.4 m'\n" + of_body
                                                    + "parts=[{kind='box', mass='117 t', width=3.4, height=5.4}, {kind="
                                                      "'box', mass='2 t', width=2, height=0.3, bottom=5.4, "
                                                    + of_lid + "}]\n"));
        std::filesystem::remove(folder / "c.h5");
        EXPECT_EQ(overturn(folder, {"run", "c.toml"}).code, 0);
        auto const cautions = nlohmann::json::parse(overturn(folder, {"fit", "c.h5", "--json"}).out)["cautions"].dump();
        return cautions.find(
                   "whether part 2 slides on the part below as the body rocks was not checked (at rest: at "
                   "0.7 g): these numbers hold only if it is fastened")
               != std::string::npos;
    };
    EXPECT_TRUE(cautioned("friction=0.7", "", "'750 gal'")) << "the whole body rocks from 0.62 g on";
    EXPECT_FALSE(cautioned("friction=0.7", "", "'650 gal'"));
    EXPECT_FALSE(cautioned("friction=0.7", "friction=0.5\n", "'750 gal'"));
    EXPECT_FALSE(cautioned("fastened=true", "", "'750 gal'"));
}

TEST_F(Warnings, PgvOf5000Kine) {
    expect_warned(records_campaign("pgv", "50"), {"levels up to pgv 50 m/s = 5000 kine", "Write \"50 kine\""});
    expect_warned(records_campaign("pga", "300"), {"levels up to pga 300 m/s2 = 30000 gal", "Write \"300 gal\""});
}

TEST_F(Warnings, FactorsThatNoGroundHasShakenBy) {
    expect_warned(records_campaign("factor", "100"), {"wave 0 peaks at 10.2 g at the highest level, factor 100"});
    expect_warned(records_campaign("factor", "0.05"), {"wave 0 peaks at 5 gal even at the highest level"});
}

TEST_F(Warnings, ScatteredFrictionSlidesInAShareOfDraws) {
    folder.write("c.toml", records_campaign("pga", "'300 gal'",
                                            body
                                                + "friction={distribution='normal',mean=0.4306220,deviation=0.05,"
                                                  "low=0.3,high=0.561244}\n"));
    auto const plan = planned(folder, {"c.toml"}).out;
    EXPECT_NE(plan.find("tan(alpha) 0.4306: slides before it rocks in 50 % of draws"), std::string::npos) << plan;
}

TEST_F(Warnings, StepOfOneSecond) {
    folder.write("r.csv", record(1, 401, 1));
    expect_warned(records_campaign(), {"record 'r.csv': time step of 1 s", "nothing above 0.5 Hz"});
    for (auto const& verb : {std::vector<std::string>{"rock", "--body", "body.toml"}, {"spectrum"}}) {
        auto const ended = overturn(folder, joined(verb, {"--wave", "r.csv"}));
        EXPECT_NE(ended.err.find("warning: time step of 1 s"), std::string::npos) << ended.err;
    }
}

TEST_F(Warnings, TwoSamples) {
    folder.write("r.csv", "time_s,acc (gal)\n0,100\n0.01,-100\n");
    expect_warned(records_campaign(), {"record 'r.csv': 2 samples only"});
    auto const ended = overturn(folder, {"spectrum", "--wave", "r.csv"});
    EXPECT_NE(ended.err.find("warning: 2 samples only"), std::string::npos) << ended.err;
}

TEST_F(Warnings, DampingOfFiveIsFiveHundredPercent) {
    expect_refused({"spectrum", "--wave", "r.csv", "--damping", "5"}, {"--damping 5", "500 %", "0.05 for 5 %"});
    EXPECT_EQ(overturn(folder, {"spectrum", "--wave", "r.csv", "--damping", "0.3"}).code, 0);
}

// levels are printed in the unit that they were written in, and JSON has both.
TEST_F(Warnings, LevelsAreEchoedInTheUsersUnit) {
    folder.write("c.toml", records_campaign("pgv", "'20 kine', '50 kine'"));
    EXPECT_NE(planned(folder, {"c.toml"}).out.find("levels    pgv [kine]: 20, 50\n"), std::string::npos);
    auto const run = single_blanks(overturn(folder, {"run", "c.toml", "--full"}).out);
    EXPECT_NE(run.find("\npgv kine trials "), std::string::npos) << run;
    EXPECT_NE(run.find("\n 50 1 "), std::string::npos) << run;
    auto const fit = nlohmann::json::parse(overturn(folder, {"fit", "c.h5", "--json"}).out);
    EXPECT_EQ(fit["stripes"][1]["amplitude"], 0.5);
    EXPECT_EQ(fit["levels"]["stated_unit"], "kine");
    EXPECT_EQ(fit["levels"]["stated"], nlohmann::json::array({20, 50}));
    EXPECT_NE(overturn(folder, {"replay", "c.h5", "--trial", "1"}).out.find("pgv 50 kine"), std::string::npos);
}

// an error names what else is wrong on the way: unknown keys beside the missing one, the choices there
// are.
TEST_F(Warnings, ErrorsNameWhatElseIsWrong) {
    auto const refuse = [&](std::string const& campaign, std::vector<std::string> const& parts) {
        folder.write("bad.toml", campaign);
        expect_refused({"plan", "bad.toml"}, parts);
    };
    auto const good = records_campaign();
    refuse(replaced(good, "base_width", "width"), {"base_width: missing", "'width' is no key here"});
    refuse(replaced(good, "[[bodies]]", "[body]"), {"bodies: missing", "'body'"});
    refuse(replaced(good, "'uniform-block'", "'solid'"), {"bodies[0].inertia: 'solid'", "\"uniform-block\""});
    refuse(replaced(good, "inertia='uniform-block'\n", ""), {"inertia: missing", "\"uniform-block\""});
    refuse(replaced(good, "measure='pga'\n", ""), {"levels.measure: missing", "State one of: pga, pgv, pgd"});
    refuse(replaced(good, "source='records'\n", ""), {"waves.source: missing", "spectrum-compatible, "});
    refuse(replaced(good, "files=", "count='4'\nfiles="), {"waves.count: a text, '4'", "without quotes"});
    refuse(replaced(good, "files=", "count='abc'\nfiles="), {"waves.count: a text, 'abc'", "Write one, such as 10"});
    refuse(replaced(good, "files=", "count=1.5\nfiles="), {"waves.count: a number", "without a point"});
    refuse(replaced(good, "files=['r.csv']", "files=['r.csv']\nunit='g'"),
           {"unit gal in the file, g stated", "[[waves.records]] of its own"});
    refuse(
        replaced(small_campaign(), "kind='acceleration'\n", ""),
        {"waves.target.kind: missing", "State one of: acceleration, pseudo-velocity, displacement, energy-velocity"});
    refuse(good + "[[bodies]]\nname='c'\nbase_width=1\nmass=1\nparts=[{kind='box',mass=1000,width=1,height=1}]\n",
           {"key 'bodies[1].mass'", "only if there is no file and no parts"});
    refuse(good + "[[bodies]]\nname='c'\nbase_width=1\nparts=[{kind='box',mass=1000,width=1,height=1,diameter=1}]\n",
           {"key 'bodies[1].parts[0].diameter'", "only if kind = cylinder"});
}

// where a value may be drawn, what is no value shows how a band is written, with the ends that were.
TEST_F(Warnings, ErrorsShowHowABandIsWritten) {
    auto const refuse = [&](std::string const& stated, std::vector<std::string> const& parts) {
        folder.write("bad.toml",
                     replaced(records_campaign(), "inertia='uniform-block'", "inertia='uniform-block'\n" + stated));
        expect_refused({"plan", "bad.toml"}, parts);
    };
    refuse("friction=[0.3, 0.7]", {"bodies[0].friction: a list (must be one value or a band)",
                                   "A band is { distribution = \"uniform\", low = 0.3, high = 0.7 }"});
    refuse("friction={low=0.2, high=0.4}",
           {"bodies[0].friction.distribution: missing", "{ distribution = \"uniform\", low = 0.2, high = 0.4 }"});
    refuse("friction={static={low=0.2, high=0.4}, kinetic_ratio=1}",
           {"bodies[0].friction.static.distribution: missing", "low = 0.2, high = 0.4 }"});
    refuse("friction={kinetic=0.2}", {"bodies[0].friction.static: missing"});
    refuse("friction=true",
           {"bodies[0].friction: true or false", "{distribution = ...} or {static = ...}). Write one"});
}

//
TEST_F(Warnings, UnfinishedRunsAndResultsFilesAreNamed) {
    folder.write("target.csv", target_csv);
    folder.write("c.toml", small_campaign());
    ASSERT_EQ(overturn(folder, {"run", "c.toml", "--max-walltime", "0.01 s"}).code, 3);
    expect_refused({"fit", "c.h5"}, {"c.h5: not there yet", "overturn status c.h5", "--resume"});
    expect_refused({"fit", "d.h5"}, {"d.h5: no such file"});
    ASSERT_EQ(overturn(folder, {"run", "c.toml", "--resume", "--max-walltime", "01:00:00"}).code, 0);
    expect_refused({"run", "c.h5"}, {"c.h5: a results file", "Name the campaign"});
}

// R-1102.
TEST_F(Warnings, WalltimeAsSlurmSpellsIt) {
    folder.write("c.toml", records_campaign());
    for (char const* time : {"01:00:00", "1-00:00:00", "2-12", "1-12:30", "10:00", "1h", "90min", "50 min", "3600"}) {
        EXPECT_EQ(overturn(folder, {"run", "c.toml", "--max-walltime", time, "-o", std::string(time) + ".h5"}).code, 0)
            << time;
    }
    for (char const* time : {"1:2:3:4", "00:00:00", "1:x", "-1:00", "1-", "h"}) {
        expect_refused({"run", "c.toml", "--max-walltime", time, "-o", "bad.h5"}, {"--max-walltime"});
    }
}

// where output and notes go into one file, lines keep their order.
TEST_F(Warnings, NotesComeBehindWhatWasPrintedBefore) {
    folder.write("c.toml", records_campaign());
    auto const ended =
        execute(folder, {"/bin/sh", "-c", std::string(OVERTURN_PROGRAM) + " run c.toml > both 2>&1; cat both"});
    auto const results = ended.out.find("results: c.h5");
    auto const cost = ended.out.find("cost: ");
    ASSERT_NE(results, std::string::npos) << ended.out;
    ASSERT_NE(cost, std::string::npos) << ended.out;
    EXPECT_LT(results, cost) << ended.out;
}

}  // namespace
}  // namespace overturn::testing
