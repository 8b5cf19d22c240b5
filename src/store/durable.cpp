#include "store/durable.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <deque>
#include <set>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/types.h>
#include <unistd.h>

#include "core/error.hpp"
#include "core/next_step.hpp"
#include "core/regular_file.hpp"

namespace overturn::store {

namespace {

char const* remedy_of(int reason) {
    switch (reason) {
        case ENOSPC:
        case EDQUOT:
        case EFBIG:
            return "Free space or choose another place";
        case ENOENT:
        case ENOTDIR:
        case ESTALE:
            return "Bring the folder back";
        case EROFS:
        case EACCES:
        case EPERM:
            return "Make it writable";
        default:
            return "Check the disk";
    }
}

}  // namespace

std::string advice_on_disk(int reason) { return fmt::format("{}, then {}", remedy_of(reason), next_step()); }

namespace {

constexpr ::mode_t open_mode = 0666;  // less what the umask takes

[[noreturn]] void fail(char const* what, std::filesystem::path const& path) {
    int const reason = errno;
    throw SystemError(
        fmt::format("cannot {} {} ({}). {}", what, path.string(), std::strerror(reason), advice_on_disk(reason)));
}

class Descriptor {
  public:
    Descriptor(std::filesystem::path const& path, int flags)
        : path_(path), fd_(::open(path.c_str(), flags, open_mode)) {
        if (fd_ < 0) {
            fail("open", path_);
        }
    }
    ~Descriptor() { ::close(fd_); }
    Descriptor(Descriptor const&) = delete;
    Descriptor& operator=(Descriptor const&) = delete;
    Descriptor(Descriptor&&) = delete;
    Descriptor& operator=(Descriptor&&) = delete;

    void write(std::span<std::byte const> content) const {
        while (!content.empty()) {
            auto const written = ::write(fd_, content.data(), content.size());
            if (written < 0 && errno == EINTR) {
                continue;
            }
            if (written < 0) {
                fail("write", path_);
            }
            content = content.subspan(written);
        }
    }
    [[nodiscard]] std::string read() const {
        constexpr std::size_t part = 1 << 16;
        std::string content;
        while (true) {
            auto const size = content.size();
            content.resize(size + part);
            auto const got = ::read(fd_, content.data() + size, part);
            content.resize(size + std::max<ssize_t>(0, got));
            if (got == 0) {
                return content;
            }
            if (got < 0 && errno != EINTR) {
                fail("read", path_);
            }
        }
    }
    // Only a beginning: whoever needs the file on the disk calls sync.
    void begin_sync() const {
#ifdef SYNC_FILE_RANGE_WRITE
        (void)::sync_file_range(fd_, 0, 0, SYNC_FILE_RANGE_WRITE);
#endif
    }
    void sync() const {
        // Some file systems cannot sync a folder and say EINVAL; the rename itself is still atomic there.
        if (::fsync(fd_) != 0 && errno != EINVAL) {
            fail("sync", path_);
        }
    }

  private:
    std::filesystem::path path_;
    int fd_;
};

// Of this process alone, wherever in the cluster others write the same file.
std::string own_ending() {
    std::array<char, 65> host{};
    ::gethostname(host.data(), host.size() - 1);
    return fmt::format("{}-{}-{}", unfinished_mark, host.data(), ::getpid());
}

std::filesystem::path folder_of(std::filesystem::path const& path) {
    return path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
}

}  // namespace

void make_durable(std::filesystem::path const& path) { Descriptor(path, O_RDONLY).sync(); }

void rename_durably(std::filesystem::path const& from, std::filesystem::path const& to) {
    if (std::rename(from.c_str(), to.c_str()) != 0) {
        fail("rename to", to);
    }
    make_durable(folder_of(to));
}

namespace {

// A file under a name of this process's own beside its place, gone again unless it is put there.
class BesideFile {
  public:
    BesideFile(std::filesystem::path const& path, std::span<std::byte const> content)
        : path_(path), beside_(path.string() + own_ending()), file_(beside_, O_WRONLY | O_CREAT | O_TRUNC) {
        try {
            file_.write(content);
            file_.begin_sync();
        } catch (SystemError const&) {
            remove();  // half a file would only keep a full disk full
            throw;
        }
    }
    ~BesideFile() { remove(); }
    BesideFile(BesideFile const&) = delete;
    BesideFile& operator=(BesideFile const&) = delete;
    BesideFile(BesideFile&&) = delete;
    BesideFile& operator=(BesideFile&&) = delete;

