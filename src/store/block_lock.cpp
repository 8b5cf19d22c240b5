#include "store/block_lock.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/error.hpp"
#include "core/print_note.hpp"

namespace overturn::store {
namespace {

// Locks of the open file, not of the process: they end when it is closed and hold against other opens of this process.
struct flock lock_of(BlockRange const& blocks) {
    struct flock lock {};
    lock.l_type = F_WRLCK;
    lock.l_whence = SEEK_SET;
    lock.l_start = blocks.first;
    lock.l_len = blocks.count();
    return lock;
}

int open_lock(std::filesystem::path const& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) {
        throw SystemError(
            fmt::format("cannot make {} ({}). Choose another place with -o", folder.string(), error.message()));
    }
    auto const file = folder / BlockLock::file_name;
    int const fd = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (fd < 0 && errno != ENOENT) {
        throw SystemError(
            fmt::format("cannot open {} ({}). Choose another place with -o", file.string(), std::strerror(errno)));
    }
    return fd;
}

// The run that held it before may have finished and removed its folder between our opening and our locking.
bool is_still_there(int fd, std::filesystem::path const& folder) {
    struct stat ours {};
    struct stat there {};
    return ::fstat(fd, &ours) == 0 && ::stat((folder / BlockLock::file_name).c_str(), &there) == 0
           && ours.st_ino == there.st_ino && ours.st_dev == there.st_dev;
}

}  // namespace

BlockLock::BlockLock(std::filesystem::path const& folder, BlockRange blocks) {
    if (blocks.count() <= 0) {
        return;  // a length of 0 would mean everything
    }
    while (true) {
        fd_ = open_lock(folder);
        if (fd_ < 0) {
            continue;
        }
        auto lock = lock_of(blocks);
        if (::fcntl(fd_, F_OFD_SETLK, &lock) != 0) {
            int const reason = errno;
            if (reason == EAGAIN || reason == EACCES) {
                ::close(fd_);
                throw SystemError(fmt::format(
                    "{} (another run is writing there now). Wait for it, or choose another place", folder.string()));
            }
            print_note("{}: cannot be locked ({}): see to it that no other run writes there\n", folder.string(),
                       std::strerror(reason));
            return;
        }
        if (is_still_there(fd_, folder)) {
            return;
        }
        ::close(fd_);
    }
}

BlockLock::~BlockLock() {
    if (fd_ >= 0) {
        ::close(fd_);
    }
}

bool BlockLock::held(std::filesystem::path const& folder) {
    int const fd = ::open((folder / file_name).c_str(), O_RDONLY | O_CLOEXEC);
    if (fd < 0) {
        return false;
    }
    auto lock = lock_of({});
    bool const known = ::fcntl(fd, F_OFD_GETLK, &lock) == 0;
    ::close(fd);
    return known && lock.l_type != F_UNLCK;
}

}  // namespace overturn::store
