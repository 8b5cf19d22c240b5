// Requirement R-1101, R-1102: a rank that stops while all merge holds up nobody, whatever it is at; if rank 0 stops,
// the others end at the time limit. The file has the bytes of one rank's.
#include <cstdlib>
#include <ctime>

#include "cli/campaign_files.hpp"
#include "support/command.hpp"

namespace overturn::testing {
namespace {

using Clock = std::chrono::steady_clock;

/// A rank that stops at a call on a file whose name ends so.
struct Stop {
    int ranks, rank;
    char const *call, *at;
};

class Merging : public ::testing::Test {
  protected:
    Merging() {
        folder.write("target.csv", target_csv);
        folder.write("c.toml", small_campaign("independent", 20));
    }
    ~Merging() override {
        if (auto const pid = stopped(); pid > 0) {
            ::kill(pid, SIGKILL);
        }
    }

    /// The bytes that one rank makes.
    std::string one() const {
        auto const alone = overturn(folder, {"run", "c.toml", "-o", "one.h5"});
        EXPECT_EQ(alone.code, 0) << alone.err;
        return folder.read("one.h5");
    }
    std::vector<std::string> stopping(Stop const& stop, std::vector<std::string> const& arguments) const {
        std::vector<std::string> const environment{"/usr/bin/env",
                                                   "LD_PRELOAD=" OVERTURN_STOP_LIBRARY,
                                                   fmt::format("OVERTURN_STOP_RANK={}", stop.rank),
                                                   fmt::format("OVERTURN_STOP_CALL={}", stop.call),
                                                   fmt::format("OVERTURN_STOP_AT={}", stop.at),
                                                   "OVERTURN_STOP_SAYS=" + (folder / "stopped").string()};
        return joined(environment, mpirun(stop.ranks, arguments));
    }
    /// The rank that has stopped; 0: none yet.
    pid_t stopped() const { return std::atoi(folder.read("stopped").c_str()); }

    Folder folder;
};

class MergingWithAStoppedRank : public Merging, public ::testing::WithParamInterface<Stop> {};

TEST_P(MergingWithAStoppedRank, GoesOn) {
    auto const bytes = one();
    Running running(folder, stopping(GetParam(), {"run", "c.toml"}));
    ASSERT_TRUE(comes_true([&] { return stopped() > 0; }));
    EXPECT_TRUE(comes_true([&] { return folder.has("c.h5") && !folder.has("c.h5.parts"); }));
    EXPECT_TRUE(folder.read("c.h5") == bytes) << "while a rank is stopped";
    ::kill(stopped(), SIGCONT);

    auto const ended = running.wait();
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_TRUE(folder.read("c.h5") == bytes) << "after what the late rank wrote";
    EXPECT_FALSE(folder.has("c.h5.parts"));
    EXPECT_FALSE(folder.has("c.h5.merging"));
    EXPECT_TRUE(folder.has("c.runtime.json"));
}

INSTANTIATE_TEST_SUITE_P(Phases, MergingWithAStoppedRank,
                         ::testing::Values(Stop{3, 2, "open", ".merging"}, Stop{3, 1, "open", ".merging"},
                                           Stop{2, 1, "open", ".merging"}, Stop{3, 2, "read", ".merging"},
                                           Stop{3, 2, "unlink", ".block"}),
                         [](auto const& info) {
                             return fmt::format("{}{}of{}", info.param.call, info.param.rank, info.param.ranks);
                         });

/// One that never goes on: the file is whole, and the job ends with a code after which the same command finds that.
TEST_F(Merging, EndsWithoutARankThatDoesNotComeBack) {
    auto const bytes = one();
    Running running(folder, stopping({3, 2, "open", ".merging"}, {"run", "c.toml"}));
    ASSERT_TRUE(comes_true([&] { return stopped() > 0; }));

    auto const ended = running.wait();
    EXPECT_EQ(ended.code, 3) << ended.err;
    EXPECT_NE(ended.err.find("a rank has not answered"), std::string::npos) << ended.err;
    EXPECT_NE(ended.err.find("What is merged is complete"), std::string::npos) << ended.err;
    EXPECT_NE(ended.out.find("results: c.h5"), std::string::npos) << ended.out;
    EXPECT_TRUE(folder.read("c.h5") == bytes);
    EXPECT_FALSE(folder.has("c.h5.parts"));
    auto const again = overturn(folder, {"run", "c.toml", "--resume"});
    EXPECT_EQ(again.code, 0) << again.err;
    EXPECT_NE(again.out.find("complete already"), std::string::npos) << again.out;
}

/// What is wrong with a block is said, though a rank does not come.
TEST_F(Merging, FailsWithoutARankThatDoesNotComeBack) {
    ASSERT_EQ(overturn(folder, {"run", "c.toml", "--leave-blocks"}).code, 0);
    auto block = folder.read("c.h5.parts/0000000004.block");
    block[block.size() / 2] ^= 1;
    folder.write("c.h5.parts/0000000004.block", block);
    Running running(folder, stopping({3, 2, "open", ".merging"}, {"merge", "c.h5"}));
    ASSERT_TRUE(comes_true([&] { return stopped() > 0; }));

    auto const ended = running.wait();
    EXPECT_EQ(ended.code, 1) << ended.err;
    EXPECT_NE(ended.err.find("a rank has not answered"), std::string::npos) << ended.err;
    EXPECT_NE(ended.err.find("0000000004.block: damaged"), std::string::npos) << ended.err;
    EXPECT_FALSE(folder.has("c.h5"));
    EXPECT_EQ(blocks_done(folder, "c.h5"), 60);
}

/// Nobody leads if rank 0 is stopped: the limit of time, or the end of the job, ends the others.
TEST_F(Merging, EndsAtTheLimitWithoutRankZero) {
    auto const bytes = one();
    Stop const stop{3, 0, "open", ".merging"};
    auto const begin = Clock::now();
    auto const run = execute(folder, stopping(stop, {"run", "c.toml", "--max-walltime", "3 s"}));

    EXPECT_EQ(run.code, 3) << run.err;
    EXPECT_GT(stopped(), 0);
    EXPECT_NE(run.err.find("time is up, and a rank has not answered"), std::string::npos) << run.err;
    EXPECT_LT(std::chrono::duration<double>(Clock::now() - begin).count(), 40) << "3 s, 10 of patience, 2 for its turn";
    EXPECT_EQ(blocks_done(folder, "c.h5"), 60);

    std::filesystem::remove(folder / "stopped");
    auto const job_end = fmt::format("SLURM_JOB_END_TIME={}", std::time(nullptr) + 3);
    auto const merge = execute(folder, joined({"/usr/bin/env", job_end}, stopping(stop, {"merge", "c.h5"})));
    EXPECT_EQ(merge.code, 3) << merge.err;
    EXPECT_GT(stopped(), 0);
    EXPECT_NE(merge.err.find("Blocks on disk are kept: merge again"), std::string::npos) << merge.err;
    EXPECT_EQ(blocks_done(folder, "c.h5"), 60);

    auto const again = execute(folder, mpirun(2, {"merge", "c.h5"}));
    EXPECT_EQ(again.code, 0) << again.err;
    EXPECT_TRUE(folder.read("c.h5") == bytes);
}

}  // namespace
}  // namespace overturn::testing
