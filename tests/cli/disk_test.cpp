// Requirement R-1105: a disk that fails is reported in one line with exit code 1, and everything committed stays good.
#include <sys/mount.h>

#include "cli/campaign_files.hpp"
#include "support/command.hpp"

namespace overturn::testing {
namespace {

/// A disk of any size in a folder, for as long as it lives.
class Disk {
  public:
    explicit Disk(std::filesystem::path path) : path_(std::move(path)) { std::filesystem::create_directory(path_); }
    ~Disk() { ::umount2(path_.c_str(), MNT_DETACH); }
    Disk(Disk const&) = delete;
    Disk& operator=(Disk const&) = delete;
    Disk(Disk&&) = delete;
    Disk& operator=(Disk&&) = delete;

    /// False where only an administrator may.
    [[nodiscard]] bool mount(std::string const& size) const {
        return ::mount("tmpfs", path_.c_str(), "tmpfs", 0, ("size=" + size).c_str()) == 0;
    }
    void resize(std::string const& size) const {
        ASSERT_EQ(::mount("tmpfs", path_.c_str(), "tmpfs", MS_REMOUNT, ("size=" + size).c_str()), 0);
    }

  private:
    std::filesystem::path path_;
};

class DiskTrouble : public ::testing::Test {
  protected:
    DiskTrouble() : disk(folder / "disk") {
        folder.write("target.csv", target_csv);
        folder.write("c.toml", small_campaign("independent", 100));
    }
    void SetUp() override {
        if (!disk.mount("100m")) {
            GTEST_SKIP() << "no right to mount a small disk (needs root)";
        }
    }

    /// Among whatever else it says, one line of ours.
    static void expect_one_error(Ended const& ended, std::string const& part) {
        EXPECT_EQ(ended.code, 1) << ended.err;
        auto const at = ended.err.find("overturn: ");
        ASSERT_NE(at, std::string::npos) << ended.err;
        EXPECT_EQ(ended.err.find("overturn: ", at + 1), std::string::npos) << ended.err;
        EXPECT_NE(ended.err.find(part, at), std::string::npos) << ended.err;
    }
    void expect_resumed() {
        auto const before = blocks_done(folder, "disk/c.h5");
        auto const resumed = execute(folder, mpirun(2, {"run", "c.toml", "-o", "disk/c.h5", "--resume"}));
        EXPECT_EQ(resumed.code, 0) << resumed.err;
        EXPECT_NE(resumed.err.find(": " + std::to_string(before) + " of"), std::string::npos) << resumed.err;
        expect_as_unbroken();
    }
    void expect_as_unbroken() {
        EXPECT_EQ(overturn(folder, {"run", "c.toml", "-o", "unbroken.h5"}).code, 0);
        EXPECT_TRUE(folder.read("disk/c.h5") == folder.read("unbroken.h5"));
    }

    Folder folder;
    Disk disk;
};

TEST_F(DiskTrouble, FullWhileComputing) {
    disk.resize("1m");
    auto const ended = execute(folder, mpirun(2, {"run", "c.toml", "-o", "disk/c.h5"}));

    EXPECT_NE(ended.err.find("warning: disk/c.h5: 1.0 MB are free there, blocks and the merged file need about"),
              std::string::npos)
        << ended.err;
    expect_one_error(ended, "No space left on device). Free space");
    EXPECT_FALSE(folder.has("disk/c.h5"));
    EXPECT_GT(blocks_done(folder, "disk/c.h5"), 50);
    disk.resize("100m");
    expect_resumed();
}

TEST_F(DiskTrouble, FullWhileMerging) {
    for (auto const* part : {"1/2", "2/2"}) {
        ASSERT_EQ(overturn(folder, {"run", "c.toml", "-o", "disk/c.h5", "--part", part}).code, 0);
    }
    auto const space = std::filesystem::space(folder / "disk");
    disk.resize(std::to_string(space.capacity - space.free + 300'000));

    auto const merged = overturn(folder, {"merge", "disk/c.h5"});
    expect_one_error(merged, "No space left on device). Free space or choose another place, then merge again");
    EXPECT_EQ(merged.err.find("--resume"), std::string::npos) << merged.err;
    expect_one_error(execute(folder, mpirun(2, {"run", "c.toml", "-o", "disk/c.h5", "--resume"})),
                     "No space left on device");
    EXPECT_FALSE(folder.has("disk/c.h5"));
    EXPECT_FALSE(folder.has("disk/c.h5.merging"));
    disk.resize("100m");
    EXPECT_EQ(overturn(folder, {"merge", "disk/c.h5"}).code, 0);
    expect_as_unbroken();
}

TEST_F(DiskTrouble, FolderThatVanishes) {
    Running running(folder, mpirun(2, {"run", "c.toml", "-o", "disk/c.h5"}));
    ASSERT_TRUE(comes_true([&] { return blocks_done(folder, "disk/c.h5") > 5; }));
    std::filesystem::rename(folder / "disk/c.h5.parts", folder / "disk/elsewhere");

    expect_one_error(running.wait(), "No such file or directory). Bring the folder back");
    std::filesystem::rename(folder / "disk/elsewhere", folder / "disk/c.h5.parts");
    expect_resumed();
}

TEST_F(DiskTrouble, FolderThatBecomesReadOnly) {
    Running running(folder, mpirun(2, {"run", "c.toml", "-o", "disk/c.h5"}));
    ASSERT_TRUE(comes_true([&] { return blocks_done(folder, "disk/c.h5") > 5; }));
    auto const parts = folder / "disk/c.h5.parts";
    ASSERT_EQ(::mount(parts.c_str(), parts.c_str(), nullptr, MS_BIND, nullptr), 0);
    ASSERT_EQ(::mount(nullptr, parts.c_str(), nullptr, MS_BIND | MS_REMOUNT | MS_RDONLY, nullptr), 0);

    expect_one_error(running.wait(), "Read-only file system). Make it writable");
    auto const again = overturn(folder, {"run", "c.toml", "-o", "disk/c.h5", "--resume"});
    expect_one_error(again, "Read-only file system");
    ::umount2(parts.c_str(), MNT_DETACH);
    expect_resumed();
}

}  // namespace
}  // namespace overturn::testing
