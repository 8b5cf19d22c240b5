/// The cells of tables that people write by hand or export.
#pragma once

#include <string_view>
#include <vector>

namespace overturn::cli {

struct CsvCell {
    std::string_view text;
    int column = 0;  ///< where it begins, from 1
};

/// A row's cells without the blanks and quotes around them; what follows # is a comment. No cell holds a separator.
[[nodiscard]] std::vector<CsvCell> cells_of(std::string_view line, char separator);

/// The first of comma, semicolon and tab in a header; a comma if there is none.
[[nodiscard]] char separator_of(std::string_view header);

/// Nothing but blanks and a comment.
[[nodiscard]] bool is_blank(std::vector<CsvCell> const& cells);

}  // namespace overturn::cli
