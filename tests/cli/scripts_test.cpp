// Requirement R-919: scripts and schedulers learn from a run what people do: how far it is, what it reported, what it
// has found so far, what it will take, and by its exit code whether it can go on.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/campaign_files.hpp"
#include "support/command.hpp"

namespace overturn::testing {
namespace {

using nlohmann::json;

class Scripts : public ::testing::Test {
  protected:
    Scripts() { folder.write("target.csv", target_csv); }

    void write(int waves) const { folder.write("c.toml", small_campaign("shared", waves)); }
    [[nodiscard]] json told(std::vector<std::string> const& arguments, int code = 0) const {
        auto const ended = overturn(folder, arguments);
        EXPECT_EQ(ended.code, code) << ended.err;
        return json::parse(ended.out);
    }
    /// Stops a run of `waves` once some blocks are there.
    void stop_a_run(int waves) const {
        write(waves);
        Running running(folder, {OVERTURN_PROGRAM, "run", "c.toml"});
        ASSERT_TRUE(comes_true([&] { return blocks_done(folder, "c.h5") > 3; }));
        running.signal(SIGUSR1);
        ASSERT_EQ(running.wait().code, 3);
    }

    Folder folder;
};

// R-1102: of a finished file and of an unfinished run, in the same words as the text.
TEST_F(Scripts, StatusIsJson) {
    stop_a_run(400);
    auto const run = told({"status", "c.h5", "--json"}, 3);
    EXPECT_EQ(run["complete"], false);
    EXPECT_EQ(run["under_way"], false);
    EXPECT_EQ(run["title"], "small");
    EXPECT_EQ(run["blocks"]["done"], blocks_done(folder, "c.h5"));
    EXPECT_EQ(run["blocks"]["done"].get<int>() + run["blocks"]["left"].get<int>(), run["blocks"]["all"]);
    EXPECT_EQ(run["waves"]["planned"], 400);
    EXPECT_EQ(run["trials"]["done"].get<int>(), 6 * run["waves"]["done"].get<int>());
    EXPECT_EQ(run["next"], "overturn run c.toml -o c.h5 --resume");
    auto const text = unwrapped(overturn(folder, {"status", "c.h5"}).out);
    EXPECT_TRUE(text.starts_with("c.h5: " + run["text"].get<std::string>() + "\n")) << text;

    write(3);
    ASSERT_EQ(overturn(folder, {"run", "c.toml", "-o", "done.h5"}).code, 0);
    auto const file = told({"status", "done.h5", "--json"});
    EXPECT_EQ(file["complete"], true);
    EXPECT_EQ(file["edited"], false);
    auto const digest = file["content_sha256"].get<std::string>();
    EXPECT_EQ(digest.size(), 64U);
    EXPECT_NE(overturn(folder, {"status", "done.h5"}).out.find("content_sha256 " + digest + "\n"), std::string::npos);
    EXPECT_EQ(file["waves"]["done"], 3);
    EXPECT_EQ(file["trials"], (json{{"done", 18}, {"planned", 18}, {"failed", 0}}));
    EXPECT_TRUE(file["extension"].is_null());
}

// R-1102: while it is under way, from the names of files alone: a block that is damaged is not looked into.
TEST_F(Scripts, StatusOfARunUnderWayReadsNoBlock) {
    write(100'000);
    Running running(folder, {OVERTURN_PROGRAM, "run", "c.toml"});
    ASSERT_TRUE(comes_true([&] { return blocks_done(folder, "c.h5") > 3; }));
    auto const run = told({"status", "c.h5", "--json"}, 3);
    EXPECT_EQ(run["under_way"], true);
    EXPECT_TRUE(run["next"].is_null());
    EXPECT_GT(run["blocks"]["done"], 3);
    running.signal(SIGTERM);
    ASSERT_EQ(running.wait().code, 3);
    folder.write("c.h5.parts/0000000000.block", "torn");
    auto const whole = told({"status", "c.h5", "--json"}, 3)["blocks"]["done"].get<int>();
    EXPECT_EQ(whole, blocks_done(folder, "c.h5"));
    EXPECT_NE(overturn(folder, {"status", "c.h5"}).out.find(fmt::format(", {} of ", whole - 1)), std::string::npos);
}

// R-905: what is committed so far, marked as such in text and JSON; counts are those of the waves that are there.
TEST_F(Scripts, FitOfAnUnfinishedRun) {
    EXPECT_EQ(overturn(folder, {"fit", "c.h5", "--interim"}).code, 2);
    stop_a_run(400);
    auto const waves = told({"status", "c.h5", "--json"}, 3)["waves"]["done"].get<int>();
    auto const fit = told({"fit", "c.h5", "--interim", "--json"});
    EXPECT_EQ(fit["interim"]["waves"], waves);
    EXPECT_EQ(fit["interim"]["planned"], 400);
    for (auto const& stripe : fit["stripes"]) {
        EXPECT_EQ(stripe["trials"], waves);
    }
    auto const text = overturn(folder, {"fit", "c.h5", "--interim"});
    EXPECT_EQ(text.code, 0) << text.err;
    auto const mark =
        fmt::format("INTERIM: {} of 400 waves, those that were done first; the run is not complete\n", waves);
    EXPECT_TRUE(text.out.starts_with(mark)) << text.out;
    EXPECT_TRUE(text.out.ends_with(mark)) << text.out;
    EXPECT_NE(text.out.find("more: overturn fit c.h5 --interim --full"), std::string::npos) << text.out;
    auto const refused = overturn(folder, {"fit", "c.h5"});
    EXPECT_EQ(refused.code, 2);
    EXPECT_NE(refused.err.find("overturn fit --interim c.h5"), std::string::npos) << refused.err;

    // One rank does the first waves first: the same counts as of a campaign of so many.
    write(waves);
    ASSERT_EQ(overturn(folder, {"run", "c.toml", "-o", "few.h5"}).code, 0);
    auto const few = told({"fit", "few.h5", "--json"});
    EXPECT_TRUE(few["interim"].is_null());
    EXPECT_EQ(told({"fit", "few.h5", "--interim", "--json"}), few) << "the run has finished meanwhile";
    std::filesystem::copy(folder / "c.h5.parts", folder / "few.h5.parts", std::filesystem::copy_options::recursive);
    EXPECT_EQ(told({"fit", "few.h5", "--interim", "--json"})["interim"]["planned"], 400) << "a larger one goes on";
    std::filesystem::remove_all(folder / "few.h5.parts");
    EXPECT_EQ(few["stripes"], fit["stripes"]);
    ASSERT_FALSE(fit["fragility"].empty());
    EXPECT_EQ(few["fragility"], fit["fragility"]);
}

TEST_F(Scripts, ProgressIsLinesOfJson) {
    write(30);
    auto const ended = execute(folder, mpirun(2, {"run", "c.toml", "--progress", "json"}));
    ASSERT_EQ(ended.code, 0) << ended.err;
    std::istringstream lines(ended.err);
    std::vector<json> events;
    for (std::string line; std::getline(lines, line);) {
        events.push_back(json::parse(line));
    }
    std::vector<json> progress;
    std::ranges::copy_if(events, std::back_inserter(progress), [](json const& e) { return e["event"] == "progress"; });
    ASSERT_FALSE(progress.empty());
    EXPECT_EQ(progress.back()["done"], 30);
    EXPECT_EQ(progress.back()["of"], 30);
    EXPECT_GT(progress.back()["trials_per_s"], 0);
    EXPECT_TRUE(std::ranges::any_of(events, [](json const& e) {
        return e["event"] == "note" && e["text"].get<std::string>().starts_with("waves: ");
    })) << ended.err;
    EXPECT_EQ(events.back(), (json{{"event", "end"}, {"output", "c.h5"}, {"exit_code", 0}}));
    EXPECT_EQ(overturn(folder, {"run", "c.toml", "--progress", "xml"}).code, 2);
    std::filesystem::remove(folder / "c.h5");
    write(100'000);
    auto const stopped = overturn(folder, {"run", "c.toml", "--progress", "json", "--max-walltime", "1 s"});
    EXPECT_EQ(stopped.code, 3);
    EXPECT_NE(stopped.err.find(R"({"event":"end","output":"c.h5","exit_code":3})"), std::string::npos) << stopped.err;
    auto const last_line =
        [](std::string text) {  // of the program's own: mpirun says that it ended otherwise than by 0
            text.resize(text.rfind("}\n") + 1);
            return json::parse(text.substr(text.rfind('\n') + 1));
        };
    for (auto const& command : {std::vector<std::string>{OVERTURN_PROGRAM, "run"}, mpirun(2, {"run"})}) {
        for (auto const& [more, code] : {std::pair{std::vector<std::string>{"c.toml", "--set", "waves.cont=3"}, 2},
                                         {{"none.toml", "-o", "c.h5"}, 2},
                                         {{"c.toml", "--part", "3/2"}, 2}}) {
            auto const bad = execute(folder, joined(joined(command, more), {"--progress", "json"}));
            EXPECT_EQ(last_line(bad.err), (json{{"event", "end"}, {"output", "c.h5"}, {"exit_code", code}})) << bad.err;
        }
    }
    auto patient = mpirun(2, {"run", "c.toml", "--resume", "--progress", "json"});
    // mpirun kills a second after its TERM, which a busy machine may need.
    patient.insert(patient.begin() + 1, {"--mca", "odls_base_sigkill_timeout", "20"});
    Running told(folder, patient);
    auto const before = blocks_done(folder, "c.h5");
    ASSERT_TRUE(comes_true([&] { return blocks_done(folder, "c.h5") > before; }));
    told.signal(SIGTERM);
    auto const ended_early = told.wait();
    EXPECT_EQ(last_line(ended_early.err), (json{{"event", "end"}, {"output", "c.h5"}, {"exit_code", 3}}))
        << ended_early.err;
}

// R-1102: mpirun ends with 1 after a TERM of its own, as after a failure; SIGUSR2 leaves as soon, with 3.
TEST_F(Scripts, ASignalThatMpirunHandsOnEndsWithThree) {
    write(100'000);
    Running running(folder, mpirun(2, {"run", "c.toml"}));
    ASSERT_TRUE(comes_true([&] { return blocks_done(folder, "c.h5") > 3; }));
    running.signal(SIGUSR2);
    auto const ended = running.wait();
    EXPECT_EQ(ended.code, 3) << ended.err;
    EXPECT_NE(ended.err.find("stopped early: "), std::string::npos) << ended.err;
}

// R-1102: a batch job's end, where the batch system states it, is a limit as --max-walltime is.
TEST_F(Scripts, ABatchJobsEndIsALimit) {
    write(100'000);
    auto const run = [&](std::string const& end) {
        return execute(
            folder, {"/bin/sh", "-c", "SLURM_JOB_END_TIME=" + end + " exec " OVERTURN_PROGRAM " run c.toml --resume"});
    };
    for (auto const* end : {"$(($(date +%s) + 3))", "$(($(date +%s) - 5))"}) {  // the latter: begun late on a busy node
        auto const ended = run(end);
        EXPECT_EQ(ended.code, 3) << ended.err;
        EXPECT_NE(ended.err.find("stopped early: "), std::string::npos) << ended.err;
    }
    write(20);  // limits that are none
    std::filesystem::remove_all(folder / "c.h5.parts");
    for (auto const* end : {"0", "1000000000", "UNLIMITED", "''"}) {
        EXPECT_EQ(run(end).code, 0) << end;
        std::filesystem::remove(folder / "c.h5");
    }
}

// R-904: all that the text of `plan` says.
TEST_F(Scripts, PlanIsJson) {
    folder.write("c.toml", campaign_on_points(500) + "[[limits]]\nname='slips'\nquantity='peak_slip'\nabove='1 mm'\n");
    auto const plan = told({"plan", "c.toml", "--json", "--ranks", "16"});
    for (auto const* key :
         {"title",        "waves",           "trials",   "blocks",      "block_waves", "wave_source",
          "variability",  "records",         "bodies",   "levels",      "limits",      "effects",
          "validated",    "rare_max_waves",  "warnings", "assumptions", "file_bytes",  "scratch_bytes",
          "memory_bytes", "waves_of_curves", "probe",    "ranks",       "rare",        "limit_s"}) {
        EXPECT_TRUE(plan.contains(key)) << key;
    }
    EXPECT_EQ(plan["bodies"].size(), 5U);
    EXPECT_DOUBLE_EQ(plan["bodies"][0]["mass_kg"], 12600);
    EXPECT_EQ(plan["levels"]["levels"][1]["stated"], 600);
    EXPECT_DOUBLE_EQ(plan["levels"]["levels"][1]["amplitude"], 6);
    EXPECT_EQ(plan["levels"]["levels"][1]["purpose"], "design-basis");
    EXPECT_EQ(plan["limits"][0]["name"], "slips");
    EXPECT_GT(plan["probe"]["wave_s"], 0);
    EXPECT_FALSE(plan["probe"]["models"].empty());
    auto const& sixteen = plan["ranks"].back();
    EXPECT_EQ(sixteen["ranks"], 16);
    double const block_s = plan["probe"]["wave_s"].get<double>() * 500 / plan["blocks"].get<double>();
    double const rounds = std::ceil(plan["blocks"].get<double>() / 16);
    EXPECT_NEAR(sixteen["work_s"], rounds * block_s, 1e-9 * rounds * block_s);
    EXPECT_NEAR(sixteen["busy"], plan["blocks"].get<double>() * block_s / (16 * sixteen["wall_s"].get<double>()), 1e-9);
    for (auto const& ranks : plan["ranks"]) {
        double parts = 0;
        for (auto const* part : {"start_s", "work_s", "rare_s", "merge_s"}) {
            parts += ranks[part].get<double>();
        }
        EXPECT_DOUBLE_EQ(ranks["wall_s"], parts);
        EXPECT_GT(ranks["start_s"], 0);
        EXPECT_EQ(ranks["rare_s"], 0);
    }
    EXPECT_TRUE(plan["rare"].is_null());
    // 50 curves of 75 ms each are what merging 7500 trials takes, four each on 16 ranks, and 0.1 s on one rank.
    auto const& alone = plan["ranks"].front();
    EXPECT_EQ(alone["ranks"], 1);
    double const times_faster = alone["merge_s"].get<double>() / sixteen["merge_s"].get<double>();
    EXPECT_GT(times_faster, 9);
    EXPECT_LT(times_faster, 11);
    auto const text = planned(folder, {"c.toml", "--ranks", "1000", "--full"}).out;
    EXPECT_NE(text.find(" on 1000 ranks, which compute "), std::string::npos) << text;
    EXPECT_EQ(overturn(folder, {"plan", "c.toml", "--ranks", "0"}).code, 2);
}

// R-904: a limit within which no block is ever done, stated or of the batch job.
TEST_F(Scripts, PlanWarnsOfALimitShorterThanABlock) {
    write(12);
    auto const warning = [&](std::vector<std::string> const& more) {
        auto const plan = told(joined({"plan", "c.toml", "--json"}, more));
        auto const last = plan["warnings"].empty() ? "" : plan["warnings"].back().get<std::string>();
        bool const warns = last.starts_with("within the limit of ");
        auto const text = planned(folder, joined({"c.toml"}, more)).out;
        EXPECT_EQ(warns, text.find("within the limit of ") != std::string::npos) << text;
        return std::pair(plan["limit_s"], warns ? last : "");
    };
    auto const [limit, text] = warning({"--max-walltime", "0.001 s"});
    EXPECT_EQ(limit, 0.001);
    EXPECT_TRUE(text.starts_with("within the limit of 1 ms no block is done: one (a wave) takes about ")) << text;
    EXPECT_NE(text.find("Raise the limit to several times that, or give bodies or levels"), std::string::npos) << text;
    EXPECT_EQ(warning({"--max-walltime", "1:00:00", "--ranks", "16"}), std::pair(json(3600), std::string()));
    EXPECT_TRUE(warning({}).first.is_null());
    folder.write("points.toml", campaign_on_points(2000));
    auto const few = planned(folder, {"points.toml", "--max-walltime", "1 ms"}).out;
    EXPECT_NE(few.find("no block is done: one (7 waves) takes"), std::string::npos) << few;
    auto const in_job = execute(
        folder, {"/bin/sh", "-c", "SLURM_JOB_END_TIME=$(($(date +%s) - 5)) exec " OVERTURN_PROGRAM " plan c.toml"});
    EXPECT_NE(in_job.out.find("within the limit of 0 ms no block is done"), std::string::npos) << in_job.out;
    EXPECT_EQ(overturn(folder, {"plan", "c.toml", "--max-walltime", "h"}).code, 2);
}

// R-901: settings one by one or several behind one --set; whatever else stands there is what it was.
TEST_F(Scripts, SeveralSettings) {
    write(3);
    auto const waves = [&](std::vector<std::string> const& words) {
        auto const plan = told(joined({"plan", "--json"}, words));
        return std::pair(plan["waves"].get<int>(), plan["title"].get<std::string>());
    };
    auto const expected = std::pair(2, std::string("t=1"));
    EXPECT_EQ(waves({"c.toml", "--set", "waves.count=2", "title=t=1"}), expected);
    EXPECT_EQ(waves({"c.toml", "--set=waves.count=2", "title=t=1"}), expected);
    EXPECT_EQ(waves({"c.toml", "--set", "waves.count=2", "--set", "title=t=1"}), expected);
    EXPECT_EQ(waves({"--set", "waves.count=2", "title=t=1", "c.toml"}), expected);
    std::filesystem::rename(folder / "c.toml", folder / "mu=0.5.toml");
    EXPECT_EQ(waves({"--set", "waves.count=2", "title=t=1", "mu=0.5.toml"}), expected);
    auto const ended = overturn(folder, {"plan", "mu=0.5.toml", "--set", "waves.count=2", "seed"});
    EXPECT_EQ(ended.code, 2);
    EXPECT_NE(ended.err.find("'seed' (one argument too many)"), std::string::npos) << ended.err;
}

}  // namespace
}  // namespace overturn::testing
