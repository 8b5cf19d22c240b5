// Requirement R-1101, R-1105: a file is there whole or not at all, and what stands in the way is said in one line.
#include "store/durable.hpp"

#include <cerrno>

#include "core/next_step.hpp"
#include "support/expect_input_error.hpp"
#include "support/expect_system_error.hpp"
#include "support/full_disk.hpp"
#include "support/temporary_folder.hpp"

namespace overturn::store {
namespace {

using testing::expect_input_error;
using testing::expect_system_error;
using testing::FullDisk;
using testing::slurp;
using testing::TemporaryFolder;

void write(std::filesystem::path const& path, std::string const& content) {
    write_durably(path, std::as_bytes(std::span(content)));
}

std::size_t files_in(TemporaryFolder const& folder) {
    std::filesystem::directory_iterator const files(folder.path());
    return static_cast<std::size_t>(std::distance(begin(files), end(files)));
}

TEST(Durable, WritesAndReadsBytes) {
    TemporaryFolder const folder;
    std::string const content("a\0\r\nb", 5);
    write(folder / "file", "something longer before");
    write(folder / "file", content);

    EXPECT_EQ(read_file(folder / "file"), content);
    EXPECT_EQ(files_in(folder), 1U);
}

// R-1105: of two that begin at once, one makes the file and the other finds it.
TEST(Durable, CreatesOnce) {
    TemporaryFolder const folder;
    auto const bytes = [](std::string const& text) { return std::as_bytes(std::span(text)); };
    std::string const first = "first";
    std::string const second = "second";

    EXPECT_TRUE(create_durably(folder / "file", bytes(first)));
    EXPECT_FALSE(create_durably(folder / "file", bytes(second)));
    EXPECT_EQ(read_file(folder / "file"), first);
    EXPECT_EQ(files_in(folder), 1U) << "nothing else is left";
}

TEST(Durable, EmptyFileIsAFile) {
    TemporaryFolder const folder;
    write(folder / "file", "");

    EXPECT_EQ(read_file(folder / "file"), "");
}

TEST(Durable, MissingFolderIsNamed) {
    TemporaryFolder const folder;

    expect_system_error([&] { write(folder / "nowhere" / "file", "x"); }, "nowhere/file", "No such file or directory");
    expect_input_error([&] { require_writable(folder / "nowhere" / "file"); }, "nowhere/file",
                       "No such file or directory", "Choose another place");
}

TEST(Durable, FullDiskLeavesTheOldContent) {
    TemporaryFolder const folder;
    write(folder / "file", "old");
    {
        FullDisk const disk(4096);
        expect_system_error([&] { write(folder / "file", std::string(100000, 'x')); }, "cannot write", "file",
                            "File too large", "Free space");
    }
    EXPECT_EQ(slurp(folder / "file"), "old");
    EXPECT_EQ(files_in(folder), 1U);
}

/// Only the verb knows what comes after the remedy.
TEST(Durable, AdviceEndsWithTheNextStep) {
    EXPECT_EQ(advice_on_disk(ENOSPC), "Free space or choose another place, then repeat the command");
    {
        NextStep const outer("go on with --resume");
        EXPECT_EQ(advice_on_disk(EIO), "Check the disk, then go on with --resume");
        NextStep const inner("merge again");
        EXPECT_EQ(advice_on_disk(EROFS), "Make it writable, then merge again");
    }
    EXPECT_EQ(advice_on_disk(ENOENT), "Bring the folder back, then repeat the command");
}

TEST(Durable, ProbeLeavesNothingBehind) {
    TemporaryFolder const folder;
    require_writable(folder / "file");

    EXPECT_EQ(files_in(folder), 0U);
}

TEST(Durable, FolderIsNoFile) {
    TemporaryFolder const folder;

    expect_system_error([&] { (void)read_file(folder.path()); }, folder.path().string(), "a folder, no file");
}

}  // namespace
}  // namespace overturn::store
