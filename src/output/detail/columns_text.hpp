/// Tables for the terminal, in columns as wide as what stands in them.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace overturn::output {

struct TextColumn {
    enum class Side { left, right };

    std::string head;  ///< lines of it stand one below the other
    std::vector<std::string> cells = {};
    Side side = Side::right;
};

/// Columns that stay side by side.
using TextGroup = std::vector<TextColumn>;

/// Adds a cell to each column from the one at `first` on.
void append_row(TextGroup& columns, std::span<std::string const> cells, std::size_t first = 0);

/// Groups side by side. What a line does not hold (line_width) goes on below, again behind the first column of all.
/// \param indent blanks before each line \pre all columns have as many cells
[[nodiscard]] std::string columns_text(std::vector<TextGroup> const& groups, std::size_t indent = 0);

}  // namespace overturn::output
