/// Text above rows of numbers, as tables of all kinds come: records, lists of values.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace overturn {

struct TextLine {
    std::string text;  ///< in UTF-8
    int number = 0;
};

struct TextTable {
    std::vector<TextLine> head;               ///< comments and prose above the numbers, blank lines left out
    std::vector<TextLine> notes;              ///< comments between and below them, as many as above at most
    std::vector<std::vector<double>> column;  ///< of equal length, but for a list's last row
    std::vector<int> line;                    ///< of each row
    /// How finely a column's numbers are printed: most digits behind the point, most significant ones.
    struct Digits {
        int decimals = 0, figures = 0;
    };
    static constexpr std::size_t looked_at = 3;
    std::array<Digits, looked_at> digits{};  ///< of the first columns
    bool last_row_short = false;
    char separator = ' ';  ///< of the first row: a comma, semicolon, tab or blank

    [[nodiscard]] std::size_t columns() const { return column.size(); }
    [[nodiscard]] std::size_t values() const;
    /// All values in reading order.
    [[nodiscard]] std::vector<double> in_rows() const;
};

inline constexpr int head_lines_at_most = 250;

/// Fields are parted by commas, semicolons, tabs or blanks; where by blanks alone, numbers may touch at a sign. A
/// first row of two, the first a whole number, above rows of one or more than two belongs to the head ("npts dt"), as
/// does such a row above as many rising times with values. \throws InputError at the line that is no row of as
/// many finite numbers as the first; if there is no row
[[nodiscard]] TextTable read_text_table(std::string_view content, std::string const& file);

/// Does a row of numbers stand below at most head_lines_at_most lines of text?
[[nodiscard]] bool holds_text_table(std::string_view content);

struct Names {
    std::vector<std::string> names;
    bool by_blanks = false;  ///< alone, as words of prose are: then each must be one that is known
};

/// The names on a line over `count` columns: parted by commas, semicolons, tabs, bars, two blanks, or single ones with
/// what stands in brackets kept whole. Empty if none of these gives as many.
[[nodiscard]] Names names_on(std::string_view line, std::size_t count);

}  // namespace overturn
