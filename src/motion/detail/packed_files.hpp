/// Files that are no text: known by their first bytes, so that a message can name them.
#pragma once

#include <string_view>

namespace overturn {

/// A binary file: its kind, why it is not read and what to do with it; all empty if its first bytes are not known.
struct PackedFile {
    std::string_view name;
    std::string_view advice;
    std::string_view why = "records are read as text";
};
[[nodiscard]] PackedFile packed_file(std::string_view content);

/// A data record of SEED 2, which has a reader.
[[nodiscard]] bool is_miniseed(std::string_view content);

}  // namespace overturn
