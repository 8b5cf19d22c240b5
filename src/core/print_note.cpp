#include "core/print_note.hpp"

#include <atomic>
#include <cstdio>

#include <fcntl.h>
#include <unistd.h>

namespace overturn {

namespace {

std::atomic<int> quiet_wishes{0};

}  // namespace

QuietNotes::QuietNotes() noexcept { ++quiet_wishes; }
QuietNotes::~QuietNotes() { --quiet_wishes; }

void write_note(std::string const& text) noexcept {
    if (quiet_wishes > 0) {
        return;
    }
    (void)std::fflush(stdout);  // lines keep their order where both go into one file
    (void)std::fwrite(text.data(), 1, text.size(), stderr);
    (void)std::fflush(stderr);
    std::clearerr(stderr);
}

void keep_standard_streams() noexcept {
    for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream) {
        if (::fcntl(stream, F_GETFD) == -1) {
            (void)::open("/dev/null", O_RDWR);  // takes the lowest free number, which is this one
        }
    }
}

}  // namespace overturn
