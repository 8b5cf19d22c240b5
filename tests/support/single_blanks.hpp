/// Text without regard to the widths of its columns.
#pragma once

#include <string>

namespace overturn::testing {

/// Runs of blanks as one.
inline std::string single_blanks(std::string const& text) {
    std::string found;
    for (char const c : text) {
        if (c != ' ' || found.empty() || found.back() != ' ') {
            found += c;
        }
    }
    return found;
}

}  // namespace overturn::testing
