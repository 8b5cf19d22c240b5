// Requirement R-1001, R-802: a campaign's rare events are the same bytes on any number of ranks and after SIGKILL,
// replayable row by row from the file alone, and stated only where they can be trusted.
#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "support/command.hpp"
#include "support/line_width.hpp"

namespace overturn::testing {
namespace {

class Rare : public ::testing::Test {
  protected:
    static std::string campaign(std::string const& rare, std::string const& levels = "measure='factor'\nvalues=[1.25]",
                                std::string const& waves =
                                    "source='filtered-noise'\nrms='1 m/s2'\n"
                                    "model='clough-penzien'\nground_frequency='0.5 Hz'\n"
                                    "ground_damping=0.5\nfilter_frequency='0.1 Hz'\n") {
        return fmt::format(
            "seed=7\n[waves]\n{}count=3\nduration='20.47 s'\ntime_step='0.02 s'\n"
            "[[bodies]]\nname='block'\nmass='12.6 t'\nbase_width='0.9 m'\ncentre_height='1.045 m'\n"
            "inertia='uniform-block'\nrestitution=0.85\n[levels]\n{}\n[rare]\n{}\nreplicates=4\n",
            waves, levels, rare);
    }

    nlohmann::json table(std::string const& file, char const* name) {
        auto const ended = overturn(folder, {"fit", file, "--json"});
        EXPECT_EQ(ended.code, 0) << ended.err;
        return nlohmann::json::parse(ended.out).at(name);
    }
    nlohmann::json answers(std::string const& file) { return table(file, "rare"); }

    // What `overturn run` says of a campaign it refuses.
    std::string refusal(std::string const& text) {
        folder.write("bad.toml", text);
        auto const ended = overturn(folder, {"run", "bad.toml"});
        EXPECT_EQ(ended.code, 2);
        return ended.err;
    }