    void sync() const { file_.sync(); }
    void rename() {
        if (std::rename(beside_.c_str(), path_.c_str()) != 0) {
            fail("rename to", path_);
        }
        beside_.clear();
    }
    // Whether there was none before.
    bool link() {
        if (::link(beside_.c_str(), path_.c_str()) == 0) {
            return true;
        }
        if (errno == EEXIST) {
            return false;
        }
        rename();  // a file system without links
        return true;
    }

  private:
    void remove() const {
        if (!beside_.empty()) {
            ::unlink(beside_.c_str());
        }
    }

    std::filesystem::path path_, beside_;
    Descriptor file_;
};

// All are on their way to the disk before the first is waited for: its journal then takes them in one go.
void write_together(std::span<FileContent const> files) {
    std::deque<BesideFile> written;
    std::set<std::filesystem::path> folders;
    for (auto const& [path, bytes] : files) {
        written.emplace_back(path, bytes);
        folders.insert(folder_of(path));
    }
    for (auto const& file : written) {
        file.sync();
    }
    for (auto& file : written) {
        file.rename();
    }
    for (auto const& folder : folders) {
        make_durable(folder);
    }
}

}  // namespace

void write_durably(std::filesystem::path const& path, std::span<std::byte const> content) {
    FileContent const file{path, content};
    write_durably(std::span(&file, 1));
}

void write_durably(std::filesystem::path const& path, std::string_view text) {
    write_durably(path, std::as_bytes(std::span(text)));
}

void write_durably(std::span<FileContent const> files) {
    constexpr std::size_t most_open = 64;
    for (; !files.empty(); files = files.subspan(std::min(most_open, files.size()))) {
        write_together(files.first(std::min(most_open, files.size())));
    }
}

bool create_durably(std::filesystem::path const& path, std::span<std::byte const> content) {
    bool made = false;
    {
        BesideFile file(path, content);
        file.sync();
        made = file.link();
    }
    make_durable(folder_of(path));
    return made;
}

FileInWork::FileInWork(std::filesystem::path path) : path_(std::move(path)), beside_(path_) { beside_ += own_ending(); }

FileInWork::~FileInWork() { ::unlink(beside_.c_str()); }

void FileInWork::keep() {
    make_durable(beside_);
    rename_durably(beside_, path_);
}

void append(std::filesystem::path const& path, std::span<std::byte const> content) {
    Descriptor(path, O_WRONLY | O_APPEND).write(content);
}

std::string read_file(std::filesystem::path const& path) {
    if (auto const what = what_is_no_file(path); !what.empty()) {  // a pipe would be waited for
        throw SystemError(fmt::format("cannot read {} ({}, no file). Move it away", path.string(), what));
    }
    Descriptor const file(path, O_RDONLY);
    return file.read();
}

void require_writable(std::filesystem::path const& path) {
    auto probe = path;
    probe += own_ending();
    int const fd = ::open(probe.c_str(), O_WRONLY | O_CREAT | O_EXCL, open_mode);
    if (fd < 0 && errno != EEXIST) {
        int const reason = errno;
        auto const text = fmt::format("output {} (cannot write there: {}). ", path.string(), std::strerror(reason));
        if (reason == ENOENT || reason == ENOTDIR || reason == ENAMETOOLONG) {
            throw InputError(text + "Choose another place");
        }
        throw SystemError(text + "Make it writable, or choose another place");
    }
    if (fd >= 0) {
        ::close(fd);
        ::unlink(probe.c_str());
    }
}

}  // namespace overturn::store
