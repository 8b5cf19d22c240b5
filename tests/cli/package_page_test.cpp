// Requirement R-921: a campaign's page stands as a calculation package: who, what question, which program and file,
// which checks were made of it and which were not.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/campaign_files.hpp"
#include "support/command.hpp"

namespace overturn::testing {
namespace {

using nlohmann::json;

constexpr char const* cover = "prepared='A, engineer'\nchecked='B <checker>'\nrevision='2'\n";

std::vector<std::vector<std::string>> cells_of(std::string const& csv) {
    std::vector<std::vector<std::string>> rows;
    std::istringstream lines(csv);
    for (std::string line; std::getline(lines, line);) {
        rows.emplace_back();
        std::istringstream cells(line);
        for (std::string cell; std::getline(cells, cell, ',');) {
            rows.back().push_back(cell);
        }
    }
    return rows;
}

class CalculationPackage : public ::testing::Test {
  protected:
    static void SetUpTestSuite() {
        folder = new Folder;
        folder->write("target.csv", target_csv);
        folder->write("c.toml", cover + small_campaign("shared", 6));
        ASSERT_EQ(overturn(*folder, {"run", "c.toml", "-o", "c.h5"}).code, 0);
        folder->write("v.json", overturn(*folder, {"verify", "c.h5", "--json", "--date", "1 May"}).out);
        folder->write("interpreter", "#!/bin/sh\ncp \"$4\" \"$5\"\n");
        std::filesystem::permissions(*folder / "interpreter", std::filesystem::perms::owner_all);
    }
    static void TearDownTestSuite() {
        delete folder;
        folder = nullptr;
    }
    void SetUp() override { ::setenv("OVERTURN_PYTHON", (*folder / "interpreter").c_str(), 1); }
    void TearDown() override { ::unsetenv("OVERTURN_PYTHON"); }

    static Ended report(std::vector<std::string> const& more) {
        return overturn(*folder, joined({"report", "c.h5", "-o", "p.html"}, more));
    }
    /// What a page would be made of.
    static json data_of(std::vector<std::string> const& more = {}) {
        auto const ended = report(more);
        EXPECT_EQ(ended.code, 0) << ended.err;
        return json::parse(folder->read("p.html"));
    }
    static json checks(std::vector<std::string> const& more) { return data_of(more).at("checks"); }
    /// A record of qualify with one failed check; of published results with one that is known to differ.
    static void write_qualification(std::string const& name, bool published) {
        json const record = {{"published", published},
                             {"program", "0.0.1"},
                             {"machine", "abacus"},
                             {"passed", published},
                             {"summary", published ? "1 check passes, 1 differs: M-02" : "1 of 2 checks FAIL: M-02"}};
        folder->write(name, record.dump());
    }

