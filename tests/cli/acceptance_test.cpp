// Requirement R-106: the program says of each wave how right it is, clause by clause, and of a run how many waves it
// refused.
#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/campaign_files.hpp"
#include "cli/python.hpp"
#include "support/command.hpp"
#include "support/single_blanks.hpp"

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
    std::string const counted = "4 waves, 4 outside match_tolerance, but used";
    EXPECT_NE(in_one_line(run.out).find(counted), std::string::npos) << run.out;
    auto const status = overturn(folder, {"status", "c.h5"});
    EXPECT_NE(status.out.find(counted), std::string::npos) << status.out;
}

// After five iterations about half of the waves of this campaign meet the rule.
class Refusal : public Acceptance {
  protected:
    void SetUp() override {
        Acceptance::SetUp();
        auto text = small_campaign("shared", 9);
        auto const put = [&](std::string const& before, std::string const& now) {
            text.replace(text.find(before), before.size(), now);
        };
        put("match_iterations=3", "match_iterations=5\nacceptance='japan'");
        put("longest=6", "longest=10");
        put("duration='20.48 s'", "duration='40.96 s'");
        put("level_end='10 s'", "level_end='25 s'");
        put("end='18 s'", "end='38 s'");
        folder.write("c.toml", text);
    }

    [[nodiscard]] nlohmann::json columns(std::string const& file, std::string const& names) const {
        auto const text = execute(folder, {OVERTURN_PYTHON, "-c",
                                           "import h5py,json,sys\nf=h5py.File(sys.argv[1])\n"
                                           "print(json.dumps({n: f[n][...].tolist() for n in sys.argv[2].split()}))",
                                           file, names});
        EXPECT_EQ(text.code, 0) << text.err;
        return nlohmann::json::parse(text.out);
    }
};

/// `count` waves meet the rule, those of the lowest numbers; the others are no trials, and the file, the tables
/// and the JSON say how many they were and what they missed.
TEST_F(Refusal, WavesThatMissTheRuleAreNoTrials) {
    auto const run = overturn(folder, {"run", "c.toml"});
    ASSERT_EQ(run.code, 0) << run.err;
    auto const file = columns("c.h5",
                              "waves/id waves/accepted refused_waves/id refused_waves/accepted trials/wave "
                              "trials/failure missed_clauses/waves acceptance/refused acceptance/tried");
    auto const ids = file.at("waves/id").get<std::vector<int>>();
    auto const refused = file.at("refused_waves/id").get<std::vector<int>>();
    ASSERT_EQ(ids.size(), 9U);
    ASSERT_GT(refused.size(), 0U) << "nothing is shown by a campaign that accepts all";
    for (int number = 0; number <= ids.back(); ++number) {
        bool const accepted = std::ranges::binary_search(ids, number);
        EXPECT_NE(accepted, std::ranges::binary_search(refused, number)) << number;
        auto const wave = overturn(folder, {"wave", "c.toml", "--wave", std::to_string(number), "--json"});
        EXPECT_EQ(nlohmann::json::parse(wave.out).at("acceptance").at("accepted").get<bool>(), accepted) << number;
    }
    EXPECT_LT(refused.back(), ids.back());
    EXPECT_EQ(file.at("trials/failure"), nlohmann::json(std::vector<int>(9 * 6, 0)));
    EXPECT_EQ(file.at("trials/wave")[6], ids[1]);
    EXPECT_EQ(file.at("acceptance/refused")[0], refused.size());
    EXPECT_EQ(file.at("acceptance/tried")[0], 9);

    auto const drawn = ids.size() + refused.size();
    auto const counted = fmt::format("9 waves that meet japan; {} of {} drawn were refused", refused.size(), drawn);
    EXPECT_NE(in_one_line(run.out).find(counted), std::string::npos) << run.out;
    EXPECT_NE(run.out.find(": missed by "), std::string::npos) << run.out;
    auto const status = overturn(folder, {"status", "c.h5"});
    EXPECT_NE(status.out.find(counted), std::string::npos) << status.out;
    EXPECT_EQ(status.out.find("failed trials"), std::string::npos) << status.out;
    auto const fit = overturn(folder, {"fit", "c.h5", "--json"});
    auto const told = nlohmann::json::parse(fit.out);
    EXPECT_EQ(told.at("acceptance")[0].at("refused"), refused.size());
    EXPECT_EQ(told.at("stripes")[0].at("trials"), 9);
    EXPECT_EQ(told.at("stripes")[0].at("undecided"), 0);
    EXPECT_GT(told.at("missed_clauses").size(), 0U);
    EXPECT_EQ(overturn(folder, {"verify", "c.h5"}).code, 0);
    auto const replay = overturn(folder, {"replay", "c.h5", "--trial", "50"});
    EXPECT_EQ(replay.code, 0) << replay.err;
    EXPECT_NE(replay.out.find(fmt::format("wave number {} ", ids[8])), std::string::npos) << replay.out;
    EXPECT_EQ(overturn(folder, {"report", "c.h5", "-o", "c.html"}).code, 0);
}

