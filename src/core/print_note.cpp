#include "core/print_note.hpp"

#include <algorithm>
#include <atomic>
#include <cstdio>

#include <fcntl.h>
#include <unistd.h>

#include "core/note_form.hpp"

namespace overturn {

namespace {

std::atomic<int> quiet_wishes{0};
std::atomic<NoteForm> note_form{nullptr};

std::string formed(std::string const& text, NoteForm form) {
    std::string lines;
    for (std::size_t at = 0; at < text.size();) {
        auto const end = std::min(text.find('\n', at), text.size());
        auto const line = text.substr(at, end - at);
        lines += line.empty() ? line : (line.front() == '{' ? line : form(line)) + '\n';
        at = end + 1;
    }
    return lines;
}

}  // namespace

void form_notes(NoteForm form) noexcept { note_form = form; }

QuietNotes::QuietNotes() noexcept { ++quiet_wishes; }
QuietNotes::~QuietNotes() { --quiet_wishes; }

void write_note(std::string const& text) noexcept {
    if (quiet_wishes > 0) {
        return;
    }
    (void)std::fflush(stdout);  // lines keep their order where both go into one file
    auto const form = note_form.load();
    std::string const lines = form == nullptr ? text : formed(text, form);
    (void)std::fwrite(lines.data(), 1, lines.size(), stderr);
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