    static inline Folder* folder = nullptr;
};

TEST_F(CalculationPackage, CoverBearsWhatIsStatedAndNoMore) {
    auto const plain = data_of().at("cover");
    EXPECT_EQ(
        plain.at("question"),
        "How likely is each of the bodies type-a and type-b to overturn at the design basis (pga 600 gal) and beyond?");
    EXPECT_EQ(plain.at("date"), "");
    EXPECT_EQ(plain.at("revision"), "2");
    EXPECT_EQ(plain.at("signatures"),
              json::parse(R"([["prepared", "A, engineer"], ["checked", "B <checker>"], ["approved", ""]])"));
    EXPECT_EQ(data_of({"--date", "27 Nov"}).at("cover").at("date"), "27 Nov");

    folder->write("asked.toml", "question='Why?'\n" + small_campaign("shared", 2));
    ASSERT_EQ(overturn(*folder, {"run", "asked.toml", "-o", "asked.h5"}).code, 0);
    ASSERT_EQ(overturn(*folder, {"report", "asked.h5", "-o", "p.html"}).code, 0);
    EXPECT_EQ(json::parse(folder->read("p.html")).at("cover").at("question"), "Why?");
}

// R-901: figures and tables of the page are in the units of the campaign.
TEST_F(CalculationPackage, IsInTheUnitsOfTheCampaign) {
    auto const units = data_of().at("units");
    EXPECT_EQ(units.at("mass").at("symbol"), "t");
    EXPECT_EQ(units.at("length").at("symbol"), "m");
    EXPECT_EQ(units.at("slip").at("symbol"), "mm");
    EXPECT_EQ(units.at("acceleration").at("symbol"), "gal");
    EXPECT_EQ(units.at("acceleration").at("si"), 0.01);
    EXPECT_EQ(units.at("velocity").at("symbol"), "m/s");
    EXPECT_EQ(data_of({"--velocities", "kine"}).at("units").at("velocity").at("symbol"), "kine");
}

TEST_F(CalculationPackage, ChecksWithoutARecordAreNotRun) {
    auto const rows = checks({});
    ASSERT_EQ(rows.size(), 5U);
    for (auto const& row : rows) {
        EXPECT_EQ(row.at("result"), "not run") << row;
        EXPECT_TRUE(row.at("record").get<std::string>().starts_with("overturn ")) << row;
    }
    EXPECT_EQ(rows[0].at("record"), "overturn verify c.h5 --json");
}

TEST_F(CalculationPackage, RecordsAreListedWithWhatTheySay) {
    write_qualification("q.json", false);
    write_qualification("l.json", true);
    auto const rows = checks({"--record", "v.json", "--record", "q.json", "--record", "l.json"});
    EXPECT_EQ(rows[0].at("result"), "36 trials and 6 waves recomputed: all bit-equal");
    EXPECT_FALSE(rows[0].at("failed"));
    auto const verified = rows[0].at("record").get<std::string>();
    EXPECT_TRUE(verified.ends_with(", 1 May")) << verified;
    EXPECT_EQ(verified.find("not the program"), std::string::npos) << verified;
    EXPECT_EQ(rows[1].at("result"), "1 of 2 checks FAIL: M-02");
    EXPECT_TRUE(rows[1].at("failed"));
    EXPECT_EQ(rows[1].at("record"), "overturn 0.0.1 (not the program of the results), abacus");
    EXPECT_EQ(rows[2].at("result"), "1 check passes, 1 differs: M-02");
    EXPECT_EQ(rows[3].at("result"), "not run");
}

TEST_F(CalculationPackage, AVerificationThatFailsIsReported) {
    auto record = json::parse(folder->read("v.json"));
    record["passed"] = false;
    record["differing_trials"] = 3;
    record["first"] = "trial 7";
    folder->write("bad.json", record.dump());
    auto const row = checks({"--record", "bad.json"})[0];
    EXPECT_TRUE(row.at("failed"));
    EXPECT_EQ(row.at("result"), "36 trials and 6 waves recomputed: 3 trials and 0 waves DIFFER, first trial 7");

    auto const sample = overturn(*folder, {"verify", "c.h5", "--sample", "1", "--json"}).out;
    folder->write("sample.json", sample);
    EXPECT_EQ(checks({"--record", "sample.json"})[0].at("result"),
              "1 of 36 trials and 1 of 6 waves recomputed, drawn at random: all bit-equal");
}

// R-902: what is no record of this file is refused by name.
TEST_F(CalculationPackage, RefusesRecordsThatAreNotOfIt) {
    auto other = json::parse(folder->read("v.json"));
    other["sha256"] = std::string(64, '0');
    folder->write("other.json", other.dump());
    folder->write("text.json", "no JSON");
    folder->write("cut.json", "{\"summary\": \"all pass\", \"published\": false}");
    for (auto const& [names, why] : {std::pair{std::vector<std::string>{"other.json"}, "of another results file"},
                                     {{"text.json"}, "no record of a check"},
                                     {{"cut.json"}, "not as this program writes it"},
                                     {{"missing.json"}, "missing.json"},
                                     {{"v.json", "v.json"}, "two records of one check"}}) {
        std::vector<std::string> more;
        for (auto const& name : names) {
            more.insert(more.end(), {"--record", name});
        }
        auto const ended = report(more);
        EXPECT_EQ(ended.code, 2) << names.front();
        EXPECT_NE(ended.err.find(why), std::string::npos) << ended.err;
    }
}

// R-904: cost and its sensitivity are checks too; the assumed values get a section.
TEST_F(CalculationPackage, StudiesOfCostAreListed) {
    auto const campaign = [](std::string const& levels) {
        return std::string(cover)
               + "seed=3\n[waves]\nsource='filtered-noise'\nmodel='kanai-tajimi'\nrms='1 m/s2'\ncount=12\n"
                        "duration='8 s'\ntime_step='0.02 s'\n[waves.envelope]\nshape='constant'\n[[bodies]]\nname='block'\n"
                        "mass='1 t'\nbase_width={value=0.4, basis='assumed', range=[0.2, 0.6]}\ncentre_height='0.8 m'\n"
                        "inertia='uniform-block'\n[levels]\nmeasure='pga'\ndesign_basis='6 m/s2'\nvalues=" + levels + "\n";
    };
    folder->write("assumed.toml", campaign("{from='2 m/s2', to='16 m/s2', count=15}"));
    folder->write("coarse.toml", campaign("['3 m/s2', '6 m/s2', '9 m/s2', '12 m/s2']"));
    auto const cost = [](std::vector<std::string> const& more, char const* name = "assumed.toml") {
        auto const ended = overturn(*folder, joined({"cost", name, "--json"}, more));
        EXPECT_EQ(ended.code, 0) << ended.err;
        return ended.out;
    };
    folder->write("cost.json", cost({"--waves", "1"}));
    folder->write("moved.json", cost({"--sensitivity"}));
    auto const other = report({"--record", "cost.json"});
    EXPECT_EQ(other.code, 2);
    EXPECT_NE(other.err.find("of another campaign than c.h5 is of"), std::string::npos) << other.err;
    ASSERT_EQ(overturn(*folder, {"run", "assumed.toml", "-o", "assumed.h5"}).code, 0);
    auto const of_it =
        overturn(*folder, {"report", "assumed.h5", "-o", "p.html", "--record", "moved.json", "--record", "cost.json"});
    ASSERT_EQ(of_it.code, 0) << of_it.err;
    auto const data = json::parse(folder->read("p.html"));
    auto const sentence = json::parse(folder->read("cost.json")).at("study").at(0).at("sentence").get<std::string>();
    EXPECT_NE(data.at("checks")[3].at("result").get<std::string>().find(sentence), std::string::npos);
    EXPECT_NE(data.at("checks")[4].at("result").get<std::string>().find("base_width = "), std::string::npos)
        << data.at("checks")[4];
    EXPECT_EQ(data.at("sensitivity"), json::parse(folder->read("moved.json")));
    // Its numerical error stands below P in the answer.
    auto const last = data.at("answer").at("rows").back();
    EXPECT_EQ(last.at(1), "numerical error of P");
    EXPECT_TRUE(last.at(2).get<std::string>().ends_with(", mean over levels (overturn cost, 15 trials)")) << last;
    // Where levels are too far apart nothing says that a value has no effect.
    folder->write("coarse.json", cost({"--sensitivity"}, "coarse.toml"));
    ASSERT_EQ(overturn(*folder, {"run", "coarse.toml", "-o", "coarse.h5"}).code, 0);
    ASSERT_EQ(overturn(*folder, {"report", "coarse.h5", "-o", "q.html", "--record", "coarse.json"}).code, 0);
    EXPECT_EQ(json::parse(folder->read("q.html")).at("checks")[4].at("result"),
              "NOT RESOLVED for some values: levels are coarse, state more");
    // Nor where no value could be changed.
    auto none = json::parse(folder->read("coarse.json"));
    none["rows"] = json::array();
    none["not_moved"] = json::parse(R"([{"key": "bodies[0].foot", "value": "a", "why": "a word"}])");
    folder->write("none.json", none.dump());
    ASSERT_EQ(overturn(*folder, {"report", "coarse.h5", "-o", "q.html", "--record", "none.json"}).code, 0);
    EXPECT_EQ(json::parse(folder->read("q.html")).at("checks")[4].at("result"),
              "no assumed value was changed; not changed: bodies[0].foot");
}

// Beside the worst trials of all: what came farthest at the design basis, by the rows of the file.
TEST_F(CalculationPackage, DrawsWhatHappensAtTheDesignBasis) {
    ASSERT_EQ(overturn(*folder, {"export", "c.h5", "-o", "x", "--as", "csv", "--force"}).code, 0);
    auto const rows = cells_of(folder->read("x/trials.csv"));
    auto const column = [&](char const* name) { return std::ranges::find(rows[0], name) - rows[0].begin(); };
    auto const tilt_of = [&](std::size_t trial) { return std::stod(rows[trial + 1][column("peak_rotation_ratio")]); };
    auto const data = data_of();
    std::set<std::string> found;
    for (auto const& shown : data.at("histories")) {
        if (shown.at("title").get<std::string>().find("farthest at the design basis") == std::string::npos) {
            continue;
        }
        found.insert(shown.at("body"));
        auto const drawn = shown.at("trial").get<std::size_t>();
        for (std::size_t trial = 0; trial + 1 < rows.size(); ++trial) {
            auto const& row = rows[trial + 1];
            if (row[column("body")] == shown.at("body") && row[column("amplitude [gal]")] == "600") {
                EXPECT_LE(tilt_of(trial), tilt_of(drawn)) << trial;
            }
        }
        EXPECT_EQ(rows[drawn + 1][column("amplitude [gal]")], "600");
    }
    EXPECT_GE(found.size(), 1U);
    auto const words = data.at("histories_of").get<std::string>();
    for (auto const* body : {"type-a", "type-b"}) {
        bool const still =
            words.starts_with("No history at the design basis: ") && words.find(body) < words.find(" did not move");
        EXPECT_NE(found.contains(body), still) << body << ": " << words;
    }
}

// Prose is the program's: how it was computed and what not; a calculation by hand stands beside the simulation.
TEST_F(CalculationPackage, StatesTheMethodAndTheHandCalculation) {
    auto const data = data_of();
    EXPECT_GE(data.at("method_lines").size(), 4U);
    EXPECT_EQ(data.at("hand_check_lines").size(), 4U);  // the method, what it leaves out, two bodies
    EXPECT_EQ(data.at("fit").at("hand_check").size(), 2U);
    std::vector<std::string> names;
    for (auto const& fact : data.at("method")) {
        names.push_back(fact[0]);
    }
    EXPECT_EQ(names, (std::vector<std::string>{"effects", "validated range", "integration", "T0, T1", "confidence"}));
}

}  // namespace
}  // namespace overturn::testing
