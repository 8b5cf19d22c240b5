/// What a run tells beside its results: lines on stderr, which may be full, closed or gone without harm to the work.
#pragma once

#include <string>

#include <fmt/format.h>

namespace overturn {

/// Writes `text` as it is to stderr; what cannot be written is dropped.
void put_note(std::string const& text) noexcept;

template <class... Args> void note(fmt::format_string<Args...> text, Args&&... args) {
    put_note(fmt::format(text, std::forward<Args>(args)...));
}

/// Opens /dev/null under each of the descriptors 0 to 2 that is closed: else the next file opened gets its number, and
/// what is meant for people is written into it.
void keep_standard_streams() noexcept;

}  // namespace overturn
