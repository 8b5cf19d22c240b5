// Requirement R-1001, R-1103: one campaign split over array tasks and merged gives the bytes of one run; what is
// missing, foreign or in use is said.
#include <csignal>

#include <nlohmann/json.hpp>

#include "cli/campaign_files.hpp"
#include "support/command.hpp"

namespace overturn::testing {
namespace {

int times(std::string const& text, std::string const& part) {
    int count = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) {
        ++count;
    }
    return count;
}

class Parts : public ::testing::Test {
  protected:
    Parts() {
        folder.write("target.csv", target_csv);
        folder.write("c.toml", small_campaign("independent", 7));
    }

    Ended part(std::string const& which, std::vector<std::string> const& more = {}) const {
        return overturn(folder, joined({"run", "c.toml", "--part", which}, more));
    }
    Ended merge() const { return overturn(folder, {"merge", "c.h5"}); }
    void expect_part_done(Ended const& ended) const {
        EXPECT_EQ(ended.code, 0) << ended.err;
        EXPECT_NE(ended.out.find("overturn merge c.h5"), std::string::npos) << ended.out;
        EXPECT_FALSE(folder.has("c.h5"));
    }
    void expect_as_one_run() const {
        auto const one = overturn(folder, {"run", "c.toml", "-o", "one.h5"});
        EXPECT_EQ(one.code, 0) << one.err;
        EXPECT_TRUE(folder.read("c.h5") == folder.read("one.h5"));
    }

