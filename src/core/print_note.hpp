/// Notes of a run beside its results: lines on stderr, which may be full, closed or gone without harm to the work.
#pragma once

#include <string>

#include <fmt/format.h>

namespace overturn {

/// Writes `text` to stderr with its longer lines wrapped (narrowed()), at a terminal or into a log. Programs read notes
/// as JSON (form_notes), a line each. What cannot be written is dropped.
void write_note(std::string const& text) noexcept;

/// A line that stays one however long it is: an error, which editors and scripts read. \param line without its end
void write_line(std::string const& line) noexcept;

template <class... Args> void print_note(fmt::format_string<Args...> text, Args&&... args) {
    write_note(fmt::format(text, std::forward<Args>(args)...));
}

/// While one lives, notes are dropped: of a run within a check of many.
class QuietNotes {
  public:
    QuietNotes() noexcept;
    ~QuietNotes();
    QuietNotes(QuietNotes const&) = delete;
    QuietNotes& operator=(QuietNotes const&) = delete;
    QuietNotes(QuietNotes&&) = delete;
    QuietNotes& operator=(QuietNotes&&) = delete;
};

/// Opens /dev/null under each of the descriptors 0 to 2 that is closed: else the next file opened gets its number, and
/// what is meant for people is written into it.
void keep_standard_streams() noexcept;

}  // namespace overturn
