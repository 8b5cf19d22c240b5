#include "store/known_columns.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

namespace overturn::store {
namespace {

constexpr std::string_view page =
#include "store/columns_page.inc"
    ;

// Of files of earlier formats: read, and no longer written.
constexpr std::array<std::pair<std::string_view, std::string_view>, 3> former{
    {{"fragility/<body>", "measure_units"}, {"stripes/<body>", "rung"}, {"stripes/<body>", "rung_trials"}}};

bool is_former(std::string_view group, std::string_view column) {
    return std::ranges::find(former, std::pair(group, column)) != former.end();
}

}  // namespace

bool is_known_column(std::string_view group, std::string_view column) {
    if (is_former(group, column)) {
        return true;
    }
    auto const head = fmt::format("\n## /{}\n", group);
    auto const begin = page.find(head);
    if (begin == std::string_view::npos) {
        return false;
    }
    auto const section = page.substr(begin + head.size());
    auto const end = section.find("\n## ");
    return section.substr(0, end).find(fmt::format("\n| `{}` |", column)) != std::string_view::npos;
}

}  // namespace overturn::store
