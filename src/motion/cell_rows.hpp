/// Tables that people write by hand or export: rows of cells parted by commas, semicolons, tabs or blanks, below a
/// header.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "motion/text_lines.hpp"
#include "motion/text_table.hpp"

namespace overturn {

/// A cell without the blanks and quotes around it.
struct Cell {
    std::string_view text;
    int column = 0;  ///< its first column, from 1
};

/// "0.2", ">1.3", "0,2"
[[nodiscard]] bool is_like_a_number(Cell const& cell);

/// A table row by row. The header's first separator parts all rows, blanks if it has none; no cell holds a separator.
/// The header is the first line that is no comment, or the one right above the first numbers where those above it are
/// parted otherwise: these and what follows # are text.
class CellRows {
  public:
    /// Reads the header. \param text outlives the cells \param file for messages, outlives this
    /// \param begin_with what to do about an empty text
    /// \throws InputError if there is none
    CellRows(std::string_view text, std::string const& file, std::string_view begin_with);

    [[nodiscard]] std::vector<Cell> const& header() const { return header_; }
    [[nodiscard]] int header_line() const { return header_line_; }
    /// The next row, of as many cells as the header, or nothing after the last. \throws InputError
    [[nodiscard]] std::optional<std::vector<Cell>> next();

    /// Number of the row's line handed out last, or of the header before any.
    [[nodiscard]] int line() const { return lines_.number(); }

    /// Comments and prose, of all rows handed out so far.
    [[nodiscard]] std::vector<TextLine> const& text() const { return text_; }

    /// 1, yes, true; 0, no, false; nothing of other words.
    [[nodiscard]] static std::optional<bool> yes_or_no(Cell const& cell);
    /// Why a cell is no number: it has a decimal comma, or none is there.
    [[nodiscard]] static std::string_view why_no_number(Cell const& cell);

    /// \throws InputError at a cell of the row handed out last, or of the header before any
    [[noreturn]] void fail(Cell const& cell, std::string const& message) const;
    /// \throws InputError at the line read last
    [[noreturn]] void fail(std::string const& message) const;

  private:
    [[nodiscard]] std::optional<std::vector<Cell>> next_cells();
    void keep(std::string_view text);

    TextLines lines_;
    std::string const& file_;
    std::optional<char> separator_;  // once there is a header
    std::vector<Cell> header_;
    int header_line_ = 0;
    std::vector<TextLine> text_;
};

}  // namespace overturn
