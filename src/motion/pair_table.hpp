/// Tables of two columns of numbers, as targets and densities come.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "motion/text_table.hpp"

namespace overturn {

using Pair = std::pair<double, double>;

/// Rows of two numbers between blanks, commas or semicolons; `#` and `!` begin a comment, lines of text may come first,
/// the last of two names being those of the columns. \param name of the file \param meaning of the columns, for
/// messages: "period and value" \param check looks at each row and the one before it (null: none) and throws InputError
/// if it may not be \throws InputError with file and line
struct PairTable {
    std::vector<Pair> points;
    std::string first_name, second_name;  ///< of the columns, from the line of names or a comment above the numbers
    int names_line = 0;                   ///< 0: no names
    std::vector<int> line;                ///< of each point
    std::vector<TextLine> head;           ///< comments and text above the numbers, comments below
};
[[nodiscard]] PairTable read_pair_table(std::string_view content, std::string const& name, std::string_view meaning,
                                        std::function<void(Pair const&, Pair const*)> const& check);

/// Its points alone.
[[nodiscard]] std::vector<Pair> read_pairs(std::string_view content, std::string const& name, std::string_view meaning,
                                           std::function<void(Pair const&, Pair const*)> const& check);

}  // namespace overturn
