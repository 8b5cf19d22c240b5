#include "cli/column_list.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "store/format_versions.hpp"

namespace overturn::cli {
namespace {

// "limits/touches/stripes/type-a" -> "limits/<limit>/stripes/<body>"
std::string generic(std::string const& group, std::vector<std::string> const& bodies,
                    std::vector<std::string> const& limits) {
    std::string text;
    std::string before;
    for (std::size_t begin = 0; begin <= group.size();) {
        auto const end = std::min(group.find('/', begin), group.size());
        auto const part = group.substr(begin, end - begin);
        bool const named = !before.empty() && before != "trials";
        bool const body = named && std::ranges::find(bodies, part) != bodies.end();
        bool const limit = before == "limits" && std::ranges::find(limits, part) != limits.end();
        text += (text.empty() ? "" : "/") + (limit ? "<limit>" : body ? "<body>" : part);
        before = part;
        begin = end + 1;
    }
    return text;
}

std::string unit_of(store::ColumnMeaning const& column) {
    return column.units.empty() || column.units == "1" ? "" : "[" + column.units + "]";
}

}  // namespace

void add_groups(store::ResultsReader const& file, std::vector<std::string> const& unknown,
                std::vector<ListedGroup>& groups) {
    auto const bodies = file.members("bodies");
    auto const limits = file.members("limits");
    for (auto const& column : file.columns()) {
        auto const slash = column.path.rfind('/');
        auto const name = slash == std::string::npos ? "" : generic(column.path.substr(0, slash), bodies, limits);
        auto group = std::ranges::find(groups, name, &ListedGroup::name);
        if (group == groups.end()) {
            group = groups.insert(groups.end(), {name, {}});
        }
        auto own = column;
        own.path = column.path.substr(slash + 1);
        if (std::ranges::find(unknown, column.path) != unknown.end()) {
            own.description = "(unknown to this program) " + own.description;
        }
        if (std::ranges::find(group->columns, own.path, &store::ColumnMeaning::path) == group->columns.end()) {
            group->columns.push_back(std::move(own));
        }
    }
    for (auto& group : groups) {
        std::ranges::sort(group.columns, {}, &store::ColumnMeaning::path);
    }
    std::ranges::sort(groups, {}, &ListedGroup::name);
}

std::string columns_text(std::vector<ListedGroup> const& groups) {
    std::string text;
    for (auto const& group : groups) {
        text += fmt::format("/{}\n", group.name);
        std::size_t widest = 0;
        for (auto const& column : group.columns) {
            widest = std::max(widest, column.path.size());
        }
        for (auto const& column : group.columns) {
            auto const unit = unit_of(column);
            text += fmt::format("  {:<{}}  {}{}{}\n", column.path, widest, unit, unit.empty() ? "" : " ",
                                column.description);
        }
    }
    return text;
}

std::string columns_markdown(std::vector<ListedGroup> const& groups) {
    std::string text =
        "# Columns of a results file\n\nOf a campaign that has all of it; `overturn list columns FILE.h5` tells those "
        "of "
        "any file. No unit: a number without one. Since: the format whose files first held it; none: format 3 already, "
        "the "
        "oldest that is read.\n\n";
    for (auto const& group : groups) {
        text += fmt::format("## /{}\n\n| column | unit | since | meaning |\n|---|---|---|---|\n", group.name);
        for (auto const& column : group.columns) {
            std::string meaning = column.description;
            for (std::size_t bar = 0; (bar = meaning.find('|', bar)) != std::string::npos; bar += 2) {
                meaning.insert(bar, "\\");
            }
            auto const since = store::first_format_of(group.name, column.path);
            text += fmt::format("| `{}` | {} | {} | {} |\n", column.path, column.units == "1" ? "" : column.units,
                                since == store::oldest_format_read ? "" : std::to_string(since), meaning);
        }
        text += "\n";
    }
    text.pop_back();
    return text;
}

}  // namespace overturn::cli
