/// Rows of numbers that are independent of each other, made by one process or by many: the answer is the same.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace overturn {

/// Fills the row of one item.
using RowWork = std::function<void(std::int64_t item, std::span<double> row)>;

/// The rows of items 0 to `items` - 1, one behind the other, the same on every process. Where it is work of many,
/// all of them must ask for the same rows in the same order; each makes the same items of all rows that it is asked
/// for.
using ShareRows = std::function<std::vector<double>(std::int64_t items, std::size_t row_length, RowWork const& work)>;

/// ShareRows of this process alone.
[[nodiscard]] std::vector<double> rows_alone(std::int64_t items, std::size_t row_length, RowWork const& work);

}  // namespace overturn
