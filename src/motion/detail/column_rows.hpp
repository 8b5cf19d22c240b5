/// Rows of numbers parted by commas, semicolons, blanks or tabs, as the readers of columns find them.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "motion/prose.hpp"

namespace overturn {

inline constexpr std::size_t columns_at_most = 4;  ///< time and three components

/// The fields of one row; one more than allowed is kept, to be told from the allowed ones.
struct Fields {
    std::array<std::string_view, columns_at_most + 1> text;
    std::size_t count = 0;
};

/// Fields are parted by blanks and tabs, by a comma or semicolon, or by both.
[[nodiscard]] Fields split_fields(std::string_view line);

/// Empty, or a comment.
[[nodiscard]] bool is_skipped(std::string_view line);

/// A line of names: its first field begins no number, and is no "nan" or "inf" either.
[[nodiscard]] bool is_names(Fields const& fields);

/// Names may hold blanks where commas or semicolons part them.
[[nodiscard]] std::vector<std::string> names_on(std::string_view line);

struct Rows {
    std::array<std::vector<double>, columns_at_most> column;
    std::vector<int> line;
    std::size_t columns = 0;
    std::vector<std::string> names;  ///< of the columns, if a line of names stands above them
    int names_line = 0;
    Prose prose;       ///< of the comments
    int decimals = 0;  ///< most behind the point, in the first column
    int figures = 0;   ///< most significant ones, in the first column

    [[nodiscard]] bool named() const { return names.size() == columns; }
};

/// \throws InputError at the line that is no row of as many finite numbers as the first
[[nodiscard]] Rows read_rows(std::string_view content, std::string const& file);

}  // namespace overturn
