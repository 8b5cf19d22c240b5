/// A stored column out of rows in memory.
#pragma once

#include <vector>

namespace overturn {

/// `get(row)` of each row, as stored.
template <class Value, class Rows, class Get>
[[nodiscard]] std::vector<Value> column_values(Rows const& rows, Get get) {
    std::vector<Value> values;
    values.reserve(rows.size());
    for (auto const& row : rows) {
        values.push_back(static_cast<Value>(get(row)));
    }
    return values;
}

}  // namespace overturn
