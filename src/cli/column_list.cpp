#include "cli/column_list.hpp"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "core/text_width.hpp"
#include "core/wrapped.hpp"
#include "store/format_versions.hpp"
#include "store/known_columns.hpp"

namespace overturn::cli {
namespace {

// A column as its group's list has it; files of inputs are numbered, and say their names.
store::ColumnMeaning listed(store::ColumnMeaning column, std::string_view group) {
    column.path.erase(0, column.path.rfind('/') + 1);
    if (group == "inputs") {
        column.path = "<n>";
        column.description = "text of an input file; its attribute description is the file's name";
    }
    return column;
}

std::string unit_of(store::ColumnMeaning const& column) {
    return column.units.empty() || column.units == "1" ? "" : "[" + column.units + "]";
}

std::string text_of(std::vector<ListedGroup> const& groups, std::string_view before) {
    std::string text;
    for (auto const& group : groups) {
        text += fmt::format("{}{}\n", before, group.name);
        std::size_t widest = 0;
        for (auto const& column : group.columns) {
            widest = std::max(widest, text_width(column.path));
        }
        for (auto const& column : group.columns) {
            auto const unit = unit_of(column);
            bool const known = std::ranges::find(group.unknown, column.path) == group.unknown.end();
            text += labelled("  " + column.path,
                             fmt::format("{}{}{}{}", unit, unit.empty() ? "" : " ",
                                         known ? "" : "(unknown to this program) ", column.description),
                             widest + 4);
        }
    }
    return text;
}

// A bar would end the cell.
std::string cell_of(std::string meaning) {
    for (std::size_t bar = 0; (bar = meaning.find('|', bar)) != std::string::npos; bar += 2) {
        meaning.insert(bar, "\\");
    }
    return meaning;
}

}  // namespace

void add_groups(store::ResultsReader const& file, std::vector<std::string> const& unknown,
                std::vector<ListedGroup>& groups) {
    auto const bodies = file.members("bodies");
    for (auto const& column : file.columns()) {
        auto const slash = column.path.rfind('/');
        auto const name = slash == std::string::npos ? "" : store::page_name_of(column.path.substr(0, slash), bodies);
        auto group = std::ranges::find(groups, name, &ListedGroup::name);
        if (group == groups.end()) {
            group = groups.insert(groups.end(), {name, {}, {}});
        }
        auto own = listed(column, name);
        if (std::ranges::find(unknown, column.path) != unknown.end()) {
            group->unknown.push_back(own.path);
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

void add_groups(std::vector<output::Table> const& tables, std::vector<ListedGroup>& groups) {
    for (auto const& table : tables) {
        if (std::ranges::find(groups, table.name, &ListedGroup::name) != groups.end()) {
            continue;
        }
        auto& group = *groups.insert(groups.end(), {table.name, {}, {}});
        for (auto const& column : table.columns) {
            group.columns.push_back({column.key(), column.unit.symbol, column.meaning});
        }
        std::ranges::sort(group.columns, {}, &store::ColumnMeaning::path);
    }
    std::ranges::sort(groups, {}, &ListedGroup::name);
}

std::string columns_text(ListedColumns const& of) { return text_of(of.file, "/") + text_of(of.json, "fit --json: "); }

std::string columns_markdown(ListedColumns const& of) {
    std::string text =
        "# Columns of a results file\n\nAll columns that a campaign can give. `overturn list columns FILE.h5` lists "
        "the "
        "columns of one file. An empty unit means a number without unit. Since: the first format with the column; "
        "empty: format 3, the oldest that can be read.\n\n";
    for (auto const& group : of.file) {
        text += fmt::format("## /{}\n\n| column | unit | since | meaning |\n|---|---|---|---|\n", group.name);
        for (auto const& column : group.columns) {
            auto const since = store::first_format_of(group.name, column.path);
            text += fmt::format("| `{}` | {} | {} | {} |\n", column.path, column.units == "1" ? "" : column.units,
                                since == store::oldest_format_read ? "" : std::to_string(since),
                                cell_of(column.description));
        }
        text += "\n";
    }
    text += "## Only in JSON\n\nTables of `fit --json` that are in no file. Names end with the unit.\n\n";
    for (auto const& group : of.json) {
        text += fmt::format("### {}\n\n| column | unit | meaning |\n|---|---|---|\n", group.name);
        for (auto const& column : group.columns) {
            text += fmt::format("| `{}` | {} | {} |\n", column.path, column.units == "1" ? "" : column.units,
                                cell_of(column.description));
        }
        text += "\n";
    }
    text.pop_back();
    return text;
}

}  // namespace overturn::cli
