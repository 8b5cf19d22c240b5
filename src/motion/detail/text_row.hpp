/// One line of a table: its fields, as numbers.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace overturn {

/// The next field, cut off `rest`, without quotes around it; nothing where a separator ends the line behind the last
/// one.
[[nodiscard]] std::string_view cut_field(std::string_view& rest);

/// Are its commas decimal points, as in "0,01; 1,5", "0,01 1,5" or "0,01,1,05"? Those beside a semicolon are, within
/// quotes, or between digits beside blanks, where no point is; and those before a nought that more digits follow.
[[nodiscard]] bool has_decimal_commas(std::string_view line);

/// Advice for a line with decimal commas, with the line's text.
[[nodiscard]] std::string decimal_comma_text(std::string_view line);

/// Fields of a line that are parted by commas or semicolons, or that touch nowhere.
struct TextRow {
    std::vector<double> values;
    std::string_view bad;  ///< the first field that is no finite number
    std::size_t bad_at = 0;
    bool decimal_comma = false;
    bool numbers = true;
};
void read_row(std::string_view line, TextRow& row);

/// Begins it like a row of numbers, whatever follows? "1,x" and "nan,1" do, "1992 Landers" and "000,090,UP" do not.
[[nodiscard]] bool begins_like_numbers(std::string_view line, TextRow const& row);

}  // namespace overturn
