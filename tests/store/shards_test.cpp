// Requirement R-1101, R-1103: a finished block comes back bit for bit or is named as unsound; nothing foreign is taken
// or removed.
#include "store/shards.hpp"

#include <algorithm>

#include "core/next_step.hpp"
#include "store/durable.hpp"
#include "store/sha256.hpp"
#include "support/expect_system_error.hpp"
#include "support/full_disk.hpp"
#include "support/temporary_folder.hpp"

namespace overturn::store {
namespace {

using testing::expect_system_error;
using testing::FullDisk;
using testing::slurp;
using testing::spill;
using testing::TemporaryFolder;

constexpr BlockRange all{0, 100};
std::string const ours = sha256("this campaign");

std::vector<std::byte> rows_of(std::size_t count, int salt) {
    std::vector<std::byte> rows(count);
    for (std::size_t i = 0; i < count; ++i) {
        rows[i] = static_cast<std::byte>(i * 7 + static_cast<std::size_t>(salt));
    }
    return rows;
}

/// A campaign with blocks 0 to 3 committed.
class Shards : public ::testing::Test {
  protected:
    void SetUp() override {
        shards.begin("the campaign\n");
        for (int block = 0; block < 4; ++block) {
            shards.commit(block, rows_of(1000, block));
        }
    }

    std::filesystem::path file(std::string const& name) const { return shards.folder() / name; }

    /// The sound blocks; everything else must be named in one note that holds `note`.
    std::vector<std::int64_t> sound(std::string const& named, std::string const& note) const {
        std::vector<std::string> notes;
        auto const blocks = shards.committed(all, notes);
        EXPECT_EQ(notes.size(), 1U);
        for (auto const& text : notes) {
            EXPECT_NE(text.find(named), std::string::npos) << text;
            EXPECT_NE(text.find(note), std::string::npos) << text;
        }
        return blocks;
    }