    Folder folder;
};

/// A library upgraded between two tasks may move a bit: their blocks are never put together.
TEST_F(Parts, OfOtherLibrariesAreNotMixed) {
    auto const other = execute(folder, {"/usr/bin/env", "LD_PRELOAD=" OVERTURN_OTHER_QUANTILE, OVERTURN_PROGRAM, "run",
                                        "c.toml", "--part", "1/2"});
    ASSERT_EQ(other.code, 0) << other.err;
    for (auto const& ended : {part("2/2"), merge()}) {
        EXPECT_EQ(ended.code, 2) << ended.out;
        EXPECT_NE(ended.err.find("GSL 9.9"), std::string::npos) << ended.err;
        EXPECT_TRUE(is_one_error_line(ended.err)) << ended.err;
    }
    EXPECT_FALSE(folder.has("c.h5"));
}

TEST_F(Parts, MergedAreTheBytesOfOneRun) {
    expect_part_done(part("2/3"));
    expect_part_done(execute(folder, mpirun(2, {"run", "c.toml", "--part", "3/3"})));
    expect_part_done(part("1/3"));
    EXPECT_FALSE(folder.has("c.runtime.json"));

    auto const merged = merge();
    EXPECT_EQ(merged.code, 0) << merged.err;
    EXPECT_NE(merged.out.find("results: c.h5"), std::string::npos) << merged.out;
    EXPECT_FALSE(folder.has("c.h5.parts"));
    auto const runtime = nlohmann::json::parse(folder.read("c.runtime.json"));
    ASSERT_EQ(runtime.at("segments").size(), 3U) << "one file tells of all parts";
    EXPECT_EQ(runtime.at("segments")[1].at("part"), "3/3");
    EXPECT_EQ(runtime.at("ranks").size(), 4U);
    EXPECT_EQ(runtime.at("trials"), 42);
    double wall_s = runtime.at("merge_s");
    EXPECT_GT(wall_s, 0);
    for (auto const& segment : runtime.at("segments")) {
        EXPECT_EQ(segment.at("merge_s"), 0);
        wall_s += segment.at("wall_s").get<double>();
    }
    EXPECT_DOUBLE_EQ(runtime.at("wall_s"), wall_s);
    expect_as_one_run();

    auto const again = merge();  // a job that is requeued
    EXPECT_EQ(again.code, 0) << again.err;
    EXPECT_NE(again.out.find("complete already"), std::string::npos) << again.out;
}

/// More ranks than blocks of a part, and an odd number of them. What is wrong is said once, with the code of one rank.
TEST_F(Parts, AreMergedBySeveralRanks) {
    auto const merge_on = [&](int ranks) { return execute(folder, mpirun(ranks, {"merge", "c.h5"})); };
    expect_part_done(part("2/2"));
    auto const missing = merge_on(2);
    EXPECT_EQ(missing.code, 3) << missing.err;
    auto const said = missing.err.find("waves 0 to 9 are missing");
    EXPECT_NE(said, std::string::npos) << missing.err;
    EXPECT_EQ(missing.err.find("are missing", said + 20), std::string::npos) << missing.err;
    expect_part_done(part("1/2"));
    auto const block = folder.read("c.h5.parts/0000000004.block");
    auto damaged = block;
    damaged[block.size() / 2] ^= 1;
    folder.write("c.h5.parts/0000000004.block", damaged);
    auto const refused = merge_on(3);
    EXPECT_EQ(refused.code, 3);
    EXPECT_EQ(times(refused.err, "0000000004.block: damaged"), 1) << refused.err;
    EXPECT_NE(refused.err.find("waves 4 to 4 are missing"), std::string::npos) << refused.err;
    EXPECT_FALSE(folder.has("c.h5"));
    EXPECT_FALSE(folder.has("c.h5.merging"));

    folder.write("c.h5.parts/0000000004.block", block);
    auto const merged = merge_on(3);
    EXPECT_EQ(merged.code, 0) << merged.err;
    EXPECT_FALSE(folder.has("c.h5.parts"));
    expect_as_one_run();
    auto const again = merge_on(2);
    EXPECT_EQ(again.code, 0) << again.err;
    EXPECT_NE(again.out.find("complete already"), std::string::npos) << again.out;
}

/// Many ranks need not wait for the one that merges: a job of one rank makes the file of the blocks that they leave.
TEST_F(Parts, OfOneRunAreLeftForMerge) {
    auto const run = [&](std::vector<std::string> const& more) {
        return execute(folder, mpirun(2, joined({"run", "c.toml", "--leave-blocks"}, more)));
    };
    auto const extending = run({"--extend"});
    EXPECT_EQ(extending.code, 2);
    EXPECT_NE(extending.err.find("--leave-blocks beside --extend"), std::string::npos) << extending.err;
    expect_part_done(run({}));
    EXPECT_FALSE(folder.has("c.runtime.json"));
    auto const so_far = overturn(folder, {"fit", "c.h5", "--interim", "--json"});
    EXPECT_EQ(nlohmann::json::parse(so_far.out).at("interim").at("waves"), 21) << so_far.err;
    expect_part_done(run({"--resume"}));

    EXPECT_EQ(merge().code, 0);
    EXPECT_EQ(nlohmann::json::parse(folder.read("c.runtime.json")).at("trials"), 42);
    expect_as_one_run();
}

/// More parts than blocks, all at once, as an array starts them.
TEST_F(Parts, StartedTogetherDoNotDisturbEachOther) {
    folder.write("c.toml", small_campaign("shared", 3));
    std::vector<std::unique_ptr<Running>> tasks;
    for (std::string const which : {"1/4", "2/4", "3/4", "4/4"}) {
        tasks.push_back(std::make_unique<Running>(
            folder, std::vector<std::string>{OVERTURN_PROGRAM, "run", "c.toml", "--part", which}));
    }
    for (auto& task : tasks) {
        expect_part_done(task->wait());
    }
    EXPECT_EQ(merge().code, 0);
    expect_as_one_run();
    auto const again = merge();
    EXPECT_EQ(again.code, 0);
    EXPECT_EQ(again.out, "c.h5: complete already; nothing to merge\n");
}

/// What finds no work says so: parts beyond the number of blocks, and ranks.
TEST_F(Parts, WithoutABlock) {
    folder.write("c.toml", small_campaign("shared", 3));
    auto const without = part("1/4");
    expect_part_done(without);
    EXPECT_EQ(without.out,
              "part 1/4: has no block, nothing to do (there are more parts than blocks). When all parts are done: "
              "overturn merge c.h5\n");
    expect_part_done(part("2/4"));
    auto const ended = execute(folder, mpirun(5, {"run", "c.toml", "--resume"}));
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(times(ended.err, "warning: 3 blocks for 5 ranks: 2 of them have none\n"), 1) << ended.err;
    expect_as_one_run();
    auto const enough = execute(folder, mpirun(3, {"run", "c.toml", "-o", "three.h5"}));
    EXPECT_EQ(times(enough.err, " ranks: "), 0) << enough.err;
}

// missing parts are named by their waves, with exit code 3, and can be run then.
TEST_F(Parts, MissingOnesAreNamed) {
    expect_part_done(part("1/3"));
    expect_part_done(part("3/3"));

    auto const missing = merge();
    EXPECT_EQ(missing.code, 3);
    EXPECT_NE(missing.err.find("waves 7 to 13 are missing (7 of 21 blocks)"), std::string::npos) << missing.err;
    EXPECT_NE(missing.err.find("overturn run c.toml -o c.h5 --resume"), std::string::npos) << missing.err;
    EXPECT_FALSE(folder.has("c.h5"));
    auto const status = overturn(folder, {"status", "c.h5"});
    EXPECT_EQ(status.code, 3);
    EXPECT_NE(status.out.find("waves 7 to 13"), std::string::npos) << status.out;

    auto const rest = execute(folder, mpirun(2, {"run", "c.toml", "--resume"}));  // the whole, without merge
    EXPECT_EQ(rest.code, 0) << rest.err;
    expect_as_one_run();
}

// R-1103: a damaged block counts as missing and is said.
TEST_F(Parts, DamagedBlockIsComputedAgain) {
    for (auto const* which : {"1/2", "2/2"}) {
        expect_part_done(part(which));
    }
    auto block = folder.read("c.h5.parts/0000000004.block");
    block[block.size() / 2] ^= 1;
    folder.write("c.h5.parts/0000000004.block", block);
    folder.write("c.h5.parts/notes.block", "shopping list");

    auto const refused = merge();
    EXPECT_EQ(refused.code, 3);
    auto const told = nlohmann::json::parse(overturn(folder, {"status", "c.h5", "--json"}).out);
    EXPECT_EQ(told["blocks"]["left"], 1);
    EXPECT_TRUE(told["next"].get<std::string>().starts_with("overturn run c.toml -o c.h5 --resume")) << told["next"];
    EXPECT_EQ(times(refused.err, "0000000004.block: damaged"), 1) << refused.err;
    EXPECT_EQ(times(refused.err, "notes.block: not a block of this run"), 1) << refused.err;
    EXPECT_NE(refused.err.find("waves 4 to 4 are missing"), std::string::npos) << refused.err;

    expect_part_done(part("1/2", {"--resume"}));
    EXPECT_EQ(merge().code, 0);
    EXPECT_EQ(folder.read("c.h5.parts/notes.block"), "shopping list");
    expect_as_one_run();
}

// R-1105: whatever came to lie at the output, the blocks beside it are kept, and every verb says what to do.
TEST_F(Parts, AreKeptBesideAFileThatIsNoneOfTheirs) {
    expect_part_done(part("1/2"));
    expect_part_done(part("2/2"));
    auto const whole = [&] {
        auto const one = overturn(folder, {"run", "c.toml", "-o", "one.h5"});
        EXPECT_EQ(one.code, 0) << one.err;
        return folder.read("one.h5");
    }();
    std::string const advice =
        "Move it away, then overturn merge c.h5 or overturn run --resume: the finished blocks in c.h5.parts are kept "
        "(21)";
    for (auto const& content : {std::string("garbage\n"), std::string(), whole.substr(0, whole.size() / 2)}) {
        folder.write("c.h5", content);
        for (auto const& ended :
             {overturn(folder, {"run", "c.toml", "--resume"}), merge(), execute(folder, mpirun(2, {"merge", "c.h5"})),
              overturn(folder, {"status", "c.h5"}), overturn(folder, {"fit", "c.h5"})}) {
            EXPECT_EQ(ended.code, 2) << ended.out;
            EXPECT_TRUE(is_one_error_line(ended.err));
            EXPECT_NE(ended.err.find("c.h5: not an HDF5 file"), std::string::npos) << ended.err;
            EXPECT_NE(ended.err.find(advice), std::string::npos) << ended.err;
        }
        auto const plain = overturn(folder, {"run", "c.toml"});
        EXPECT_TRUE(is_one_error_line(plain.err));
        EXPECT_NE(plain.err.find("c.h5.parts holds 21 finished blocks of a run). See overturn status c.h5"),
                  std::string::npos)
            << plain.err;
        EXPECT_EQ(folder.read("c.h5"), content);
    }
    std::filesystem::remove(folder / "c.h5");
    std::filesystem::create_directory(folder / "c.h5");
    for (auto const& ended : {overturn(folder, {"run", "c.toml", "--resume"}), merge()}) {
        EXPECT_TRUE(is_one_error_line(ended.err));
        EXPECT_NE(ended.err.find(advice), std::string::npos) << ended.err;
    }
    EXPECT_EQ(blocks_done(folder, "c.h5"), 21);

    std::filesystem::rename(folder / "c.h5", folder / "away");
    std::filesystem::remove(folder / "one.h5");
    EXPECT_EQ(merge().code, 0);
    expect_as_one_run();
}

// R-1103: parts of different campaigns never come together, and nothing is done twice silently.
TEST_F(Parts, OthersAreRefused) {
    expect_part_done(part("1/2"));

    auto const twice = part("1/2");
    EXPECT_EQ(twice.code, 2);
    EXPECT_TRUE(is_one_error_line(twice.err));
    EXPECT_NE(twice.err.find("part 1/2 (has been begun there)"), std::string::npos) << twice.err;
    auto const other = part("2/2", {"--set", "seed=3"});
    EXPECT_EQ(other.code, 2);
    EXPECT_TRUE(is_one_error_line(other.err));
    EXPECT_NE(other.err.find("seed was 2013, is 3"), std::string::npos) << other.err;
    auto const whole = overturn(folder, {"run", "c.toml"});
    EXPECT_EQ(whole.code, 2);
    EXPECT_TRUE(is_one_error_line(whole.err));

    for (auto const* odd : {"0/2", "3/2", "1", "1/", "/2", "1/2/3", "a/b", "-1/2", "1/99999999999999999999"}) {
        auto const ended = part(odd);
        EXPECT_EQ(ended.code, 2) << odd;
        EXPECT_TRUE(is_one_error_line(ended.err)) << odd;
        EXPECT_NE(ended.err.find("--part"), std::string::npos) << ended.err;
    }
    auto const nothing = overturn(folder, {"merge", "none.h5"});
    EXPECT_EQ(nothing.code, 2);
    EXPECT_TRUE(is_one_error_line(nothing.err));
}

// R-1105: of two campaigns that write one output at once, the second is refused in one line.
TEST_F(Parts, TheSecondRunOnOneOutputIsRefused) {
    folder.write("c.toml", small_campaign("independent", 500));
    Running first(folder, {OVERTURN_PROGRAM, "run", "c.toml"});
    ASSERT_TRUE(comes_true([&] { return blocks_done(folder, "c.h5") > 2; }));
    first.signal(SIGSTOP);  // it holds its output for as long as others are tried beside it

    for (auto const& second : {overturn(folder, {"run", "c.toml"}), overturn(folder, {"run", "c.toml", "--resume"}),
                               part("2/2"), execute(folder, mpirun(2, {"run", "c.toml", "--resume"})), merge()}) {
        EXPECT_EQ(second.code, 1) << second.err;
        EXPECT_TRUE(is_one_error_line(second.err));
        EXPECT_NE(second.err.find("another run is writing there now"), std::string::npos) << second.err;
    }
    auto const status = overturn(folder, {"status", "c.h5"});
    EXPECT_EQ(status.code, 3);
    EXPECT_NE(status.out.find("a run is under way"), std::string::npos) << status.out;
    first.signal(SIGCONT);
    EXPECT_EQ(first.wait().code, 0);
    expect_as_one_run();
}

// R-1103: blocks that a run left after its file was durable are recognised and said.
TEST_F(Parts, LeftoverBlocksAreCleanedUp) {
    expect_part_done(part("1/1000"));
    std::filesystem::rename(folder / "c.h5.parts", folder / "kept");
    ASSERT_EQ(overturn(folder, {"run", "c.toml"}).code, 0);
    std::filesystem::rename(folder / "kept", folder / "c.h5.parts");

    auto const resumed = overturn(folder, {"run", "c.toml", "--resume"});
    EXPECT_EQ(resumed.code, 0) << resumed.err;
    EXPECT_NE(resumed.err.find("blocks left over"), std::string::npos) << resumed.err;
    EXPECT_FALSE(folder.has("c.h5.parts"));

    std::filesystem::create_directory(folder / "c.h5.parts");  // a kill came when all but the lock had gone
    folder.write("c.h5.parts/lock", "");
    EXPECT_EQ(merge().code, 0);
    EXPECT_FALSE(folder.has("c.h5.parts"));

    std::filesystem::create_directory(folder / "c.h5.parts");  // and these are somebody else's
    folder.write("c.h5.parts/0000000003.block", "not ours");
    EXPECT_EQ(merge().code, 0);
    EXPECT_EQ(folder.read("c.h5.parts/0000000003.block"), "not ours");
    expect_as_one_run();
}

}  // namespace
}  // namespace overturn::testing
