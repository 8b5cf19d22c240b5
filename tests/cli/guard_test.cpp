// Requirement R-1103, R-1101: what is committed is never lost to a mishap or mixed with what is not the same: a log
// that cannot be written, an early signal, a damaged record, another program's blocks, a results file that was changed
// by hand.
#include <sys/stat.h>

#include "campaign/campaign_input.hpp"
#include "campaign/version.hpp"
#include "cli/campaign_files.hpp"
#include "cli/python.hpp"
#include "store/sha256.hpp"
#include "store/shards.hpp"
#include "support/command.hpp"

namespace overturn::testing {
namespace {

class Guard : public ::testing::Test {
  protected:
    Guard() {
        folder.write("target.csv", target_csv);
        folder.write("c.toml", small_campaign());
    }

    Ended shell(std::string const& tail) const {
        return execute(folder, {"/bin/sh", "-c", OVERTURN_PROGRAM " " + tail});
    }
    void half() const { ASSERT_EQ(overturn(folder, {"run", "c.toml", "--part", "1/2"}).code, 0); }
    [[nodiscard]] std::string record() const { return folder.read("c.h5.parts/campaign.record"); }
    /// The blocks that lie there say of what began them something else.
    template <class Change> void begun_as(Change&& change) const {
        constexpr std::size_t hash_length = 64;
        auto begun = CampaignInput::deserialise(record().substr(0, record().size() - hash_length));
        change(begun);
        auto const text = begun.serialise();
        folder.write("c.h5.parts/campaign.record", text + store::sha256(text));
    }
    void expect_refused(Ended const& ended, std::string const& why) const {
        EXPECT_EQ(ended.code, 2);
        EXPECT_TRUE(is_one_error_line(ended.err));
        EXPECT_NE(ended.err.find(why), std::string::npos) << ended.err;
        EXPECT_EQ(blocks_done(folder, "c.h5"), 6);
    }
    void expect_as_unbroken() const {
        EXPECT_EQ(overturn(folder, {"run", "c.toml", "-o", "unbroken.h5"}).code, 0);
        EXPECT_TRUE(folder.read("c.h5") == folder.read("unbroken.h5"));
    }

