#include "core/print_note.hpp"

#include <algorithm>
#include <atomic>
#include <cstdio>

#include <fcntl.h>
#include <unistd.h>

#include "core/note_form.hpp"
#include "core/wrapped.hpp"

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

// What ends without '\n' waits for an answer or is written over: it stays.
std::string for_people(std::string const& text) {
    bool const is_json = text.starts_with('{');
    return is_json || text.empty() || text.back() != '\n' ? text : narrowed(text);
}

void write_all(std::string const& text) noexcept {
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

}  // namespace

void form_notes(NoteForm form) noexcept { note_form = form; }

QuietNotes::QuietNotes() noexcept { ++quiet_wishes; }
QuietNotes::~QuietNotes() { --quiet_wishes; }

void write_note(std::string const& text) noexcept { write_all(note_form.load() == nullptr ? for_people(text) : text); }

void write_line(std::string const& line) noexcept { write_all(line + '\n'); }

void keep_standard_streams() noexcept {
    for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream) {
        if (::fcntl(stream, F_GETFD) == -1) {
            (void)::open("/dev/null", O_RDWR);  // takes the lowest free number, which is this one
        }
    }
}

}  // namespace overturn
