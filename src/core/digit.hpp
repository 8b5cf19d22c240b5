/// Which letters are digits, whatever the locale.
#pragma once

namespace overturn {

[[nodiscard]] constexpr bool is_digit(char letter) { return letter >= '0' && letter <= '9'; }

}  // namespace overturn
