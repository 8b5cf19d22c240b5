/// Tables that people write by hand or export: rows of cells parted by commas, semicolons, tabs or blanks, below a
/// header.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "motion/text_lines.hpp"

namespace overturn::cli {

/// A cell without the blanks and quotes around it.
struct CsvCell {
    std::string_view text;
    int column = 0;  ///< where it begins, from 1
};

/// A table row by row. The header's first separator parts all rows, blanks if it has none; empty lines and what follows
/// # do not count; no cell holds a separator.
class CsvRows {
  public:
    /// Reads the header. \param text outlives the cells \param file for messages, outlives this
    /// \param begin_with what to do about an empty text
    /// \throws InputError if there is none
    CsvRows(std::string_view text, std::string const& file, std::string_view begin_with);

    [[nodiscard]] std::vector<CsvCell> const& header() const { return header_; }
    /// The next row, of as many cells as the header, or nothing after the last. \throws InputError
    [[nodiscard]] std::optional<std::vector<CsvCell>> next();

    /// What a cell is that was to be a number: one with a decimal comma, or none.
    [[nodiscard]] static std::string_view why_no_number(CsvCell const& cell);

    /// \throws InputError at a cell of the row handed out last, or of the header before any
    [[noreturn]] void fail(CsvCell const& cell, std::string const& message) const;
    /// \throws InputError at the line read last
    [[noreturn]] void fail(std::string const& message) const;

  private:
    [[nodiscard]] std::optional<std::vector<CsvCell>> next_cells();

    TextLines lines_;
    std::string const& file_;
    std::optional<char> separator_;  // once there is a header
    std::vector<CsvCell> header_;
};

}  // namespace overturn::cli