    TemporaryFolder folder;
    ShardFolder shards{folder / "out.h5", ours};
};

using Blocks = std::vector<std::int64_t>;

TEST(Sha256, IsTheStandardOne) {
    // FIPS 180-4: the examples for "" and "abc".
    EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST_F(Shards, ComeBackBitForBit) {
    std::vector<std::string> notes;

    EXPECT_EQ(shards.committed(all, notes), (Blocks{0, 1, 2, 3}));
    EXPECT_TRUE(notes.empty());
    for (int block = 0; block < 4; ++block) {
        EXPECT_EQ(shards.read(block), rows_of(1000, block));
    }
    EXPECT_EQ(shards.begun_with(), "the campaign\n");
    EXPECT_EQ(shards.folder(), folder / "out.h5.parts");
}

TEST_F(Shards, BlockWithoutRowsIsABlock) {
    shards.commit(7, {});

    EXPECT_TRUE(shards.read(7).empty());
}

TEST_F(Shards, CommittingAgainReplaces) {
    shards.commit(2, rows_of(30, 99));

    EXPECT_EQ(shards.read(2), rows_of(30, 99));
}

TEST_F(Shards, TruncatedBlockIsNamedAtEveryLength) {
    auto const whole = slurp(file("0000000002.block"));
    for (std::size_t const left :
         {std::size_t{0}, std::size_t{5}, std::size_t{100}, whole.size() / 2, whole.size() - 1}) {
        spill(file("0000000002.block"), whole.substr(0, left));

        EXPECT_EQ(sound("0000000002.block", "overturn run --resume computes it again"), (Blocks{0, 1, 3}))
            << left << " bytes left";
    }
}

TEST_F(Shards, EveryFlippedBitIsSeen) {
    auto const whole = slurp(file("0000000001.block"));
    std::size_t const stride = 97;  // of bytes; all eight bits are met
    for (std::size_t i = 0; i < whole.size(); i += stride) {
        auto damaged = whole;
        damaged[i] = static_cast<char>(damaged[i] ^ (1 << (i % 8)));
        spill(file("0000000001.block"), damaged);

        expect_system_error([&] { (void)shards.read(1); }, "0000000001.block");
    }
    EXPECT_EQ(sound("0000000001.block", "checksum"), (Blocks{0, 2, 3}));
}

TEST_F(Shards, BlockOfAnotherCampaignIsRefused) {
    ShardFolder const other(folder / "out.h5", sha256("another campaign"));
    other.commit(3, rows_of(1000, 3));

    EXPECT_EQ(sound("0000000003.block", "another campaign"), (Blocks{0, 1, 2}));
}

TEST_F(Shards, BlockUnderAnotherNumberIsRefused) {
    std::filesystem::copy_file(file("0000000003.block"), file("0000000009.block"));

    EXPECT_EQ(sound("0000000009.block", "another campaign or place"), (Blocks{0, 1, 2, 3}));
}

TEST_F(Shards, BlockUnderAnotherSpellingIsNotCountedTwice) {
    std::filesystem::copy_file(file("0000000003.block"), file("3.block"));

    EXPECT_EQ(sound("/3.block", "left as it is"), (Blocks{0, 1, 2, 3}));
}

/// As a signed number would be written out by whoever names blocks: none of ours.
TEST_F(Shards, NumbersBelowNoughtAreForeignNames) {
    std::filesystem::rename(file("0000000003.block"), file("-000000003.block"));

    EXPECT_EQ(sound("-000000003.block", "not a block of this run"), (Blocks{0, 1, 2}));
    shards.remove();
    EXPECT_TRUE(std::filesystem::exists(file("-000000003.block")));
}

TEST_F(Shards, ForeignNamesAreLeftAlone) {
    spill(file("notes.block"), "shopping list");

    EXPECT_EQ(sound("notes.block", "left as it is"), (Blocks{0, 1, 2, 3}));
    EXPECT_EQ(slurp(file("notes.block")), "shopping list");
}

TEST_F(Shards, FolderInPlaceOfABlockIsNamed) {
    std::filesystem::create_directory(file("0000000005.block"));

    EXPECT_EQ(sound("0000000005.block", "a folder, no file"), (Blocks{0, 1, 2, 3}));
}

TEST_F(Shards, UnfinishedWriteIsIgnored) {
    spill(file("0000000004.block.tmp-here-17"), "half a blo");
    std::vector<std::string> notes;

    EXPECT_EQ(shards.committed(all, notes), (Blocks{0, 1, 2, 3}));
    EXPECT_TRUE(notes.empty());
}

TEST_F(Shards, UnfinishedWritesOfOurBlocksGoAndOfOthersStay) {
    for (std::string const name : {"0000000004.block.tmp-here-17", "0000000009.block.tmp-there-3", "notes.tmp"}) {
        spill(file(name), "half a blo");
    }
    shards.remove_unfinished({4, 9});

    EXPECT_FALSE(std::filesystem::exists(file("0000000004.block.tmp-here-17")));
    EXPECT_TRUE(std::filesystem::exists(file("0000000009.block.tmp-there-3")));
    EXPECT_TRUE(std::filesystem::exists(file("notes.tmp")));
    EXPECT_EQ(shards.read(3), rows_of(1000, 3));
}

TEST_F(Shards, OnlyThoseAskedForAreLookedAt) {
    spill(file("0000000003.block"), "damaged");
    std::vector<std::string> notes;

    EXPECT_EQ(shards.committed({1, 3}, notes), (Blocks{1, 2}));
    EXPECT_TRUE(notes.empty());
}

TEST_F(Shards, RemoveTakesEverythingOfOurs) {
    spill(file("0000000004.block.tmp-here-17"), "half a blo");
    spill(file("campaign.record.tmp-here-17"), "half a rec");
    spill(file(BlockLock::file_name), "");
    shards.remove();

    EXPECT_FALSE(shards.exists());
    EXPECT_TRUE(shards.begun_with().empty());
    shards.remove();  // nothing there is no error
}

TEST_F(Shards, RemoveLeavesForeignFiles) {
    spill(file("notes.txt"), "shopping list");
    spill(file("notes.block"), "shopping list");
    spill(file("notes.tmp"), "shopping list");
    shards.remove();

    EXPECT_FALSE(std::filesystem::exists(file("0000000000.block")));
    EXPECT_EQ(slurp(file("notes.txt")), "shopping list");
    EXPECT_EQ(slurp(file("notes.block")), "shopping list");
    EXPECT_EQ(slurp(file("notes.tmp")), "shopping list");
}

TEST_F(Shards, MissingBlockIsNamed) {
    expect_system_error([&] { (void)shards.read(8); }, "0000000008.block", "No such file");
}

TEST_F(Shards, DamagedRecordIsReported) {
    auto const whole = slurp(file("campaign.record"));
    for (std::size_t i = 0; i < whole.size(); ++i) {
        auto damaged = whole;
        damaged[i] = static_cast<char>(damaged[i] ^ (1 << (i % 8)));
        spill(file("campaign.record"), damaged);
        expect_system_error([&] { (void)shards.begun_with(); }, "campaign.record", "damaged", "--resume");
    }
    spill(file("campaign.record"), "short");
    expect_system_error([&] { (void)shards.begun_with(); }, "campaign.record", "damaged");
}

// R-1303: No folder ever holds more than 1024 blocks, however many a campaign has.
TEST_F(Shards, ManyBlocksLieInFoldersOfTheirOwn) {
    for (std::int64_t const block : {std::int64_t{1023}, std::int64_t{1024}, std::int64_t{2047}, std::int64_t{5000},
                                     std::int64_t{2'000'000'001}}) {
        shards.commit(block, rows_of(10, static_cast<int>(block % 256)));
    }
    EXPECT_TRUE(std::filesystem::exists(file("0000001023.block")));
    EXPECT_TRUE(std::filesystem::exists(file("0000001.blocks/0000001024.block")));
    EXPECT_TRUE(std::filesystem::exists(file("0000001.blocks/0000002047.block")));
    EXPECT_TRUE(std::filesystem::exists(file("0000004.blocks/0000005000.block")));

    std::vector<std::string> notes;
    EXPECT_EQ(shards.committed({0, 1'000'000}, notes), (Blocks{0, 1, 2, 3, 1023, 1024, 2047, 5000}));
    EXPECT_EQ(shards.committed({1024, 2048}, notes), (Blocks{1024, 2047}));
    EXPECT_EQ(shards.committed({2, 1025}, notes), (Blocks{2, 3, 1023, 1024}));
    EXPECT_EQ(shards.committed({2'000'000'000, 3'000'000'000}, notes), (Blocks{2'000'000'001}));
    EXPECT_TRUE(notes.empty());
    EXPECT_EQ(shards.read(5000), rows_of(10, 5000 % 256));
    shards.remove();
    EXPECT_FALSE(shards.exists());
}

TEST_F(Shards, BlocksInAnotherFolderAreForeign) {
    shards.commit(1500, rows_of(10, 1));
    std::filesystem::rename(file("0000001.blocks/0000001500.block"), file("0000001500.block"));
    std::filesystem::rename(file("0000000003.block"), file("0000001.blocks/0000000003.block"));

    std::vector<std::string> notes;
    EXPECT_EQ(shards.committed({0, 10'000}, notes), (Blocks{0, 1, 2}));
    EXPECT_EQ(notes.size(), 2U);
    shards.remove();
    EXPECT_TRUE(std::filesystem::exists(file("0000001500.block")));
    EXPECT_TRUE(std::filesystem::exists(file("0000001.blocks/0000000003.block")));
}

TEST_F(Shards, UnfinishedWritesGoFromFoldersToo) {
    shards.commit(1500, rows_of(10, 1));
    auto const half = "0000001.blocks/0000001501.block" + std::string(unfinished_mark) + "-host-1";
    spill(file(half), "half");

    shards.remove_unfinished({0, 1501});
    EXPECT_TRUE(std::filesystem::exists(file(half)));
    shards.remove_unfinished({1501, 1502});
    EXPECT_FALSE(std::filesystem::exists(file(half)));
    EXPECT_TRUE(std::filesystem::exists(file("0000001.blocks/0000001500.block")));
}

// R-1101: blocks committed together, in whatever folders they lie, are there one by one.
TEST_F(Shards, SeveralAreCommittedTogether) {
    std::vector<PackedBlock> many;
    for (int number = 950; number < 1100; ++number) {
        many.push_back({number, rows_of(50, number % 256)});
    }

    shards.commit(many);

    std::vector<std::string> notes;
    EXPECT_EQ(shards.committed({900, 1200}, notes).size(), many.size());
    EXPECT_TRUE(notes.empty());
    for (auto const& block : many) {
        EXPECT_EQ(shards.read(block.number), block.rows);
    }
}

// R-1105: where one of several finds no room, those before it may be there, whole; nothing half done stays.
TEST_F(Shards, FullDiskAmongSeveralLeavesNoHalf) {
    {
        FullDisk const disk(4096);
        std::vector<PackedBlock> const two{{0, rows_of(100, 9)}, {1, rows_of(100000, 9)}};
        expect_system_error([&] { shards.commit(two); }, "0000000001.block", "File too large");
    }
    EXPECT_EQ(shards.read(1), rows_of(1000, 1));
    auto const first = shards.read(0);
    EXPECT_TRUE(first == rows_of(100, 9) || first == rows_of(1000, 0));
    for (auto const& entry : std::filesystem::directory_iterator(shards.folder())) {
        EXPECT_EQ(entry.path().string().find(unfinished_mark), std::string::npos) << entry.path();
    }
}

// R-1105.
TEST_F(Shards, FullDiskIsReportedAndTheOldBlockStays) {
    {
        FullDisk const disk(4096);
        NextStep const next("go on with --resume");
        expect_system_error([&] { shards.commit(1, rows_of(100000, 1)); }, "0000000001.block", "File too large",
                            "--resume");
    }
    EXPECT_EQ(shards.read(1), rows_of(1000, 1));
}

TEST(ShardFolderPlace, MissingFolderHasNoBlocks) {
    TemporaryFolder const folder;
    ShardFolder const shards(folder / "out.h5", ours);
    std::vector<std::string> notes;

    EXPECT_FALSE(shards.exists());
    EXPECT_TRUE(shards.committed(all, notes).empty());
    EXPECT_TRUE(notes.empty());
}

TEST(ShardFolderPlace, PlaceThatIsAFileIsNamed) {
    TemporaryFolder const folder;
    spill(folder / "taken", "");
    ShardFolder const shards(folder / "taken" / "out.h5", ours);

    expect_system_error([&] { shards.begin(""); }, "taken/out.h5.parts", "Choose another place");
}

}  // namespace
}  // namespace overturn::store
