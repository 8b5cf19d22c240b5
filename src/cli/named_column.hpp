/// Names of columns of tables that people write: "pga [g]", "sa(1 s) [gal]", "IM".
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "motion/cell_rows.hpp"

namespace overturn::cli {

struct NamedColumn {
    std::string name;       ///< in lower case, without the unit: "pga", "sa(1 s)", "im"
    std::string_view bare;  ///< of `cell`'s name up to any bracket or unit, in the case it has
    std::string_view unit;  ///< text in its brackets, or behind an underscore ("Sa_g"); empty: none

    /// Is it one of the usual names of an intensity: "IM", "amplitude", "Sa(T1)", "collapse_capacity"?
    [[nodiscard]] bool is_intensity() const;
    /// "pga", "pgv", "sa(1 s)": a measure that the name states; empty: none ("im", "amplitude").
    [[nodiscard]] std::string measure() const;
};
/// \param cell outlives the result; "Sa(1.0s)" is called sa(1 s), as levels are
[[nodiscard]] NamedColumn named_column(std::string_view cell);

/// In lower case without what says nothing: "No. of Records", "num_records" and "n_records" are all "record".
[[nodiscard]] std::string counted_things(std::string_view name);

/// Unit of a table's intensities by its text.
struct IntensityText {
    std::string unit;                 ///< by the column's name or the text; empty: neither states one
    std::vector<std::string> unread;  ///< lines that are not understood
};
/// Unit by all rows that were handed out. \param column of the header \param line of the header
/// \throws InputError at a line that contradicts the name
/// \throws InputError at a line that contradicts the name
[[nodiscard]] IntensityText intensity_text(CellRows const& rows, std::string const& file, std::string_view column);

}  // namespace overturn::cli