    Folder folder;
};

TEST_F(Guard, ALogThatCannotBeWrittenHarmsNothing) {
    EXPECT_EQ(shell("run c.toml -o full.h5 2>/dev/full").code, 0);
    EXPECT_EQ(shell("run nosuch.toml 2>/dev/full").code, 2);
    EXPECT_EQ(shell("run c.toml --part 1/2 2>&-").code, 0);
    EXPECT_EQ(folder.read("c.h5.parts/lock"), "") << "nothing meant for stderr goes into a file";
    EXPECT_EQ(shell("run c.toml --resume 2>&- 0<&-").code, 0);
    EXPECT_TRUE(folder.read("c.h5") == folder.read("full.h5"));
}

TEST_F(Guard, ADamagedRecordGivesNoBlockAway) {
    half();
    auto damaged = record();
    damaged[damaged.size() / 2] ^= 1;
    folder.write("c.h5.parts/campaign.record", damaged);
    folder.write("other.toml", small_campaign() + "[accuracy]\npanel_phase='10 rad'\n");

    expect_refused(overturn(folder, {"run", "c.toml"}), "campaign.record: damaged");
    expect_refused(overturn(folder, {"run", "other.toml", "-o", "c.h5"}), "campaign.record: damaged");
    expect_refused(overturn(folder, {"run", "other.toml", "-o", "c.h5", "--resume"}), "blocks of another campaign");
    auto const own = overturn(folder, {"run", "c.toml", "--resume"});
    EXPECT_EQ(own.code, 0) << own.err;
    EXPECT_NE(own.err.find("6 of 12 blocks are done"), std::string::npos) << own.err;
    expect_as_unbroken();
}

TEST_F(Guard, BlocksWithoutARecordAreReported) {
    half();
    std::filesystem::remove(folder / "c.h5.parts/campaign.record");

    for (std::string const verb : {"status", "merge"}) {
        expect_refused(overturn(folder, {verb, "c.h5"}), "blocks without the record");
    }
    expect_refused(overturn(folder, {"run", "c.toml"}), "blocks of an unfinished run lie there");
    EXPECT_EQ(overturn(folder, {"run", "c.toml", "--resume"}).code, 0);
    expect_as_unbroken();
}

/// Each rank reads and hashes a share of what is there; together they miss none, and tell of each once.
TEST_F(Guard, RanksShareTheBlocksThatAreThere) {
    ASSERT_EQ(overturn(folder, {"run", "c.toml", "--part", "2/2"}).code, 0);
    folder.write("c.h5.parts/0000000007.block", "damaged");
    auto const resumed = execute(folder, mpirun(3, {"run", "c.toml", "--resume"}));

    EXPECT_EQ(resumed.code, 0) << resumed.err;
    EXPECT_NE(resumed.err.find("resuming c.h5: 5 of 12 blocks are done, 7 are left"), std::string::npos) << resumed.err;
    auto const damage = resumed.err.find("0000000007.block: not a whole block");
    ASSERT_NE(damage, std::string::npos) << resumed.err;
    EXPECT_EQ(resumed.err.find("0000000007.block", damage + 1), std::string::npos) << resumed.err;
    expect_as_unbroken();
}

TEST_F(Guard, BlocksOfTwoProgramsAreNotMixed) {
    half();
    begun_as([](CampaignInput& begun) { begun.program = "0.0.9 (abcdef)"; });

    expect_refused(overturn(folder, {"run", "c.toml", "--resume"}), "begun by overturn 0.0.9 (abcdef)");
    expect_refused(overturn(folder, {"run", "c.toml", "--resume"}), "Finish it with that one");
    for (std::string const verb : {"status", "merge"}) {
        expect_refused(overturn(folder, {verb, "c.h5"}), "begun by overturn 0.0.9 (abcdef)");
    }
}

TEST_F(Guard, BlocksOfTwoKindsOfMachineAreNotMixed) {
    half();
    begun_as([](CampaignInput& begun) { begun.machine = "aarch64"; });

    auto const told = "begun on aarch64, this is " + machine();
    expect_refused(overturn(folder, {"run", "c.toml", "--resume"}), told);
    expect_refused(overturn(folder, {"run", "c.toml", "--resume", "--part", "2/2"}), told);
    for (std::string const verb : {"status", "merge"}) {
        expect_refused(overturn(folder, {verb, "c.h5"}), told);
    }
}

// Where the record that names the machine is lost, the blocks themselves tell.
TEST_F(Guard, BlocksOfAnotherMachineAreNotTakenForOurs) {
    half();
    auto begun = CampaignInput::deserialise(record().substr(0, record().size() - 64));
    auto const ours = store::ShardFolder(folder / "c.h5", begun.block_key());
    auto const rows = ours.read(2);
    begun.machine = "aarch64";
    store::ShardFolder(folder / "c.h5", begun.block_key()).commit(2, rows);
    std::filesystem::remove(folder / "c.h5.parts/campaign.record");

    auto const resumed = overturn(folder, {"run", "c.toml", "--resume"});
    EXPECT_NE(resumed.err.find("a block of another campaign or place"), std::string::npos) << resumed.err;
    expect_as_unbroken();
}

TEST_F(Guard, ABlockOfAnotherLengthIsComputedAgain) {
    half();
    auto const begun = CampaignInput::deserialise(record().substr(0, record().size() - 64));
    store::ShardFolder const shards(folder / "c.h5", begun.block_key());
    auto rows = shards.read(2);
    rows.resize(rows.size() + 8);
    shards.commit(2, rows);

    auto const status = overturn(folder, {"status", "c.h5"});
    EXPECT_EQ(status.code, 3);
    EXPECT_NE(status.err.find("0000000002.block: "), std::string::npos) << status.err;
    EXPECT_EQ(overturn(folder, {"run", "c.toml", "--resume"}).code, 0);
    expect_as_unbroken();
}

TEST_F(Guard, ResultsThatWereChangedByHandAreReported) {
    if (!has_python(folder, "h5py")) {
        GTEST_SKIP() << "no h5py to write with (install python3-h5py)";
    }
    ASSERT_EQ(overturn(folder, {"run", "c.toml"}).code, 0);
    auto const sound = folder.read("c.h5");
    for (std::string const change : {"f['trials/verdict'][5] = 3 if f['trials/verdict'][5] != 3 else 2",
                                     "f.attrs['complete'] = 0", "f.attrs['input_sha256'] = 'f' * 64",
                                     "f.attrs['format_version'] = -1", "f.attrs['format_version'] = 'one'"}) {
        folder.write("c.h5", sound);
        ASSERT_EQ(edit_results(folder, "c.h5", change).code, 0) << change;
        for (std::string const verb : {"status", "fit"}) {
            auto const told = overturn(folder, {verb, "c.h5"});
            EXPECT_EQ(told.code, 2) << change;
            EXPECT_TRUE(is_one_error_line(told.err)) << change;
            EXPECT_NE(told.err.find("damaged"), std::string::npos) << told.err;
        }
    }
}

TEST_F(Guard, AFileOfTimesThatNobodyCanReadDoesNotMatter) {
    if (!has_python(folder, "h5py, matplotlib")) {
        GTEST_SKIP() << "no h5py and matplotlib to draw with";
    }
    ASSERT_EQ(overturn(folder, {"run", "c.toml"}).code, 0);
    for (std::string const text : {"{", "{\"wall_s\":1,\"ranks\":[{\"rank\":0}]}"}) {
        folder.write("c.runtime.json", text);
        auto const page = overturn(folder, {"report", "c.h5", "-o", "page.html"});
        EXPECT_EQ(page.code, 0) << page.err;
        EXPECT_NE(page.err.find("c.runtime.json: not as overturn run writes it"), std::string::npos) << page.err;
    }
}

TEST_F(Guard, EmptyWishesAreNoWishes) {
    for (std::string const option : {"--part", "--max-walltime"}) {
        auto const ended = overturn(folder, {"run", "c.toml", option, ""});
        EXPECT_EQ(ended.code, 2) << option;
    }
    EXPECT_EQ(overturn(folder, {"run", "c.toml", "--set", "title=\"\"\"a\nb\"\"\""}).code, 2);
    EXPECT_FALSE(folder.has("c.h5.parts"));
}

/// Two studies distinguished by what follows a dot do not share a file.
TEST_F(Guard, NamesWithDotsAreWholeNames) {
    folder.write("study.0.2.toml", small_campaign("shared", 1));
    EXPECT_EQ(overturn(folder, {"run", "study.0.2.toml"}).code, 0);
    EXPECT_TRUE(folder.has("study.0.2.h5"));
}

}  // namespace
}  // namespace overturn::testing
