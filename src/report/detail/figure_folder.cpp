#include "report/detail/figure_folder.hpp"

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include "core/error.hpp"

namespace overturn::report {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view beginning = "overturn-figure-";
constexpr std::string_view lock_name = "in-use";

// Of a program that lives, or that has just made it and not locked it yet.
bool is_in_use(fs::path const& folder) {
    constexpr auto soon = std::chrono::minutes(1);
    int const lock = ::open((folder / lock_name).c_str(), O_RDONLY | O_CLOEXEC);
    if (lock < 0) {
        std::error_code error;
        auto const made = fs::last_write_time(folder, error);
        return error || fs::file_time_type::clock::now() - made < soon;
    }
    bool const taken = ::flock(lock, LOCK_EX | LOCK_NB) != 0;
    ::close(lock);
    return taken;
}

// Other people's folders cannot be opened or removed, and stay.
void remove_left_over(fs::path const& place) {
    std::error_code ignored;
    for (fs::directory_iterator at(place, ignored), end; at != end; at.increment(ignored)) {
        if (at->path().filename().string().starts_with(beginning) && at->is_directory(ignored)
            && !at->is_symlink(ignored) && !is_in_use(at->path())) {
            std::error_code stays;
            fs::remove_all(at->path(), stays);
        }
    }
}

[[noreturn]] void fail() {
    throw SystemError("no temporary folder (the figure's data go there). Make room, or set TMPDIR");
}

}  // namespace

FigureFolder::FigureFolder() {
    std::error_code error;
    auto const place = fs::temp_directory_path(error);
    if (error) {
        fail();
    }
    remove_left_over(place);
    auto name = (place / beginning).string() + "XXXXXX";
    if (::mkdtemp(name.data()) == nullptr) {
        fail();
    }
    path_ = name;
    constexpr ::mode_t mine = 0600;
    lock_ = ::open((path_ / lock_name).c_str(), O_RDONLY | O_CREAT | O_CLOEXEC, mine);
    if (lock_ >= 0) {
        (void)::flock(lock_, LOCK_EX);
    }
}

FigureFolder::~FigureFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
    if (lock_ >= 0) {
        ::close(lock_);
    }
}

std::string FigureFolder::write(std::string_view name, std::string_view text) const {
    auto const path = path_ / name;
    std::ofstream file(path, std::ios::binary);
    file << text;
    if (!file.flush()) {
        throw SystemError(fmt::format("{}: cannot be written (is the disk full?). Make room", path.string()));
    }
    return path.string();
}

}  // namespace overturn::report
