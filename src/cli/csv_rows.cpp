#include "cli/csv_rows.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/units.hpp"

namespace overturn::cli {
namespace {

std::vector<CsvCell> cells_of(std::string_view line, char separator) {
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
    auto const first = header.find_first_of(",;\t");
    return first == std::string_view::npos ? ',' : header[first];
}

}  // namespace

CsvRows::CsvRows(std::string_view text, std::string const& file, std::string_view begin_with)
    : lines_(text), file_(file) {
    auto header = next_cells();
    if (!header) {
        fail(fmt::format("empty (no header). {}", begin_with));
    }
    header_ = *std::move(header);
}

std::optional<std::vector<CsvCell>> CsvRows::next_cells() {
    while (auto line = lines_.next()) {
        auto const content = line->substr(0, line->find('#'));
        auto const separator = separator_.value_or(separator_of(content));
        auto cells = cells_of(content, separator);
        if (cells.size() > 1 || !cells.front().text.empty()) {
            separator_ = separator;
            return cells;
        }
    }
    return std::nullopt;
}

std::optional<std::vector<CsvCell>> CsvRows::next() {
    auto cells = next_cells();
    if (cells && cells->size() != header_.size()) {
        fail(cells->back(),
             fmt::format("{} columns (the header has {}). Complete or shorten the row", cells->size(), header_.size()));
    }
    return cells;
}

void CsvRows::fail(CsvCell const& cell, std::string const& message) const {
    throw InputError({file_, lines_.number(), cell.column}, message);
}

void CsvRows::fail(std::string const& message) const { throw InputError({file_, lines_.number(), 0}, message); }

}  // namespace overturn::cli
