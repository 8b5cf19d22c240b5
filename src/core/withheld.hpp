/// Text in place of a file that may not be passed on: its hash, by which an owner can show that a file is the one.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace overturn {

/// "overturn-withheld sha256 <digits> of <n> bytes", and a second line "recording <recording>" where that is known.
/// \param recording equal of the components of one recording, without spaces; empty: not known
[[nodiscard]] std::string withheld_text(std::string_view sha256, std::size_t bytes, std::string_view recording);
/// The recording of such a text.
[[nodiscard]] std::string recording_of_withheld(std::string_view text);
/// Is this what stands for a file, and not a file?
[[nodiscard]] bool is_withheld(std::string_view content);

}  // namespace overturn
