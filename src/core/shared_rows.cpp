#include "core/shared_rows.hpp"

namespace overturn {

std::vector<double> rows_alone(std::int64_t items, std::size_t row_length, RowWork const& work) {
    std::vector<double> rows(items * row_length);
    for (std::int64_t item = 0; item < items; ++item) {
        work(item, std::span(rows).subspan(item * row_length, row_length));
    }
    return rows;
}

}  // namespace overturn