/// R-1001: The same bytes on 1, 2 and 3 ranks, after a stop, and of parts; another seed gives others.
TEST_F(Refusal, ChoosesTheSameWavesHoweverTheyWereComputed) {
    ASSERT_EQ(overturn(folder, {"run", "c.toml", "-o", "one.h5"}).code, 0);
    auto const one = folder.read("one.h5");
    for (int const ranks : {2, 3}) {
        auto const name = fmt::format("on{}.h5", ranks);
        ASSERT_EQ(execute(folder, mpirun(ranks, {"run", "c.toml", "-o", name})).code, 0);
        EXPECT_TRUE(folder.read(name) == one) << ranks;
    }
    ASSERT_EQ(overturn(folder, {"run", "c.toml", "-o", "other.h5", "--set", "seed=5"}).code, 0);
    EXPECT_FALSE(folder.read("other.h5") == one);

    auto stopped = overturn(folder, {"run", "c.toml", "-o", "segments.h5", "--max-walltime", "0.05s"});
    EXPECT_EQ(stopped.code, 3) << stopped.err;
    auto const status = overturn(folder, {"status", "segments.h5"});
    EXPECT_EQ(status.code, 3);
    EXPECT_NE(status.out.find(" left"), std::string::npos) << status.out;
    ASSERT_EQ(overturn(folder, {"run", "c.toml", "-o", "segments.h5", "--resume"}).code, 0);
    EXPECT_TRUE(folder.read("segments.h5") == one);

    for (std::string const part : {"2/2", "1/2"}) {
        auto const ended = overturn(folder, {"run", "c.toml", "-o", "parts.h5", "--part", part});
        ASSERT_EQ(ended.code, 0) << ended.err;
    }
    if (overturn(folder, {"merge", "parts.h5"}).code != 0) {  // a few more were needed than the parts foresaw
        ASSERT_EQ(overturn(folder, {"run", "c.toml", "-o", "parts.h5", "--resume"}).code, 0);
    }
    EXPECT_TRUE(folder.read("parts.h5") == one);
}

TEST_F(Refusal, EachLevelDrawsUntilItsOwnAreEnough) {
    auto const run = overturn(folder, {"run", "c.toml", "--set", "levels.waves=independent", "--set", "waves.count=3"});
    ASSERT_EQ(run.code, 0) << run.err;
    auto const file = columns("c.h5", "trials/level refused_waves/id");
    EXPECT_EQ(file.at("trials/level"), nlohmann::json({0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 2, 2, 2, 2, 2, 2}));
    EXPECT_GT(file.at("refused_waves/id").size(), 0U);
    EXPECT_EQ(overturn(folder, {"verify", "c.h5"}).code, 0);
    auto const part =
        overturn(folder, {"run", "c.toml", "-o", "p.h5", "--part", "1/2", "--set", "levels.waves=independent"});
    EXPECT_EQ(part.code, 2);
    EXPECT_NE(part.err.find("--part 1/2 of waves that are held to a rule level by level"), std::string::npos);
}

/// What nearly no wave meets ends the campaign after the first hundred, with the clause and what helps; nothing stays.
TEST_F(Refusal, EndsWhereHardlyAnyWavePasses) {
    std::vector<std::string> const starved{"run",   "c.toml",        "--set", "waves.match_iterations=1",
                                           "--set", "waves.count=20"};
    auto const run = overturn(folder, starved);
    EXPECT_EQ(run.code, 2) << run.out;
    EXPECT_NE(run.err.find("c.toml: 0 of the first 100 waves meet japan (fewer than one in ten; of those refused: "),
              std::string::npos)
        << run.err;
    EXPECT_NE(run.err.find("missed by 100"), std::string::npos) << run.err;
    EXPECT_FALSE(folder.has("c.h5"));
    EXPECT_FALSE(folder.has("c.h5.parts"));
    auto const plan = planned(folder, {"c.toml", "--set", "waves.match_iterations=1"});
    EXPECT_NE(plan.out.find("0 waves that meet japan; 9 of 9 drawn were refused"), std::string::npos) << plan.out;
    EXPECT_NE(single_blanks(plan.out).find("warning none of 9 waves tried meets japan ("), std::string::npos)
        << plan.out;
}

/// where no wave that `plan` tries meets the rule it says what the run would end with, and what helps.
TEST_F(Refusal, IsForetoldWithWhatHelps) {
    std::vector<std::string> const brief{"c.toml", "--set", "waves.acceptance=srp-3.7.1"};
    std::string const cure = "State a waves.time_step of at most 0.01 s";
    auto const run = overturn(folder, joined({"run"}, brief));
    EXPECT_EQ(run.code, 2);
    EXPECT_NE(run.err.find(cure), std::string::npos) << run.err;
    auto const plan = overturn(folder, joined({"plan"}, brief));
    EXPECT_EQ(plan.code, 0) << plan.err;
    EXPECT_NE(single_blanks(plan.out).find("warning none of 9 waves tried meets srp-3.7.1"), std::string::npos)
        << plan.out;
    auto const json = overturn(folder, joined({"plan", "--json"}, brief));
    EXPECT_NE(nlohmann::json::parse(json.out)["warnings"].dump().find(cure + "). A run ends without results"),
              std::string::npos)
        << json.out;
    EXPECT_EQ(planned(folder, {"c.toml"}).out.find("waves tried meets"), std::string::npos);
}

TEST_F(Refusal, KeysAreOfUseOrRefused) {
    for (auto const& [set, why] :
         {std::pair{"waves.acceptance=none", "waves.most_drawn"}, std::pair{"waves.refused=used", "waves.refused"}}) {
        auto const ended = planned(folder, {"c.toml", "--set", "waves.most_drawn=3", "--set", set});
        EXPECT_EQ(ended.code, 2) << set;
        EXPECT_NE(ended.err.find(why), std::string::npos) << ended.err;
    }
}

}  // namespace
}  // namespace overturn::testing
