/// Where the rows of a growing results file lie in it, so that other processes can write some of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace overturn::store {

/// One column of a table: `bytes` a row from byte `at` of the file on. They are the first ones of the field that lies
/// at `offset` of a row; or of the row's number.
struct ColumnPlace {
    static constexpr std::uint64_t of_number = ~std::uint64_t{0};  ///< in the place of an offset

    std::string path;  ///< "/trials/verdict"
    std::uint64_t at = 0;
    std::uint64_t bytes = 0, offset = 0;
};

struct TablePlace {
    std::size_t row_bytes = 0;
    std::int64_t rows = 0;
    std::vector<ColumnPlace> columns;
};

/// Tables in the order in which the file has them. As a text they travel to other processes of this program.
struct RowPlaces {
    std::filesystem::path file;
    std::vector<TablePlace> tables;

    [[nodiscard]] std::string serialise() const;
    [[nodiscard]] static RowPlaces deserialise(std::string const& text);
};

/// Writes rows into their places. Each row is written once, by one process.
class PlacedRows {
  public:
    /// \throws SystemError if the file cannot be opened
    explicit PlacedRows(RowPlaces places);
    ~PlacedRows();
    PlacedRows(PlacedRows const&) = delete;
    PlacedRows& operator=(PlacedRows const&) = delete;
    PlacedRows(PlacedRows&&) = delete;
    PlacedRows& operator=(PlacedRows&&) = delete;

    /// \param first place of the first row in its table; rows that follow those before cost least
    /// \param rows as ResultsWriter::append takes them \throws SystemError if they cannot be written
    void write(std::size_t table, std::int64_t first, std::span<std::byte const> rows);
    /// Writes what waits, and lets the disk have it. \throws SystemError
    void finish();

  private:
    struct Waiting {
        std::int64_t first = 0;
        std::vector<std::byte> rows;
    };
    void put(std::size_t table);

    RowPlaces places_;
    std::vector<Waiting> waiting_;
    int file_ = -1;
};

}  // namespace overturn::store
