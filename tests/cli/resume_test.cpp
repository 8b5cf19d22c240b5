// Requirement R-1101, R-1103: a run that was stopped or killed at any time is resumed, on any number of ranks, to the
// very bytes of an unbroken one.
#include "cli/campaign_files.hpp"
#include "support/command.hpp"

namespace overturn::testing {
namespace {

class Resume : public ::testing::Test {
  protected:
    Resume() {
        folder.write("target.csv", target_csv);
        folder.write("c.toml", small_campaign("independent", 100));
    }

    void expect_as_unbroken() {
        auto const resumed = execute(folder, mpirun(3, {"run", "c.toml", "--resume"}));
        EXPECT_EQ(resumed.code, 0) << resumed.err;
        EXPECT_NE(resumed.err.find("resuming c.h5"), std::string::npos) << resumed.err;
        EXPECT_EQ(overturn(folder, {"status", "c.h5"}).code, 0);
        EXPECT_FALSE(folder.has("c.h5.parts"));
        auto const unbroken = execute(folder, mpirun(2, {"run", "c.toml", "-o", "unbroken.h5"}));
        EXPECT_EQ(unbroken.code, 0) << unbroken.err;
        EXPECT_TRUE(folder.read("c.h5") == folder.read("unbroken.h5"));
    }

    void expect_resumable(Ended const& ended) {
        EXPECT_EQ(ended.code, 3);
        EXPECT_NE(ended.err.find("--resume"), std::string::npos) << ended.err;
        EXPECT_FALSE(folder.has("c.h5"));
        auto const status = overturn(folder, {"status", "c.h5"});
        EXPECT_EQ(status.code, 3);
        EXPECT_NE(status.out.find("not complete"), std::string::npos) << status.out;
    }

    Folder folder;
};

// R-1102: --max-walltime stops in time with exit code 3.
TEST_F(Resume, AfterTheWalltimeIsUp) {
    auto const ended = overturn(folder, {"run", "c.toml", "--max-walltime", "0.05 s"});

    expect_resumable(ended);
    expect_as_unbroken();
}

// R-1102: SIGUSR1 and SIGTERM finish the current block, commit and exit 3.
TEST_F(Resume, AfterASignalToMpirun) {
    Running running(folder, mpirun(2, {"run", "c.toml"}));
    ASSERT_TRUE(comes_true([&] { return blocks_done(folder, "c.h5") > 5; }));
    running.signal(SIGUSR1);

    expect_resumable(running.wait());

    Running again(folder, {OVERTURN_PROGRAM, "run", "c.toml", "--resume"});
    auto const before = blocks_done(folder, "c.h5");
    ASSERT_TRUE(comes_true([&] { return blocks_done(folder, "c.h5") > before + 2; }));
    EXPECT_TRUE(children_of(again.pid()).empty()) << "no launcher, so no daemon beside it either";
    again.signal(SIGTERM);

    expect_resumable(again.wait());
    expect_as_unbroken();
}

// R-1101: a kill loses no byte of trials on points and in space either.
TEST_F(Resume, AfterAKillOnPoints) {
    folder.write("c.toml", campaign_on_points(24));
    {
        Running running(folder, {OVERTURN_PROGRAM, "run", "c.toml"});
        ASSERT_TRUE(comes_true([&] { return blocks_done(folder, "c.h5") > 3; }));
        running.signal(SIGKILL);
        EXPECT_EQ(running.wait().code, 128 + SIGKILL);
    }
    EXPECT_EQ(overturn(folder, {"status", "c.h5"}).code, 3);
    expect_as_unbroken();
}

// R-1101: SIGKILL loses only blocks under way.
TEST_F(Resume, AfterAKill) {
    {
        Running running(folder, {OVERTURN_PROGRAM, "run", "c.toml"});
        ASSERT_TRUE(comes_true([&] { return blocks_done(folder, "c.h5") > 3; }));
        running.signal(SIGKILL);
        EXPECT_EQ(running.wait().code, 128 + SIGKILL);
    }
    EXPECT_EQ(overturn(folder, {"status", "c.h5"}).code, 3);
    {
        Running running(folder, mpirun(2, {"run", "c.toml", "--resume"}));
        auto const before = blocks_done(folder, "c.h5");
        ASSERT_TRUE(comes_true([&] { return blocks_done(folder, "c.h5") > before + 3; }));
        auto const ranks = children_of(running.pid());
        ASSERT_EQ(ranks.size(), 2U);
        ::kill(ranks[0], SIGKILL);
        EXPECT_NE(running.wait().code, 0);
    }
    expect_as_unbroken();
}

// R-1103: --resume refuses a changed campaign and names the key; without --resume nothing is overwritten.
TEST_F(Resume, RefusesAnotherCampaign) {
    ASSERT_EQ(overturn(folder, {"run", "c.toml", "--max-walltime", "0.05 s"}).code, 3);

    auto const without = overturn(folder, {"run", "c.toml"});
    EXPECT_EQ(without.code, 2);
    EXPECT_TRUE(is_one_error_line(without.err));

    auto text = small_campaign("independent", 100);
    text.replace(text.find("friction=0.5"), 12, "friction=0.6");
    folder.write("c.toml", text);
    auto const key = overturn(folder, {"run", "c.toml", "--resume"});
    EXPECT_EQ(key.code, 2);
    EXPECT_TRUE(is_one_error_line(key.err));
    EXPECT_NE(key.err.find("friction (type-a) was 0.5, is 0.6"), std::string::npos) << key.err;

    folder.write("c.toml", small_campaign("independent", 100));
    auto const setting = overturn(folder, {"run", "c.toml", "--resume", "--set", "seed=3"});
    EXPECT_EQ(setting.code, 2);
    EXPECT_NE(setting.err.find("seed was 2013, is 3"), std::string::npos) << setting.err;

    folder.write("target.csv", target_csv + "12,0.3\n");
    auto const file = overturn(folder, {"run", "c.toml", "--resume"});
    EXPECT_EQ(file.code, 2);
    EXPECT_NE(file.err.find("target.csv changed"), std::string::npos) << file.err;
}

/// Where all blocks were computed before, no model has cost anything.
TEST_F(Resume, OfBlocksThatAreAllDoneNamesNoCost) {
    folder.write("c.toml", small_campaign("shared", 3));
    auto const first = overturn(folder, {"run", "c.toml", "--leave-blocks"});
    ASSERT_EQ(first.code, 0) << first.err;
    EXPECT_NE(first.err.find("cost: "), std::string::npos) << first.err;

    auto const rest = overturn(folder, {"run", "c.toml", "--resume"});
    EXPECT_EQ(rest.code, 0) << rest.err;
    EXPECT_EQ(rest.err.find("cost:"), std::string::npos) << rest.err;
}

TEST_F(Resume, OfAFinishedRunDoesNothing) {
    folder.write("c.toml", small_campaign("shared", 1));
    ASSERT_EQ(overturn(folder, {"run", "c.toml"}).code, 0);
    auto const before = folder.read("c.h5");

    auto const again = overturn(folder, {"run", "c.toml", "--resume"});
    EXPECT_EQ(again.code, 0);
    EXPECT_NE(again.out.find("complete already"), std::string::npos);
    EXPECT_TRUE(folder.read("c.h5") == before);
    auto const other = overturn(folder, {"run", "c.toml", "--resume", "--set", "seed=3"});
    EXPECT_EQ(other.code, 2);
    EXPECT_TRUE(is_one_error_line(other.err));
    EXPECT_TRUE(folder.read("c.h5") == before);
}

}  // namespace
}  // namespace overturn::testing
