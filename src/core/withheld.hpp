/// Text in place of a file that may not be passed on: its hash, by which an owner can show that a file is the one.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace overturn {

/// "overturn-withheld sha256 <digits> of <n> bytes"
[[nodiscard]] std::string withheld_text(std::string_view sha256, std::size_t bytes);
/// Is this what stands for a file, and not a file?
[[nodiscard]] bool is_withheld(std::string_view content);

}  // namespace overturn
