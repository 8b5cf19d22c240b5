/// Tests for digits and small letters, independent of the locale.
#pragma once

namespace overturn {

[[nodiscard]] constexpr bool is_digit(char letter) { return letter >= '0' && letter <= '9'; }
[[nodiscard]] constexpr bool is_small_letter(char letter) { return letter >= 'a' && letter <= 'z'; }

}  // namespace overturn
