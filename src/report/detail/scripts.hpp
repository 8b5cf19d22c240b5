/// The Python scripts of this folder, carried in the program so that it needs no path to them.
#pragma once

#include <span>
#include <string_view>

namespace overturn::report {

struct Script {
    std::string_view name;  ///< "style.py"
    std::string_view text;
};

/// All of them; written by the build from the files themselves.
[[nodiscard]] std::span<Script const> scripts();

}  // namespace overturn::report
