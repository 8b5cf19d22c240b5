/// The columns of results that this program knows: those of its page COLUMNS.md, and of earlier formats.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace overturn::store {

/// A group by the page's name of it, without the names that a campaign gives: "limits/touches/stripes/type-a" is
/// "limits/<limit>/stripes/<body>".
[[nodiscard]] std::string page_name_of(std::string_view group, std::span<std::string const> bodies);

/// Is the column on the page, or one that an earlier format had?
/// \param group without a slash before it, as the page has it: "stripes/<body>"
[[nodiscard]] bool is_known_column(std::string_view group, std::string_view column);

}  // namespace overturn::store
