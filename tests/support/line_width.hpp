/// Lines that a terminal does not hold.
#pragma once

#include <cstddef>
#include <sstream>
#include <string>

namespace overturn::testing {

/// Those of a text that have more columns; empty where there is none.
inline std::string too_wide(std::string const& text) {
    constexpr std::size_t columns = 100;
    std::istringstream lines(text);
    std::string found;
    for (std::string line; std::getline(lines, line);) {
        found += line.size() > columns ? line + '\n' : std::string();
    }
    return found;
}

}  // namespace overturn::testing
