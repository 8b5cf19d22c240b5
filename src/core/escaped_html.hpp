/// Plain text for pages.
#pragma once

#include <string>
#include <string_view>

namespace overturn {

/// The text with the characters that mean something to HTML replaced, in attributes too.
[[nodiscard]] std::string escaped_html(std::string_view text);

}  // namespace overturn
