// Requirement R-1106: absurd sizes are refused before memory is touched, any path is taken, and a file from the future
// is distinguished from a damaged one.
#include <sys/resource.h>

#include "cli/campaign_files.hpp"
#include "cli/python.hpp"
#include "support/command.hpp"

namespace overturn::testing {
namespace {

class Hostile : public ::testing::Test {
  protected:
    Hostile() { folder.write("target.csv", target_csv); }

    void refuse(std::string const& from, std::string const& to, std::string const& part) {
        auto text = small_campaign();
        auto const at = text.find(from);
        ASSERT_NE(at, std::string::npos) << from;
        folder.write("c.toml", text.replace(at, from.size(), to));
        for (std::string const verb : {"plan", "run"}) {
            auto const ended = overturn(folder, {verb, "c.toml"});
            EXPECT_EQ(ended.code, 2) << to;
            EXPECT_TRUE(is_one_error_line(ended.err)) << to;
            EXPECT_NE(ended.err.find(part), std::string::npos) << ended.err;
        }
        EXPECT_FALSE(folder.has("c.h5.parts"));
    }
    /// The most memory that any of the programs run so far has held.
    static double largest_mb() {
        rusage usage{};
        ::getrusage(RUSAGE_CHILDREN, &usage);
        return static_cast<double>(usage.ru_maxrss) / 1024;
    }

    Folder folder;
};

constexpr double modest_mb = 500;  // of which a sanitizer takes most

TEST_F(Hostile, AbsurdSizesAreRefusedUntouched) {
    refuse("count=12", "count=1000000000000", "c.toml:5:7: waves.count: 1000000000000");
    refuse("duration='20.48 s'", "duration='10000000 s'", "waves.duration");
    refuse("time_step='0.02 s'", "time_step='2e-8 s'", "waves.");
    refuse("values=['300 gal','600 gal','1200 gal']", "values={from='1 gal',to='2000 gal',count=1000000000}", "levels");
    refuse("match_iterations=3", "match_iterations=1000000000000", "match_iterations");

    EXPECT_LT(largest_mb(), modest_mb);
}

// R-1303.
TEST_F(Hostile, TheLargestCampaignIsPlannedInLittleMemory) {
    folder.write("c.toml", small_campaign("shared", 1'000'000'000));
    auto const plan = planned(folder, {"c.toml"});
    EXPECT_EQ(plan.code, 0) << plan.err;
    EXPECT_NE(plan.out.find("= 6000000000 trials\n"), std::string::npos) << plan.out;

    auto const begun = overturn(folder, {"run", "c.toml", "--max-walltime", "1 s"});
    EXPECT_EQ(begun.code, 3) << begun.err;
    EXPECT_LT(largest_mb(), modest_mb);
}

// R-1106: paths with blanks and non-ASCII letters, through every verb that takes one.
TEST_F(Hostile, AnyPathWill) {
    std::filesystem::path const place = "Größe & 'Maß' – 震動 $HOME";
    std::filesystem::create_directory(folder / place);
    std::filesystem::rename(folder / "target.csv", folder / (place / "Ziel é.csv"));
    auto text = small_campaign("shared", 4);
    text.replace(text.find("target.csv"), 10, "Ziel é.csv");
    auto const campaign = (place / "mein Lauf.toml").string();
    auto const file = (place / "Ergebnis 結果.h5").string();
    folder.write(campaign, text);
    auto const well = [&](Ended const& ended) {
        EXPECT_EQ(ended.code, 0) << ended.err;
        return ended.out;
    };

    (void)well(planned(folder, {campaign}));
    (void)well(execute(folder, mpirun(2, {"run", campaign, "-o", file, "--part", "1/2"})));
    (void)well(overturn(folder, {"run", campaign, "-o", file, "--part", "2/2"}));
    EXPECT_EQ(overturn(folder, {"status", file}).code, 3);
    (void)well(overturn(folder, {"merge", file}));
    EXPECT_NE(well(overturn(folder, {"status", file})).find("complete, 24 trials"), std::string::npos);
    EXPECT_NE(well(overturn(folder, {"replay", file, "--trial", "3"})).find("bit-equal"), std::string::npos);
    (void)well(overturn(folder, {"fit", file}));
    (void)well(overturn(folder, {"wave", campaign, "--wave", "1", "-o", (place / "eine Welle.csv").string()}));
    EXPECT_NE(well(overturn(folder, {"run", campaign, "-o", file, "--resume"})).find("complete already"),
              std::string::npos);
}

// what the program says to type can be typed, also where a path needs quotes.
TEST_F(Hostile, TheCommandToGoOnCanBePasted) {
    folder.write("my campaign's.toml", small_campaign("shared", 30));
    auto const stopped = overturn(
        folder, {"run", "my campaign's.toml", "-o", "my file.h5", "--set", "title='a b'", "--max-walltime", "0.01 s"});
    ASSERT_EQ(stopped.code, 3) << stopped.err;
    std::string const start = "Go on with: overturn ";
    auto const at = stopped.err.find(start) + start.size();
    auto const command = stopped.err.substr(at, stopped.err.find('\n', at) - at);

    auto const pasted = execute(folder, {"/bin/sh", "-c", OVERTURN_PROGRAM " " + command});
    EXPECT_EQ(pasted.code, 0) << command << "\n" << pasted.err;
    EXPECT_TRUE(folder.has("my file.h5"));
}

// R-1003.
TEST_F(Hostile, FilesFromTheFutureAreDistinguishedFromDamagedOnes) {
    if (!has_python(folder, "h5py")) {
        GTEST_SKIP() << "no h5py to write with (install python3-h5py)";
    }
    folder.write("c.toml", small_campaign("shared", 1));
    ASSERT_EQ(overturn(folder, {"run", "c.toml"}).code, 0);
    folder.write("damaged.h5", folder.read("c.h5").substr(0, folder.read("c.h5").size() / 2));
    ASSERT_EQ(edit_results(folder, "c.h5", "f.attrs['format_version'] = 99").code, 0);
    for (std::string const verb : {"status", "fit"}) {
        auto const future = overturn(folder, {verb, "c.h5"});
        EXPECT_EQ(future.code, 2);
        EXPECT_TRUE(is_one_error_line(future.err));
        EXPECT_NE(future.err.find("format version 99"), std::string::npos) << future.err;
        EXPECT_NE(future.err.find("Use a newer overturn"), std::string::npos) << future.err;
        auto const damaged = overturn(folder, {verb, "damaged.h5"});
        EXPECT_EQ(damaged.code, 2);
        EXPECT_NE(damaged.err.find("damaged"), std::string::npos) << damaged.err;
    }
}

}  // namespace
}  // namespace overturn::testing
