/// Text above rows of numbers, as tables of all kinds come: records, lists of values.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
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
    /// Precision of a column's printed numbers: most digits behind the point, most significant ones.
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

/// Form in which a table is read.
struct TableForm {
    std::string_view begin_with = "Give columns time,a_horizontal";  ///< advice for one without numbers
    std::size_t columns = 0;                                         ///< that it must have; 0: any number
    bool motion = true;  ///< a count and a time step may stand above the rows, no text behind a row's numbers
};

/// Fields are parted by commas, semicolons, tabs or blanks; where by blanks alone, numbers may touch at a sign. What
/// begins with #, %, ; or ! is text, on a line of its own or, # and !, behind numbers that are no motion. Of a motion,
/// a first row of two, the first a whole number, above rows of one or more than two belongs to the head ("npts dt"), as
/// does such a row above as many rising times with values. \throws InputError at the line that is no row of as many
/// finite numbers as the first; if there is no row
[[nodiscard]] TextTable read_text_table(std::string_view content, std::string const& file, TableForm const& form = {});

/// Does a row of numbers stand below at most head_lines_at_most lines of text?
[[nodiscard]] bool holds_text_table(std::string_view content);

/// Is a line text, whatever it holds: blank, or with the mark of a comment before it?
[[nodiscard]] bool is_comment(std::string_view line);

struct Names {
    std::vector<std::string> names;
    bool by_blanks = false;  ///< alone, as words of prose are: then each must be one that is known
    bool comment = false;    ///< behind such a mark
    int line = 0;            ///< 0: there are none
};

/// The names on a line over `count` columns: parted by commas, semicolons, tabs, bars, two blanks, or single ones with
/// what stands in brackets kept whole. Empty if none of these gives as many.
[[nodiscard]] Names names_on(std::string_view line, std::size_t count);

/// The lowest line of the head that names all columns, each with the unit that a row of units below it states; units
/// alone, "(s)" and "(g)", where there are no names. `are`
/// says whether they are names, of a line right above the numbers or not: what is none is prose. `elsewhere` sees each
/// line that is none before that is passed over.
[[nodiscard]] Names names_above(TextTable const& table, std::function<bool(Names const&, bool lowest)> const& are,
                                std::function<void(TextLine const&, bool lowest)> const& elsewhere);

}  // namespace overturn
