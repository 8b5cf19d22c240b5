/// A lock on blocks of an output, so that no two runs write the same blocks at once.
#pragma once

#include <cstdint>
#include <filesystem>

namespace overturn::store {

/// Blocks [first, last) of a shard folder.
struct BlockRange {
    std::int64_t first = 0, last = 0;

    [[nodiscard]] bool holds(std::int64_t block) const { return block >= first && block < last; }
    [[nodiscard]] std::int64_t count() const { return last - first; }
};

/// Holds blocks for as long as it lives. It is a lock on bytes of the file `lock` in the folder, one byte to a block,
/// that the kernel keeps: it ends with the process however that dies, so nothing stale is left. Over NFS the server
/// keeps it for all nodes (version 4: until a lost node's lease is up, about 90 s); a file system without locks is
/// warned of on stderr and goes unguarded.
class BlockLock {
  public:
    /// Makes the folder if it is not there.
    /// \throws SystemError if another process, or another lock of this one, holds any of the blocks: no input is at
    /// fault, and a later try may do \throws SystemError if the folder or the file cannot be made
    BlockLock(std::filesystem::path const& folder, BlockRange blocks);
    ~BlockLock();
    BlockLock(BlockLock const&) = delete;
    BlockLock& operator=(BlockLock const&) = delete;
    BlockLock(BlockLock&&) = delete;
    BlockLock& operator=(BlockLock&&) = delete;

    /// Does anybody hold any block there? False also where it is not known.
    [[nodiscard]] static bool held(std::filesystem::path const& folder);

    /// The lock's name in the folder.
    static constexpr char const* file_name = "lock";

  private:
    int fd_ = -1;
};

}  // namespace overturn::store
