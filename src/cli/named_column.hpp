/// Names of columns of tables that people write: "pga [g]", "sa(1 s) [gal]", "IM".
#pragma once

#include <string>
#include <string_view>

namespace overturn::cli {

struct NamedColumn {
    std::string name;       ///< in lower case, without the unit: "pga", "sa(1 s)", "im"
    std::string_view bare;  ///< of `cell`'s name up to any bracket, in the case it has
    std::string_view unit;  ///< what stands in its brackets; empty: none

    /// "pga", "pgv", "sa(1 s)": a measure that the name states; empty: none ("im", "amplitude").
    [[nodiscard]] std::string measure() const;
};
/// \param cell outlives the result
[[nodiscard]] NamedColumn named_column(std::string_view cell);

}  // namespace overturn::cli
