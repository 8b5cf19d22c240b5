#include "cli/named_column.hpp"

#include <algorithm>

#include "core/units.hpp"
#include "motion/text_lines.hpp"

namespace overturn::cli {

std::string NamedColumn::measure() const {
    auto const plain = lowered(bare);
    return plain == "pga" || plain == "pgv" || plain == "sa" ? name : std::string();
}

NamedColumn named_column(std::string_view cell) {
    // The brackets of a period, "sa(1 s)", belong to the name.
    auto const first = std::min(cell.find_first_of("[("), cell.size());
    bool const period = lowered(cell).starts_with("sa(") && cell.find(')') != std::string_view::npos;
    auto const open = cell.find_first_of("[(", period ? cell.find(')') : 0);
    NamedColumn column{lowered(trimmed(cell.substr(0, open))), trimmed(cell.substr(0, first)), {}};
    if (open != std::string_view::npos) {
        auto const close = cell.find_first_of(")]", open);
        column.unit = trimmed(cell.substr(open + 1, close == std::string_view::npos ? close : close - open - 1));
    }
    return column;
}

}  // namespace overturn::cli
