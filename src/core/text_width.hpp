/// Widths of text in columns of a terminal: 'ä' takes one, 'あ' two.
#pragma once

#include <cstddef>
#include <string_view>

namespace overturn {

/// Columns of UTF-8 text on a terminal, as fmt counts them where it fills to a width: two for East Asian wide
/// characters and emoji, one for all others. A combining accent counts as one although it takes none.
[[nodiscard]] std::size_t text_width(std::string_view text);

/// The longest beginning of at most `width` columns that ends with a whole character.
[[nodiscard]] std::string_view text_head(std::string_view text, std::size_t width);

/// The longest end of at most `width` columns that begins with a whole character.
[[nodiscard]] std::string_view text_tail(std::string_view text, std::size_t width);

}  // namespace overturn
