#include "cli/csv_cells.hpp"

#include <algorithm>

#include "core/units.hpp"

namespace overturn::cli {
namespace {

std::string_view without_comment(std::string_view line) { return line.substr(0, line.find('#')); }

}  // namespace

std::vector<CsvCell> cells_of(std::string_view line, char separator) {
    line = without_comment(line);
    std::vector<CsvCell> cells;
    for (std::size_t begin = 0; begin <= line.size();) {
        auto const end = std::min(line.find(separator, begin), line.size());
        auto text = trimmed(line.substr(begin, end - begin));
        if (text.size() >= 2 && text.front() == '"' && text.back() == '"') {
            text = trimmed(text.substr(1, text.size() - 2));
        }
        auto const at = text.empty() ? begin : static_cast<std::size_t>(text.data() - line.data());
        cells.push_back({text, static_cast<int>(at) + 1});
        begin = end + 1;
    }
    return cells;
}

char separator_of(std::string_view header) {
    header = without_comment(header);
    auto const first = header.find_first_of(",;\t");
    return first == std::string_view::npos ? ',' : header[first];
}

bool is_blank(std::vector<CsvCell> const& cells) { return cells.size() == 1 && cells.front().text.empty(); }

}  // namespace overturn::cli
