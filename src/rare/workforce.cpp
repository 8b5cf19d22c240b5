#include "rare/workforce.hpp"

#include <algorithm>

namespace overturn::rare {

std::vector<std::byte> LoneWorker::rows_of(Stage const& stage, Work const& work) {
    std::vector<std::byte> rows(stage.items * stage.row_bytes);
    for (std::int64_t first = 0; first < stage.items; first += stage.block) {
        auto const count = std::min(stage.block, stage.items - first);
        work(first, std::span(rows).subspan(first * stage.row_bytes, count * stage.row_bytes));
    }
    return rows;
}

}  // namespace overturn::rare
