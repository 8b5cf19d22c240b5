#include "output/detail/columns_text.hpp"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/parts_of.hpp"
#include "core/text_width.hpp"
#include "core/wrapped.hpp"

namespace overturn::output {
namespace {

std::vector<std::string> heading_lines(std::string const& head) {
    std::vector<std::string> lines;
    for (auto const line : overturn::parts_of(head, '\n')) {
        lines.emplace_back(line);
    }
    return lines;
}

std::size_t column_width(TextColumn const& column) {
    std::size_t width = 0;
    for (auto const& line : heading_lines(column.head)) {
        width = std::max(width, text_width(line));
    }
    for (auto const& cell : column.cells) {
        width = std::max(width, text_width(cell));
    }
    return width;
}

std::size_t table_width(TextGroup const& columns, std::size_t gap) {
    std::size_t width = 0;
    for (auto const& column : columns) {
        width += column_width(column) + (width == 0 ? 0 : gap);
    }
    return width;
}

std::string side_by_side(TextGroup const& columns, std::size_t indent, std::size_t gap) {
    std::size_t high = 1;
    for (auto const& column : columns) {
        high = std::max(high, heading_lines(column.head).size());
    }
    std::string text;
    auto const add = [&](auto const& cell_of) {
        std::string line(indent, ' ');
        for (auto const& column : columns) {
            auto const width = column_width(column);
            std::string const cell = cell_of(column);
            line += std::string(&column == &columns.front() ? 0 : gap, ' ');
            line += column.side == TextColumn::Side::right ? fmt::format("{:>{}}", cell, width)
                                                           : fmt::format("{:<{}}", cell, width);
        }
        text += line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
    };
    for (std::size_t l = 0; l < high; ++l) {
        add([&](TextColumn const& column) {
            auto const lines = heading_lines(column.head);
            auto const above = high - lines.size();
            return l < above ? std::string() : lines[l - above];
        });
    }
    for (std::size_t r = 0; r < columns.front().cells.size(); ++r) {
        add([&](TextColumn const& column) { return column.cells[r]; });
    }
    return text;
}

}  // namespace

void append_row(TextGroup& columns, std::span<std::string const> cells, std::size_t first) {
    OVERTURN_EXPECT(first + cells.size() <= columns.size());
    for (std::size_t c = 0; c < cells.size(); ++c) {
        columns[first + c].cells.push_back(cells[c]);
    }
}

std::string columns_text(std::vector<TextGroup> const& groups, std::size_t indent) {
    constexpr std::size_t wide = 2;
    OVERTURN_EXPECT(!groups.empty() && !groups.front().empty());
    auto const fits = [&](TextGroup const& columns, std::size_t gap) {
        return indent + table_width(columns, gap) <= line_width;
    };
    TextGroup all;
    for (auto const& group : groups) {
        all.insert(all.end(), group.begin(), group.end());
    }
    for (auto const gap : {wide, wide - 1}) {
        if (fits(all, gap)) {
            return side_by_side(all, indent, gap);
        }
    }
    std::string text;
    auto const gap_of = [&](TextGroup const& columns) { return fits(columns, wide) ? wide : wide - 1; };
    auto part = groups.front();
    for (std::size_t g = 1; g < groups.size(); ++g) {
        auto longer = part;
        longer.insert(longer.end(), groups[g].begin(), groups[g].end());
        if (!fits(longer, wide)) {
            text += side_by_side(part, indent, gap_of(part));
            longer = {groups.front().front()};
            longer.insert(longer.end(), groups[g].begin(), groups[g].end());
        }
        part = std::move(longer);
    }
    return text + side_by_side(part, indent, gap_of(part));
}

}  // namespace overturn::output
