#include "store/known_columns.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace overturn::store {
namespace {

constexpr std::string_view page =
#include "store/columns_page.inc"
    ;

// Of earlier files: read, and no longer written.
constexpr std::array<std::pair<std::string_view, std::string_view>, 4> former{{{"fragility/<body>", "measure_units"},
                                                                               {"limit_states", "said"},
                                                                               {"stripes/<body>", "rung"},
                                                                               {"stripes/<body>", "rung_trials"}}};

bool is_former(std::string_view group, std::string_view column) {
    return std::ranges::find(former, std::pair(group, column)) != former.end();
}

// "subset-0" -> "subset-<n>"
std::string without_number(std::string const& part) {
    for (std::string_view const numbered : {"subset-", "mixture-", "stage-"}) {
        if (part.starts_with(numbered)) {
            return std::string(numbered) + "<n>";
        }
    }
    return part;
}

}  // namespace

std::string page_name_of(std::string_view group, std::span<std::string const> bodies) {
    std::vector<std::string> parts;
    for (std::size_t begin = 0; begin <= group.size();) {
        auto const end = std::min(group.find('/', begin), group.size());
        std::string part(group.substr(begin, end - begin));
        auto const before = parts.empty() ? std::string() : parts.back();
        bool const of_body = before == "<body>";
        if (before == "limits" || before == "pairs" || before == "together") {
            part = "<limit>";
        } else if (of_body && parts.front() == "quantiles") {
            part = "<quantity>";
        } else if (of_body && parts.front() == "criterion_by_level") {
            part = "<criterion>";
        } else if (!before.empty() && before != "trials" && std::ranges::find(bodies, part) != bodies.end()) {
            part = "<body>";
        }
        parts.push_back(without_number(part));
        begin = end + 1;
    }
    return fmt::format("{}", fmt::join(parts, "/"));
}

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
