#include "core/regular_file.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/error.hpp"

namespace overturn {
namespace {

std::string what_is_no_file(::mode_t mode) {
    return S_ISREG(mode)    ? ""
           : S_ISDIR(mode)  ? "a folder"
           : S_ISFIFO(mode) ? "a pipe"
           : S_ISSOCK(mode) ? "a socket"
                            : "a device";
}

void refuse_no_file(struct stat const& there, std::string const& problem) {
    auto const what = what_is_no_file(there.st_mode);
    validate(!S_ISDIR(there.st_mode), "{} ({}). Name one file in it", problem, what);
    validate(what.empty(), "{} ({}, no file). Write what it gives to a file, and name that", problem, what);
}

class Opened {
  public:
    // Asked before it is opened, since opening may already do something to a device; and not waiting, should a pipe
    // have come in between.
    Opened(std::filesystem::path const& path, std::string const& problem) : problem_(problem) {
        if (struct stat there{}; ::stat(path.c_str(), &there) == 0) {
            refuse_no_file(there, problem_);
        }
        fd_ = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
        int const reason = errno;
        validate(fd_ >= 0 || (reason != ENOENT && reason != ENOTDIR), "{} (no such file). Check the name", problem_);
        validate(fd_ >= 0, "{} ({}). Check its name and permissions", problem_, std::strerror(reason));
    }
    ~Opened() { ::close(fd_); }
    Opened(Opened const&) = delete;
    Opened& operator=(Opened const&) = delete;
    Opened(Opened&&) = delete;
    Opened& operator=(Opened&&) = delete;

    // A reported size may be false (a file that grows, one that the system makes up), so reading stops by itself.
    [[nodiscard]] std::string read(std::size_t most) const {
        struct stat there {};
        if (::fstat(fd_, &there) != 0) {
            fail();
        }
        refuse_no_file(there, problem_);
        refuse_larger(there.st_size, most);
        constexpr std::size_t part = 1 << 16;
        std::string bytes;
        bytes.reserve(there.st_size + part);
        while (true) {
            auto const size = bytes.size();
            bytes.resize(size + part);
            auto const got = ::read(fd_, bytes.data() + size, part);
            if (got < 0 && errno != EINTR) {
                fail();
            }
            bytes.resize(size + std::max<ssize_t>(0, got));
            if (got == 0) {
                return bytes;
            }
            refuse_larger(bytes.size(), most);
        }
    }

  private:
    void refuse_larger(std::size_t bytes, std::size_t most) const {
        validate(bytes <= most, "{} (larger than {} bytes). Check that it is the right file", problem_, most);
    }
    [[noreturn]] void fail() const {
        throw SystemError(fmt::format("{} (reading it failed: {}). Check the disk", problem_, std::strerror(errno)));
    }

    std::string const& problem_;
    int fd_ = -1;
};

}  // namespace

std::string what_is_no_file(std::filesystem::path const& path) {
    struct stat there {};
    return ::stat(path.c_str(), &there) == 0 ? what_is_no_file(there.st_mode) : "";
}

std::string read_regular_file(std::filesystem::path const& path, std::string const& problem, std::size_t most) {
    return Opened(path, problem).read(most);
}

}  // namespace overturn
