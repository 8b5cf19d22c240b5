/// Sentences in lines that fit a terminal.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace overturn {

inline constexpr std::size_t line_width = 100;

/// \param indent of all lines but the first \param begun what the first line begins with
/// \return lines of at most `width` columns (a longer word stands alone), each with its end; % stays with its number
[[nodiscard]] std::string wrapped(std::string_view text, std::size_t indent = 0, std::size_t width = line_width,
                                  std::string begun = {});

/// The text with its longer lines wrapped, each behind its own indent and four blanks more. A command at the end of a
/// line ("...: overturn run c.toml --resume") stays whole, to be pasted into a shell: on a line of its own if need be.
[[nodiscard]] std::string narrowed(std::string_view text);

inline constexpr std::size_t label_width = 10;

/// A label in so many columns, and its text beside it in lines that fit a terminal.
[[nodiscard]] std::string labelled(std::string_view label, std::string_view text, std::size_t columns = label_width);

}  // namespace overturn
