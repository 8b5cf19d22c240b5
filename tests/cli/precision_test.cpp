// Requirement R-1001, R-703: a campaign with a target ends as soon as it is met, at the same wave and with the same
// bytes on any number of ranks, in one go, resumed or in parts; the file says so and is complete.
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/campaign_files.hpp"
#include "support/command.hpp"

namespace overturn::testing {
namespace {

std::vector<std::string> const target{"--set", "waves.count=200", "--set", "statistics.target_half_width=0.13"};

class Precision : public ::testing::Test {
  protected:
    Precision() {
        folder.write("target.csv", target_csv);
        folder.write("c.toml", small_campaign("shared", 200));
    }
    std::string bytes_of(std::string const& name) { return folder.read(name); }

    Folder folder;
};

/// 0.13 takes 64 waves: at P = 1/2 the exact interval of 64 is 0.2552 wide, that of 32 is 0.36.
TEST_F(Precision, EndsAtTheSameWaveOnAnyNumberOfRanks) {
    auto const alone = overturn(folder, joined({"run", "c.toml", "-o", "1.h5"}, target));
    ASSERT_EQ(alone.code, 0) << alone.err;
    EXPECT_NE(alone.err.find("precise enough after "), std::string::npos) << alone.err;
    auto const three = execute(folder, mpirun(3, joined({"run", "c.toml", "-o", "3.h5"}, target)));
    ASSERT_EQ(three.code, 0) << three.err;
    EXPECT_TRUE(bytes_of("1.h5") == bytes_of("3.h5"));

    auto const status = overturn(folder, {"status", "1.h5"});
    EXPECT_EQ(status.code, 0);
    EXPECT_NE(status.out.find("of 200 waves"), std::string::npos) << status.out;
    auto const fit = nlohmann::json::parse(overturn(folder, {"fit", "1.h5", "--json"}).out);
    for (auto const& stripe : fit["stripes"]) {
        EXPECT_EQ(stripe["trials"], fit["stripes"][0]["trials"]);
        EXPECT_LE(stripe["upper"].get<double>() - stripe["lower"].get<double>(), 2 * 0.13);
    }
    EXPECT_LT(fit["stripes"][0]["trials"].get<int>(), 200);
    EXPECT_EQ(overturn(folder, {"replay", "1.h5", "--trial", "17"}).code, 0);
    EXPECT_EQ(overturn(folder, {"replay", "1.h5", "--trial", "1100"}).code, 2) << "planned, never run";
}

/// Parts cannot know of each other and do all their waves; merged they are cut where the whole run ends.
TEST_F(Precision, PartsAreCutAtTheSameWave) {
    ASSERT_EQ(overturn(folder, joined({"run", "c.toml", "-o", "1.h5"}, target)).code, 0);
    for (auto const* part : {"2/2", "1/2"}) {
        auto const ended = overturn(folder, joined({"run", "c.toml", "-o", "p.h5", "--part", part}, target));
        ASSERT_EQ(ended.code, 0) << ended.err;
    }
    ASSERT_EQ(overturn(folder, {"merge", "p.h5"}).code, 0);
    EXPECT_TRUE(bytes_of("1.h5") == bytes_of("p.h5"));
}

/// Killed on the way and resumed: the same end.
TEST_F(Precision, AResumedRunEndsThereToo) {
    ASSERT_EQ(overturn(folder, joined({"run", "c.toml", "-o", "1.h5"}, target)).code, 0);
    Running run(folder, joined({OVERTURN_PROGRAM, "run", "c.toml", "-o", "r.h5"}, target));
    ASSERT_TRUE(comes_true([&] { return blocks_done(folder, "r.h5") > 5; }));
    run.signal(SIGKILL);
    (void)run.wait();
    auto const ended = overturn(folder, joined({"run", "c.toml", "-o", "r.h5", "--resume"}, target));
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_TRUE(bytes_of("1.h5") == bytes_of("r.h5"));
}

/// A target on the median asks for a curve; one that is never met runs to the last wave.
TEST_F(Precision, MedianTargetAndTargetsThatAreNeverMet) {
    auto const never = overturn(folder, {"run", "c.toml", "-o", "n.h5", "--set", "waves.count=40", "--set",
                                         "statistics.target_median_half_width=0.1"});
    ASSERT_EQ(never.code, 0) << never.err;
    EXPECT_EQ(never.err.find("precise enough"), std::string::npos) << "type A never overturns: it has no median";
    EXPECT_NE(never.err.find("warning: after 32 waves type-a cannot meet target_median_half_width = 0.1 (no trial "
                             "overturned): all 40 waves are run unless that changes\n"),
              std::string::npos)
        << never.err;
    EXPECT_NE(overturn(folder, {"status", "n.h5"}).out.find("complete, 240 trials"), std::string::npos);
}

/// It is said once, however often it is looked: after 32, 64 and 128 waves.
TEST_F(Precision, ImpossibleTargetsAreReportedOnce) {
    for (int const ranks : {1, 2}) {
        auto const never =
            execute(folder, mpirun(ranks, {"run", "c.toml", "-o", fmt::format("n{}.h5", ranks), "--set",
                                           "waves.count=130", "--set", "statistics.target_median_half_width=0.1"}));
        ASSERT_EQ(never.code, 0) << never.err;
        auto const first = never.err.find("cannot meet");
        ASSERT_NE(first, std::string::npos) << never.err;
        EXPECT_EQ(never.err.find("cannot meet", first + 1), std::string::npos) << never.err;
    }
}

TEST_F(Precision, ImpossibleTargetsAreRefused) {
    auto const refuse = [&](std::string const& set, std::string const& part) {
        auto const ended = planned(folder, {"c.toml", "--set", set});
        EXPECT_EQ(ended.code, 2) << set;
        EXPECT_TRUE(is_one_error_line(ended.err)) << ended.err;
        EXPECT_NE(ended.err.find(part), std::string::npos) << ended.err;
    };
    refuse("statistics.target_half_width=0", "target_half_width");
    refuse("statistics.target_half_width=0.7", "target_half_width");
    refuse("statistics.target_halfwidth=0.1", "Did you mean 'target_half_width'?");
    folder.write("c.toml", small_campaign("independent", 20));
    refuse("statistics.target_half_width=0.1", "independent waves");
}

}  // namespace
}  // namespace overturn::testing
