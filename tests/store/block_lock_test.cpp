// Requirement R-1105: no two runs write the same blocks at once, and a run that died holds nothing.
#include "store/block_lock.hpp"

#include <limits>
#include <optional>

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "support/expect_system_error.hpp"
#include "support/temporary_folder.hpp"

namespace overturn::store {
namespace {

using testing::expect_system_error;
using testing::spill;
using testing::TemporaryFolder;

constexpr BlockRange everything{0, std::numeric_limits<std::int64_t>::max()};

class BlockLocks : public ::testing::Test {
  protected:
    void expect_refused(BlockRange range) const {
        expect_system_error([&] { BlockLock const second(place, range); }, "another run is writing there now");
    }

    TemporaryFolder folder;
    std::filesystem::path place = folder / "out.h5.parts";
};

TEST_F(BlockLocks, TheSecondIsRefusedUntilTheFirstEnds) {
    EXPECT_FALSE(BlockLock::held(place));
    {
        BlockLock const first(place, everything);
        EXPECT_TRUE(BlockLock::held(place));
        expect_refused(everything);
        expect_refused({3, 4});
    }
    EXPECT_FALSE(BlockLock::held(place));
    BlockLock const again(place, everything);
}

TEST_F(BlockLocks, PartsThatShareNoBlockLiveSideBySide) {
    BlockLock const first(place, {0, 10});
    BlockLock const second(place, {10, 20});
    BlockLock const nothing(place, {5, 5});

    expect_refused({9, 11});
    expect_refused(everything);
    EXPECT_TRUE(BlockLock::held(place));
}

/// The folder may go while the lock is held: whoever comes next holds a lock that counts.
TEST_F(BlockLocks, ARemovedFolderIsMadeAgain) {
    std::optional<BlockLock> first(std::in_place, place, everything);
    std::filesystem::remove_all(place);
    BlockLock const second(place, everything);
    first.reset();

    expect_refused(everything);
}

// R-1101: SIGKILL leaves no stale lock.
TEST_F(BlockLocks, EndWithTheProcess) {
    int ready[2];
    ASSERT_EQ(::pipe(ready), 0);
    auto const child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        BlockLock const theirs(place, everything);
        (void)!::write(ready[1], "x", 1);
        ::pause();
        ::_exit(0);
    }
    char byte = 0;
    ASSERT_EQ(::read(ready[0], &byte, 1), 1);
    expect_refused(everything);
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);

    BlockLock const ours(place, everything);
    ::close(ready[0]);
    ::close(ready[1]);
}

TEST_F(BlockLocks, PlaceThatIsAFileIsNamed) {
    spill(folder / "taken", "");

    expect_system_error([&] { BlockLock const lock(folder / "taken" / "out.h5.parts", everything); },
                        "taken/out.h5.parts", "Choose another place");
}

}  // namespace
}  // namespace overturn::store
