/// A results file while it is written: what HDF5 holds open of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/field.hpp"
#include "store/detail/columns.hpp"
#include "store/detail/h5.hpp"
#include "store/results_file.hpp"

namespace overturn::store {

struct ResultsWriter::Growing {
    struct Table {
        TableSpec spec;
        std::optional<Dataset> numbers;  ///< the axis, where it numbers the rows
        std::vector<Dataset> datasets;
        std::int64_t rows = 0;
        std::int64_t written = 0;        ///< to the file
        std::vector<std::byte> waiting;  ///< rows behind them: many are written in little more time than one

        [[nodiscard]] std::int64_t taken() const {
            return written + static_cast<std::int64_t>(waiting.size() / spec.row_bytes);
        }
    };

    /// \throws SystemError if the file cannot be made
    Growing(std::string const& path, Layout how);

    /// Writes the rows that wait.
    void write(Table& table);
    /// Made with those that it lies in, if it is not there yet.
    Group& group(std::string const& path);
    /// When a column gets its place in a plain file.
    enum class Room {
        now,  ///< so that it is known before any row is
        later
    };
    Dataset create(std::string const& where, Field const& spec, std::int64_t rows, Room room = Room::later);
    [[nodiscard]] Dataset open(std::string const& path) const;
    /// \param axis of the group `where`, or a path; empty or the dataset's own name: itself
    void lay_along(std::string const& where, Dataset const& dataset, std::string const& name,
                   std::string const& axis) const;
    void write_categories(Dataset const& dataset, Field const& spec, std::span<std::int64_t const> values,
                          std::int64_t first, std::string const& name);
    void write_array(std::string const& where, Field const& spec, hid_t memory_type, void const* values,
                     std::size_t count, std::string const& scale);
    /// Lets everything go unclosed: HDF5 cannot close a file that it could not write (it crashes).
    void abandon();

    Layout layout;
    Quiet quiet;
    File file;
    ColumnTypes types;
    std::map<std::string, Group> groups;
    std::vector<Table> tables;
};

}  // namespace overturn::store
