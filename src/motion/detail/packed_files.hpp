/// Files that are no text: known by their first bytes, so that a message can name them.
#pragma once

#include <string_view>

namespace overturn {

/// What a binary file is and what to do with it; both empty if its first bytes tell nothing.
struct PackedFile {
    std::string_view name;
    std::string_view advice;
};
[[nodiscard]] PackedFile packed_file(std::string_view content);

}  // namespace overturn