    Folder folder;
};

// rare events are part of what `plan` foretells, and of what the run then says it took.
TEST_F(Rare, ArePartOfThePlansTime) {
    folder.write("c.toml", campaign("method='subset'"));
    auto const ended = overturn(folder, {"plan", "c.toml", "--json"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    auto const plan = nlohmann::json::parse(ended.out);
    auto const& seconds = plan.at("rare").at("seconds");
    auto const& one = plan.at("ranks")[0];

    EXPECT_GT(seconds.at("least"), 0);
    EXPECT_GE(seconds.at("likely"), seconds.at("least"));
    EXPECT_GE(seconds.at("most"), seconds.at("likely"));
    EXPECT_EQ(one.at("rare_s"), seconds.at("likely"));
    EXPECT_DOUBLE_EQ(one.at("wall_s"), one.at("start_s").get<double>() + one.at("work_s").get<double>()
                                           + one.at("rare_s").get<double>() + one.at("merge_s").get<double>());
    EXPECT_NE(overturn(folder, {"plan", "c.toml"}).out.find("rare events"), std::string::npos);

    ASSERT_EQ(overturn(folder, {"run", "c.toml"}).code, 0);
    auto const segment = nlohmann::json::parse(folder.read("c.runtime.json")).at("segments")[0];
    EXPECT_GT(segment.at("rare_s"), 0);
    EXPECT_GT(segment.at("wall_s"), segment.at("rare_s"));
}

// What max_runs bounds: neither the first stage of subset simulation nor the search for failures before it.
TEST_F(Rare, FirstStageAndSearchComeBesideMaxRuns) {
    constexpr int first_stage = 2000;  // of a replicate
    constexpr int look = 2048;         // at one amplitude of the search
    constexpr int most = 20'000;
    folder.write("c.toml", campaign("method='subset'\nmax_runs=20000"));
    auto const runs = [&](int replicates) {
        auto const file = fmt::format("{}.h5", replicates);
        auto const setting = fmt::format("rare.replicates={}", replicates);
        EXPECT_EQ(overturn(folder, {"run", "c.toml", "-o", file, "--set", setting}).code, 0);
        return answers(file)[0]["runs"].get<int>();
    };
    auto const many = runs(12) - 12 * first_stage;
    EXPECT_GT(many, 0);
    EXPECT_EQ(many % look, 0) << "looks alone, and no second stage: that would be above max_runs";
    auto const few = runs(4);
    EXPECT_GT(few, 4 * first_stage + look);
    EXPECT_LE(few, 2 * most);
}

// R-1101: subset simulation killed in the middle of a level goes on, on other ranks, to the bytes of an unbroken
// run.
TEST_F(Rare, SubsetIsTheSameOnAnyRanksAndAfterKills) {
    folder.write("c.toml", campaign("method='subset'"));
    ASSERT_EQ(execute(folder, mpirun(1, {"run", "c.toml", "-o", "one.h5"})).code, 0);
    for (int const blocks : {4, 12, 22}) {
        Running running(folder, {OVERTURN_PROGRAM, "run", "c.toml", "--resume"});
        ASSERT_TRUE(comes_true([&] { return blocks_done(folder, "c.h5") > blocks; }));
        running.signal(SIGKILL);
        EXPECT_EQ(running.wait().code, 128 + SIGKILL);
    }
    auto const ended = execute(folder, mpirun(3, {"run", "c.toml", "--resume"}));
    ASSERT_EQ(ended.code, 0) << ended.err;

    EXPECT_TRUE(folder.read("c.h5") == folder.read("one.h5"));
    EXPECT_FALSE(folder.has("c.h5.parts"));
    EXPECT_EQ(too_wide(overturn(folder, {"fit", "c.h5", "--full"}).out), "");
}

// R-1101, R-1005: the same of the pulse mixture, killed in the middle of its selector; every kind of row replays
// bit-equal.
TEST_F(Rare, PulsesAreTheSameOnAnyRanksAndAfterKills) {
    folder.write("c.toml", campaign("method='pulse-mixture'\ntarget_cov=1"));
    ASSERT_EQ(execute(folder, mpirun(2, {"run", "c.toml", "-o", "two.h5"})).code, 0);
    Running running(folder, {OVERTURN_PROGRAM, "run", "c.toml"});
    ASSERT_TRUE(comes_true([&] { return blocks_done(folder, "c.h5") > 8; }));
    running.signal(SIGKILL);
    EXPECT_EQ(running.wait().code, 128 + SIGKILL);
    ASSERT_EQ(execute(folder, mpirun(3, {"run", "c.toml", "--resume"})).code, 0);

    EXPECT_TRUE(folder.read("c.h5") == folder.read("two.h5"));
    for (auto const* row : {"0", "2500", "20000", "40000"}) {
        auto const replay = overturn(folder, {"replay", "c.h5", "--rare", "block", "--trial", row});
        EXPECT_EQ(replay.code, 0) << replay.err;
        EXPECT_NE(replay.out.find("bit-equal"), std::string::npos) << replay.out;
    }
}

// the page shows the tail, the health of the estimators, the pulses and a wave that overturns the body.
// the tables for others hold the estimates beside the counts, cell by cell those of the file, and what the
// answer depends on.
TEST_F(Rare, IsExported) {
    if (execute(folder, {OVERTURN_PYTHON, "-c", "import h5py, openpyxl"}).code != 0) {
        GTEST_SKIP() << "no h5py and openpyxl to read with (install python3-h5py, python3-openpyxl)";
    }
    folder.write("c.toml", campaign("method='subset'", "measure='factor'\nvalues=[1.25,1.8]")
                               + "[[limits]]\nname='half'\nquantity='peak_rotation_ratio'\nabove=0.5\n");
    ASSERT_EQ(overturn(folder, {"run", "c.toml"}).code, 0);
    auto const ended = overturn(folder, {"export", "c.h5"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    auto const compared = execute(folder, {OVERTURN_PYTHON, OVERTURN_COMPARE_TABLES, "c.h5", "c.tables"});
    EXPECT_EQ(compared.code, 0) << compared.out << compared.err;
    EXPECT_NE(compared.out.find("rare 4 rows"), std::string::npos) << compared.out;
    auto const about = folder.read("c.tables/about.csv");
    for (auto const* name : {"variability,", "confidence,0.95", "assumed,", "validated_range,"}) {
        EXPECT_NE(about.find(std::string("\n") + name), std::string::npos) << name << about;
    }
}

TEST_F(Rare, IsReported) {
    if (execute(folder, {OVERTURN_PYTHON, "-c", "import matplotlib, h5py"}).code != 0) {
        GTEST_SKIP() << "nothing to draw with (install python3-matplotlib python3-h5py)";
    }
    folder.write("p.toml", campaign("method='pulse-mixture'\ntarget_cov=1"));
    folder.write("s.toml", campaign("method='subset'", "measure='factor'\nvalues=[1.25,1.8]")
                               + "[[limits]]\nname='half'\nquantity='peak_rotation_ratio'\nabove=0.5\n");
    for (std::string const name : {"p", "s"}) {
        ASSERT_EQ(overturn(folder, {"run", name + ".toml"}).code, 0);
        auto const ended = overturn(folder, {"report", name + ".h5", "-o", name + ".html", "--figures", name});
        ASSERT_EQ(ended.code, 0) << ended.err;
        EXPECT_NE(folder.read(name + ".html").find("<section id=\"rare\""), std::string::npos);
        EXPECT_NE(folder.read(name + ".html").find("health of the estimators"), std::string::npos);
        EXPECT_TRUE(folder.has(name + "/tail-block.svg"));
        EXPECT_TRUE(folder.has(name + "/rare.csv"));
    }
    EXPECT_TRUE(folder.has("p/pulses-block.svg"));
    EXPECT_TRUE(folder.has("s/failing-block.svg"));
    EXPECT_TRUE(folder.has("s/tail-half-block.svg"));
    auto const subset = answers("s.h5")[0];
    auto const replicates = table("s.h5", "rare_replicates");
    EXPECT_EQ(
        std::ranges::count_if(
            replicates, [&](auto const& row) { return row.at("limit") == subset.at("limit") && row.at("level") == 0; }),
        4);
    auto const health = table("s.h5", "rare_health");
    ASSERT_FALSE(health.empty());
    for (auto const& check : health) {
        EXPECT_TRUE(check.at("check").is_string());
        EXPECT_TRUE(check.at("passed").get<bool>()) << check.dump();
    }
    EXPECT_GT(subset.at("cov"), 0);
}

// R-1005: rows of chains replay bit-equal too, through all they descend from.
TEST_F(Rare, ChainsReplay) {
    folder.write("c.toml", campaign("method='subset'"));
    ASSERT_EQ(overturn(folder, {"run", "c.toml"}).code, 0);
    for (auto const* row : {"5", "2400", "3300", "12000"}) {
        auto const replay = overturn(folder, {"replay", "c.h5", "--rare", "block", "--trial", row});
        EXPECT_EQ(replay.code, 0) << replay.err;
        EXPECT_NE(replay.out.find("bit-equal"), std::string::npos) << replay.out;
    }
    auto const beyond = overturn(folder, {"replay", "c.h5", "--rare", "block", "--trial", "99999999"});
    EXPECT_EQ(beyond.code, 2);
}

// answers have the stated keys; what cannot be resolved is null and a bound, never a number.
TEST_F(Rare, AnswersHaveTheirKeys) {
    folder.write("c.toml", campaign("method='crude'\nmax_runs=2000", "measure='factor'\nvalues=[0.7, 1.8]"));
    auto const run = overturn(folder, {"run", "c.toml"});
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_NE(run.out.find("rare events of block"), std::string::npos) << run.out;
    EXPECT_NE(run.out.find("not-resolved"), std::string::npos) << run.out;

    auto const rare = answers("c.h5");

    ASSERT_EQ(rare.size(), 2U);
    EXPECT_EQ(rare[0].at("body"), "block");
    EXPECT_EQ(rare[0].at("amplitude"), 0.7);
    EXPECT_TRUE(rare[0].at("probability").is_null());
    EXPECT_TRUE(rare[0].at("crude_runs").is_null());
    EXPECT_EQ(rare[0].at("state"), "not-resolved");
    EXPECT_TRUE(rare[0].at("reason").is_string());
    EXPECT_EQ(rare[0].at("lower"), 0);
    EXPECT_EQ(rare[1].at("state"), "trusted");
    EXPECT_EQ(rare[1].at("method"), "crude");
    EXPECT_GT(rare[1].at("probability"), 0.03);
    EXPECT_EQ(rare[1].at("runs"), 2000);
    EXPECT_TRUE(rare[1].at("reason").is_null());
}

// what scatters about a body is drawn with each wave, by plain trials and by subset simulation, as a
// campaign's own trials draw it; and rows of it replay.
TEST_F(Rare, WhatScattersRidesAlong) {
    auto const scattering = [&](std::string const& rare) {
        auto text = campaign(rare, "measure='factor'\nvalues=[1.3]");
        return text.replace(text.find("centre_height='1.045 m'"), 23,
                            "centre_height={distribution='normal',mean='1.045 m',deviation='0.15 m'}");
    };
    folder.write("crude.toml", scattering("method='crude'\nmax_runs=20000\ntarget_cov=0.01"));
    folder.write("subset.toml", scattering("method='subset'"));
    for (auto const* name : {"crude", "subset"}) {
        auto const ran = overturn(folder, {"run", std::string(name) + ".toml", "--set", "waves.count=4000", "--set",
                                           "measures.energy=false"});
        ASSERT_EQ(ran.code, 0) << ran.err;
    }
    auto const crude = answers("crude.h5")[0];
    auto const subset = answers("subset.h5")[0];
    auto const plain = nlohmann::json::parse(overturn(folder, {"fit", "crude.h5", "--json"}).out).at("stripes")[0];

    EXPECT_EQ(crude.at("state"), "trusted");
    EXPECT_EQ(subset.at("state"), "trusted");
    double const p = crude.at("probability");
    EXPECT_LT(plain.at("lower"), crude.at("upper"));
    EXPECT_GT(plain.at("upper"), crude.at("lower"));
    EXPECT_LT(subset.at("lower"), crude.at("upper"));
    EXPECT_GT(subset.at("upper"), crude.at("lower"));
    folder.write("exact.toml",
                 campaign("method='crude'\nmax_runs=20000\ntarget_cov=0.01", "measure='factor'\nvalues=[1.3]"));
    ASSERT_EQ(overturn(folder, {"run", "exact.toml"}).code, 0);
    double const exact_upper = answers("exact.h5")[0].at("upper");
    EXPECT_GT(p, exact_upper) << "scatter of the height does not show";
    for (auto const* row : {"5", "2400"}) {
        EXPECT_EQ(overturn(folder, {"replay", "subset.h5", "--rare", "block", "--trial", row}).code, 0);
    }
}

// a limit state of the user's own has rare events too: subset simulation agrees with plain trials, on any
// ranks to the same bytes, and its rows replay.
TEST_F(Rare, LimitsOfTheUsersOwnAreEstimated) {
    auto const limited = [&](std::string const& rare) {
        auto text = campaign(rare, "measure='factor'\nvalues=[1.5]");
        text.insert(text.find("restitution=0.85"), "friction=0.4\n");
        return text + "[measures]\nenergy=false\n[[limits]]\nname='slides'\nquantity='peak_slip'\nabove='0.3 m'\n"
               + "[[limits]]\nname='moves'\nany=['overturning','slides']\n";
    };
    folder.write("crude.toml", limited("method='crude'\nmax_runs=40000\ntarget_cov=0.05"));
    folder.write("subset.toml", limited("method='subset'"));
    ASSERT_EQ(execute(folder, mpirun(1, {"run", "crude.toml"})).code, 0);
    ASSERT_EQ(execute(folder, mpirun(1, {"run", "subset.toml"})).code, 0);
    ASSERT_EQ(execute(folder, mpirun(3, {"run", "subset.toml", "-o", "three.h5"})).code, 0);
    EXPECT_TRUE(folder.read("subset.h5") == folder.read("three.h5"));
    auto const crude = answers("crude.h5");
    auto const subset = answers("subset.h5");

    ASSERT_EQ(crude.size(), 3U);
    EXPECT_EQ(crude[0].at("limit"), "overturning");
    EXPECT_EQ(crude[1].at("limit"), "slides");
    EXPECT_EQ(crude[2].at("limit"), "moves");
    EXPECT_TRUE(crude[0].at("probability").is_null()) << "it slides before it rocks";
    for (std::size_t const l : {1U, 2U}) {
        EXPECT_EQ(crude[l].at("state"), "trusted") << crude[l].dump();
        EXPECT_EQ(subset[l].at("state"), "trusted") << subset[l].dump();
        EXPECT_LT(subset[l].at("lower"), crude[l].at("upper"));
        EXPECT_GT(subset[l].at("upper"), crude[l].at("lower"));
    }
    for (auto const* limit : {"slides", "moves"}) {
        auto const row =
            overturn(folder, {"replay", "subset.h5", "--rare", "block", "--limit", limit, "--trial", "2500"});
        EXPECT_EQ(row.code, 0) << row.out << row.err;
    }
    EXPECT_EQ(overturn(folder, {"replay", "subset.h5", "--rare", "block", "--limit", "no", "--trial", "0"}).code, 2);
}

// a campaign whose levels, waves or bodies these estimators are not for is refused at the line concerned,
// with the reason and what to do.
TEST_F(Rare, RefusesWhatItIsNotFor) {
    auto const pga = refusal(campaign("method='auto'", "measure='pga'\nvalues=['400 gal']"));
    EXPECT_NE(pga.find("bad.toml:20:"), std::string::npos) << pga;
    EXPECT_NE(pga.find("factor"), std::string::npos) << pga;
    auto const matched =
        refusal(campaign("method='pulse-mixture'", "measure='factor'\nvalues=[1]",
                         "source='spectrum-compatible'\nmatch='each'\ntarget={spectrum='mlit-ch1'}\n"));
    EXPECT_NE(matched.find("not linear"), std::string::npos) << matched;
    auto const pulse = refusal(campaign("method='auto'", "measure='factor'\nvalues=[1]",
                                        "source='harmonic'\nfrequencies=['1 Hz','2 Hz','3 Hz']\namplitude='1 m/s2'\n"));
    EXPECT_NE(pulse.find("at random"), std::string::npos) << pulse;
    auto const method = refusal(campaign("method='subsett'"));
    EXPECT_NE(method.find("subset"), std::string::npos) << method;
    auto const unknown = refusal(campaign("cov=0.1"));
    EXPECT_NE(unknown.find("cov"), std::string::npos) << unknown;
    folder.write("c.toml", campaign("method='crude'"));
    auto const part = overturn(folder, {"run", "c.toml", "--part", "1/2"});
    EXPECT_EQ(part.code, 2);
    EXPECT_NE(part.err.find("[rare]"), std::string::npos) << part.err;
}

}  // namespace
}  // namespace overturn::testing
