// Requirement R-1105: a disk that reports an error (EIO), a spent quota (EDQUOT) or fails to sync is one line and exit
// code 1 at whatever instant, what was committed stays good, and --resume gives the bytes of a run that met no trouble.
#include <cerrno>
#include <cstring>

#include "cli/campaign_files.hpp"
#include "support/command.hpp"

namespace overturn::testing {
namespace {

struct Trouble {
    std::string call;    ///< which fails: write, fsync or any
    int reason;          ///< errno; 0: each call is slow
    std::string advice;  ///< what is said to do
};

class BadDisk : public ::testing::Test {
  protected:
    BadDisk() {
        folder.write("target.csv", target_csv);
        folder.write("c.toml", small_campaign("independent", 5));
        EXPECT_EQ(overturn(folder, {"run", "c.toml", "-o", "unbroken.h5"}).code, 0);
    }
    [[nodiscard]] Ended run(Trouble const& trouble, int after, std::vector<std::string> const& command) const {
        return execute(folder, joined({"/usr/bin/env", "LD_PRELOAD=" OVERTURN_BAD_DISK, "OVERTURN_BAD_DISK_AT=/c.h5",
                                       "OVERTURN_BAD_DISK_CALL=" + trouble.call,
                                       "OVERTURN_BAD_DISK_ERRNO=" + std::to_string(trouble.reason),
                                       "OVERTURN_BAD_DISK_AFTER=" + std::to_string(after)},
                                      command));
    }
    void expect_one_error(Ended const& ended, Trouble const& trouble) const {
        EXPECT_EQ(ended.code, 1) << ended.err;
        auto const at = ended.err.find("overturn: ");
        ASSERT_NE(at, std::string::npos) << ended.err;
        auto const line = ended.err.substr(at);
        EXPECT_TRUE(is_one_error_line(line));
        EXPECT_NE(line.find(std::strerror(trouble.reason)), std::string::npos) << line;
        EXPECT_NE(line.find(trouble.advice), std::string::npos) << line;
    }
    void expect_resumed() const {
        EXPECT_FALSE(folder.has("c.h5"));
        auto const resumed = overturn(folder, {"run", "c.toml", "-o", "c.h5", "--resume"});
        EXPECT_EQ(resumed.code, 0) << resumed.err;
        EXPECT_TRUE(folder.read("c.h5") == folder.read("unbroken.h5"));
        EXPECT_FALSE(folder.has("c.h5.parts"));
        std::filesystem::remove(folder / "c.h5");
    }

    Folder folder;
};

std::vector<Trouble> const troubles{{"write", EIO, "Check the disk, then go on with --resume"},
                                    {"write", EDQUOT, "Free space or choose another place, then go on with --resume"},
                                    {"fsync", EIO, "Check the disk, then go on with --resume"},
                                    {"fsync", EDQUOT, "Free space or choose another place, then go on with --resume"},
                                    {"any", EIO, "Check the disk, then go on with --resume"}};

/// From the first call on, through a run's record, blocks, merging, digests and seal.
TEST_F(BadDisk, AtWhateverInstantOfARun) {
    for (auto const& trouble : troubles) {
        int met = 0;
        for (int after = 0;; after = 2 * after + 1) {
            SCOPED_TRACE(trouble.call + " " + std::strerror(trouble.reason) + " after " + std::to_string(after));
            auto const ended = run(trouble, after, {OVERTURN_PROGRAM, "run", "c.toml", "-o", "c.h5"});
            if (ended.code == 0) {  // so few calls are made
                EXPECT_TRUE(folder.read("c.h5") == folder.read("unbroken.h5"));
                std::filesystem::remove(folder / "c.h5");
                break;
            }
            ++met;
            expect_one_error(ended, trouble);
            expect_resumed();
            if (HasFailure()) {
                return;
            }
        }
        EXPECT_GT(met, 4) << trouble.call;
    }
}

TEST_F(BadDisk, UnderMpiOneRankSpeaks) {
    auto const& trouble = troubles.front();
    expect_one_error(run(trouble, 6, mpirun(2, {"run", "c.toml", "-o", "c.h5"})), trouble);
    expect_resumed();
}

/// Merge knows no --resume.
TEST_F(BadDisk, UnderMergeTheAdviceIsToMergeAgain) {
    ASSERT_EQ(overturn(folder, {"run", "c.toml", "-o", "c.h5", "--leave-blocks"}).code, 0);
    Trouble const trouble{"write", ENOSPC,
                          "Free space or choose another place, then merge again: all blocks are kept in c.h5.parts "
                          "(to merge elsewhere, move it there)"};
    for (auto const& command :
         {std::vector<std::string>{OVERTURN_PROGRAM, "merge", "c.h5"}, mpirun(2, {"merge", "c.h5"})}) {
        auto const ended = run(trouble, 0, command);
        expect_one_error(ended, trouble);
        EXPECT_EQ(ended.err.find("--resume"), std::string::npos) << ended.err;
    }
    std::filesystem::create_directory(folder / "elsewhere");
    std::filesystem::rename(folder / "c.h5.parts", folder / "elsewhere/c.h5.parts");
    EXPECT_EQ(overturn(folder, {"merge", "elsewhere/c.h5"}).code, 0);
    EXPECT_TRUE(folder.read("elsewhere/c.h5") == folder.read("unbroken.h5"));
}

TEST_F(BadDisk, SlowIsNoTrouble) {
    auto const ended = run({"fsync", 0, ""}, 0, {OVERTURN_PROGRAM, "run", "c.toml", "-o", "c.h5"});
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_TRUE(folder.read("c.h5") == folder.read("unbroken.h5"));
}

}  // namespace
}  // namespace overturn::testing
