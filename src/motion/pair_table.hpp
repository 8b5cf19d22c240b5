/// Tables of two columns of numbers, as targets, densities and hazard curves come.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "motion/text_table.hpp"

namespace overturn {

using Pair = std::pair<double, double>;

struct PairTable {
    std::vector<Pair> points;
    std::string first_name, second_name;  ///< of the columns
    int names_line = 0;                   ///< 0: no names
    std::vector<int> line;                ///< of each point
    std::vector<TextLine> text;           ///< all above, between, beside and below the numbers but the names
};

/// Looks at a row and the one before it (null: none), and throws InputError if it may not be.
using RowCheck = std::function<void(Pair const&, Pair const*)>;

/// Form of a table of two columns: its meaning, its checks and its names.
struct PairForm {
    std::string_view meaning;  ///< for messages: "period and value"
    RowCheck check = {};       ///< of each row; none: the caller checks them
    /// Are these two the names of such columns? What they are not is prose, unless it stands right above the numbers
    /// and is parted as by a comma.
    std::function<bool(std::string_view first, std::string_view second)> are_names;
};

/// A table as read_text_table has it. \param name of the file \throws InputError with file and line, also at names of
/// more columns than there are
[[nodiscard]] PairTable read_pair_table(std::string_view content, std::string const& name, PairForm const& form);

/// \throws InputError with the file's `name` and the line of the first row that may not be
void check_rows(PairTable const& table, std::string const& name, RowCheck const& check);

/// Points of a table alone, under names that are those of such columns, or none. \throws InputError also at other names
[[nodiscard]] std::vector<Pair> read_pairs(std::string_view content, std::string const& name, PairForm const& form);

}  // namespace overturn
