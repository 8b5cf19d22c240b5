// Requirement R-1102: a run leaves when it is asked to, soon, with everything committed, and says how to go on.
#include <nlohmann/json.hpp>

#include "cli/campaign_files.hpp"
#include "support/command.hpp"

namespace overturn::testing {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

class Leaving : public ::testing::Test {
  protected:
    Leaving() { folder.write("target.csv", target_csv); }

    /// Blocks of 955 waves of 160 s: many seconds each, on a fast machine too.
    void write_long_blocks() const {
        auto campaign = small_campaign("shared", 1'000'000'000);
        std::string const short_wave = "20.48 s";
        campaign.replace(campaign.find(short_wave), short_wave.size(), "163.84 s");
        folder.write("c.toml", campaign);
    }
    void write_short_blocks(int waves = 100) const { folder.write("c.toml", small_campaign("independent", waves)); }

    Folder folder;
};

/// The one line on stderr that says how to go on.
void expect_reported(Ended const& ended, std::string const& command) {
    EXPECT_EQ(ended.code, 3) << ended.err;
    auto const at = ended.err.find("stopped early: ");
    ASSERT_NE(at, std::string::npos) << ended.err;
    auto const line = ended.err.substr(at, ended.err.find('\n', at) - at);
    EXPECT_NE(line.find("Go on with: " + command), std::string::npos) << line;
}

// R-1102: SIGTERM leaves within a second, however long a block is.
TEST_F(Leaving, WithinASecondOfSigterm) {
    write_long_blocks();
    Running running(folder, {OVERTURN_PROGRAM, "run", "c.toml"});
    ASSERT_TRUE(comes_true([&] { return folder.has("c.h5.parts/campaign.record"); }));
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    auto const begin = Clock::now();
    running.signal(SIGTERM);

    expect_reported(running.wait(), "overturn run c.toml -o c.h5 --resume");
    EXPECT_LT(seconds_since(begin), 2) << "a second, and another for a busy machine";
    EXPECT_EQ(blocks_done(folder, "c.h5"), 0);
}

// R-1102: the same where one wave's trials take longer than that: they run on points.
TEST_F(Leaving, WithinASecondOfSigtermOnPoints) {
    auto campaign = campaign_on_points(1);
    std::string const levels = "values=['300 gal','600 gal','1200 gal']";
    campaign.replace(campaign.find(levels), levels.size(), "values={from='600 gal', to='1200 gal', count=1000}");
    folder.write("c.toml", campaign);
    Running running(folder, {OVERTURN_PROGRAM, "run", "c.toml"});
    ASSERT_TRUE(comes_true([&] { return folder.has("c.h5.parts/campaign.record"); }));
    std::this_thread::sleep_for(std::chrono::seconds(1));
    auto const begin = Clock::now();
    running.signal(SIGTERM);

    expect_reported(running.wait(), "overturn run c.toml -o c.h5 --resume");
    EXPECT_LT(seconds_since(begin), 3) << "a second, and two for a busy machine";
    EXPECT_EQ(blocks_done(folder, "c.h5"), 0);
}

// R-1102: a launcher that delivers one request twice is no second request; a real second one leaves at once, and
// nothing is damaged.
TEST_F(Leaving, AtOnceOnASecondSignal) {
    write_long_blocks();
    Running running(folder, {OVERTURN_PROGRAM, "run", "c.toml"});
    ASSERT_TRUE(comes_true([&] { return folder.has("c.h5.parts/campaign.record"); }));
    std::this_thread::sleep_for(std::chrono::seconds(1));  // the first block is under way, on a busy machine too
    running.signal(SIGUSR1);
    running.signal(SIGUSR1);
    std::this_thread::sleep_for(std::chrono::milliseconds(600));
    running.signal(SIGUSR1);

    EXPECT_EQ(running.wait().code, 128 + SIGUSR1);
    auto const resumed = overturn(folder, {"run", "c.toml", "--resume", "--max-walltime", "0.1 s"});
    expect_reported(resumed, "overturn run c.toml -o c.h5 --resume");
    EXPECT_NE(resumed.err.find("stopped early: 0 of "), std::string::npos) << resumed.err;
}

// R-1102: no block is begun that would not end in time.
TEST_F(Leaving, BeforeTheWalltimeIsUp) {
    write_short_blocks(100'000);               // minutes even on a fast machine
    for (int const walltime_s : {2, 8, 20}) {  // the next where a busy machine finishes no block
        auto const begin = Clock::now();
        std::vector<std::string> words{"run", "c.toml", "--part", "1/2"};
        words.insert(words.end(), {"--max-walltime", fmt::format("{} s", walltime_s)});
        if (folder.has("c.h5.parts")) {
            words.emplace_back("--resume");
        }
        auto const ended = execute(folder, mpirun(2, words));

        expect_reported(ended, "overturn run c.toml -o c.h5 --resume --part 1/2");
        EXPECT_LT(seconds_since(begin), walltime_s + 20) << "one second that mpirun waits, more on a busy machine";
        if (blocks_done(folder, "c.h5") > 0) {
            return;
        }
    }
    FAIL() << "no block in 20 s";
}

// R-1102: a resumed run that stops counts all blocks of the campaign, and those of earlier runs among the done ones.
TEST_F(Leaving, CountsBlocksOfEarlierRuns) {
    write_short_blocks(100'000);
    auto const stopped = [&](std::string const& text) {
        std::int64_t done = -1, all = -1;
        auto const at = std::min(text.find("stopped early: "), text.size());
        (void)std::sscanf(text.c_str() + at, "stopped early: %ld of %ld blocks", &done, &all);
        return std::pair(done, all);
    };
    std::vector<std::string> const words{"run", "c.toml", "--resume", "--max-walltime", "3 s"};
    auto const [first, all] = stopped(overturn(folder, words).err);
    auto const resumed = overturn(folder, words);
    auto const [second, all_again] = stopped(resumed.err);
    ASSERT_GE(first, 0);
    EXPECT_EQ(all_again, all) << resumed.err;
    EXPECT_GE(second, first) << resumed.err;
    if (first > 0) {
        EXPECT_NE(resumed.err.find(fmt::format("resuming c.h5: {} of {} blocks", first, all)), std::string::npos)
            << resumed.err;
    }
}

// R-1101: a rank that dies takes the job down within seconds, and what is committed stays.
TEST_F(Leaving, WithinSecondsOfADeadRank) {
    write_short_blocks();
    Running running(folder, mpirun(3, {"run", "c.toml"}));
    ASSERT_TRUE(comes_true([&] { return blocks_done(folder, "c.h5") > 3; }));
    auto const before = blocks_done(folder, "c.h5");
    auto const ranks = children_of(running.pid());
    ASSERT_EQ(ranks.size(), 3U);
    auto const begin = Clock::now();
    ::kill(ranks[1], SIGKILL);

    EXPECT_NE(running.wait().code, 0);
    EXPECT_LT(seconds_since(begin), 6) << "2 s, and more on a busy machine";
    EXPECT_GE(blocks_done(folder, "c.h5"), before);
    EXPECT_EQ(execute(folder, mpirun(2, {"run", "c.toml", "--resume"})).code, 0);
}

// R-1101: blocks that a stopped rank holds are computed by the others; when it goes on, the file is the same.
TEST_F(Leaving, NotForAStoppedRank) {
    constexpr int waves = 400;
    write_short_blocks(waves);
    ASSERT_EQ(overturn(folder, {"run", "c.toml", "-o", "one.h5"}).code, 0);
    Running running(folder, mpirun(3, {"run", "c.toml"}));
    ASSERT_TRUE(comes_true([&] { return blocks_done(folder, "c.h5") > 3; }));
    auto const ranks = children_of(running.pid());
    ASSERT_EQ(ranks.size(), 3U);
    ::kill(ranks[1], SIGSTOP);
    auto const plan = nlohmann::json::parse(overturn(folder, {"plan", "c.toml", "--json"}).out);
    auto const blocks = plan.at("blocks").get<std::int64_t>();
    ASSERT_GT(blocks, 8);
    auto const all_there = [&] { return comes_true([&] { return blocks_done(folder, "c.h5") == blocks; }); };
    EXPECT_TRUE(all_there() || all_there() || all_there())  // a busy machine: patience is two blocks long
        << blocks_done(folder, "c.h5") << " of " << blocks << " while a rank is stopped";
    ::kill(ranks[1], SIGCONT);

    EXPECT_EQ(running.wait().code, 0);
    EXPECT_TRUE(folder.read("c.h5") == folder.read("one.h5"));
}

// R-1102: a rank that hangs does not hold the others beyond the time limit, and what is committed stays.
TEST_F(Leaving, WithoutAHungRank) {
    write_short_blocks(100'000);
    Running running(folder, mpirun(3, {"run", "c.toml", "--max-walltime", "3 s"}));
    ASSERT_TRUE(comes_true([&] { return blocks_done(folder, "c.h5") > 0; }));
    auto const ranks = children_of(running.pid());
    ASSERT_EQ(ranks.size(), 3U);
    auto const begin = Clock::now();
    ::kill(ranks[2], SIGSTOP);

    auto const ended = running.wait();
    EXPECT_EQ(ended.code, 3) << ended.err;
    EXPECT_LT(seconds_since(begin), 60) << "3 s, and 30 of patience";
    EXPECT_NE(ended.err.find("a rank has not answered"), std::string::npos) << ended.err;
    EXPECT_GT(blocks_done(folder, "c.h5"), 0);
    ::kill(ranks[2], SIGKILL);
    EXPECT_EQ(overturn(folder, {"run", "c.toml", "--resume", "--max-walltime", "0.1 s"}).code, 3);
}

}  // namespace
}  // namespace overturn::testing
