/// Description of a column in the file for its readers: HDF5's dimension scales and committed types, netCDF's
/// dimensions and CF's attributes.
#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "core/field.hpp"
#include "store/detail/h5.hpp"

namespace overturn::store {

/// Bytes of a value, as many as the largest one needs: 1 or 2.
[[nodiscard]] std::size_t category_bytes(Field const& column);

/// The types of a file's columns. Enumerations are committed in its root as "<column>_type" (a second one of that name
/// as "<column>_type_2"): netCDF reads no other, and it reads those of the root before any column.
class ColumnTypes {
  public:
    /// Valid as long as this is. \throws SystemError if it cannot be committed
    [[nodiscard]] hid_t of(File const& file, Field const& column);
    /// Closes all, or gives them up unclosed where the file could not be written.
    void close() { committed_.clear(); }
    void release();

  private:
    struct Committed {
        Field column;
        Datatype type;
    };
    std::map<std::string, Committed> committed_;
};

/// Writes `units` (none where the column has none), `description`, the same as `long_name`, and where values have names
/// `flag_values` and `flag_meanings`, and its notes.
void describe(Dataset const& dataset, Field const& column);

/// Makes a dataset an axis, its own first of all; one that is an axis stays it.
void make_axis(Dataset const& dataset, std::string const& name);
/// Lays a column along an axis.
void attach_axis(Dataset const& dataset, Dataset const& axis, std::string const& name);

}  // namespace overturn::store
