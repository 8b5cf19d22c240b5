#include "motion/cell_rows.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/units.hpp"
#include "motion/detail/text_encoding.hpp"

namespace overturn {
namespace {

std::vector<Cell> cells_of(std::string_view line, char separator) {
    std::vector<Cell> cells;
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

/// Parted by blanks; what stands in brackets belongs to the cell before it: "sa(1 s) [g]".
std::vector<Cell> cells_between_blanks(std::string_view line) {
    constexpr std::string_view blanks = " \t";
    std::vector<Cell> cells;
    for (auto begin = line.find_first_not_of(blanks); begin != std::string_view::npos;) {
        int depth = 0;
        auto end = begin;
        for (; end < line.size() && (depth > 0 || blanks.find(line[end]) == std::string_view::npos); ++end) {
            depth += line[end] == '(' || line[end] == '[' ? 1 : line[end] == ')' || line[end] == ']' ? -1 : 0;
        }
        bool const bracket = (line[begin] == '(' || line[begin] == '[') && !cells.empty();
        auto const from = bracket ? static_cast<std::size_t>(cells.back().column - 1) : begin;
        if (bracket) {
            cells.pop_back();
        }
        cells.push_back({line.substr(from, end - from), static_cast<int>(from) + 1});
        begin = line.find_first_not_of(blanks, end);
    }
    return cells;
}

char separator_of(std::string_view header) {
    auto const first = header.find_first_of(",;\t");
    bool const blanks = first == std::string_view::npos && cells_between_blanks(header).size() > 1;
    return blanks ? ' ' : first == std::string_view::npos ? ',' : header[first];
}

/// Cells beyond those of the header, all whole: "0,2,40,1" below three names.
bool may_be_decimal_commas(std::vector<Cell> const& cells, std::size_t wanted, char separator) {
    return separator == ',' && cells.size() > wanted && std::ranges::all_of(cells, [](Cell const& cell) {
               return cell.text.find_first_not_of("0123456789+->") == std::string_view::npos;
           });
}

std::vector<Cell> parted(std::string_view line, char separator) {
    return separator == ' ' ? cells_between_blanks(line) : cells_of(line, separator);
}

std::string_view without_comment(std::string_view line) {
    bool const all = trimmed(line).starts_with('%') || trimmed(line).starts_with('!');
    return line.substr(0, all ? 0 : line.find('#'));
}

/// Of the line of names; 0 for the first one that is no comment.
int header_line_of(std::string_view text) {
    struct Above {
        std::size_t cells;
        char separator;
        int line;
    };
    std::vector<Above> above;
    TextLines lines(text);
    while (auto const line = lines.next()) {
        auto const content = without_comment(*line);
        auto const separator = separator_of(content);
        auto const cells = parted(content, separator);
        if (trimmed(content).empty()) {
            continue;
        }
        if (std::ranges::any_of(cells, is_like_a_number) || above.size() == std::size_t(head_lines_at_most)) {
            bool const prose = above.size() > 1 && parted(content, above.back().separator).size() == above.back().cells
                               && std::ranges::count_if(above, [&](Above const& one) {
                                      return one.cells == above.back().cells && one.separator == above.back().separator;
                                  }) == 1;
            return prose ? above.back().line : 0;
        }
        above.push_back({cells.size(), separator, lines.number()});
    }
    return 0;
}

}  // namespace

bool is_like_a_number(Cell const& cell) {
    std::string text(trimmed(cell.text.substr(cell.text.starts_with('>') ? 1 : 0)));
    std::ranges::replace(text, ',', '.');
    double value = 0;
    return parse_number(text, value);
}

CellRows::CellRows(std::string_view text, std::string const& file, std::string_view begin_with)
    : lines_(text), file_(file) {
    for (int const line = header_line_of(text); lines_.number() + 1 < line;) {
        keep(*lines_.next());
    }
    auto header = next_cells();
    if (!header) {
        fail(fmt::format("empty (no header). {}", begin_with));
    }
    header_ = *std::move(header);
    header_line_ = lines_.number();
}

void CellRows::keep(std::string_view text) {
    if (!trimmed(text).empty() && text_.size() < std::size_t(head_lines_at_most)) {
        text_.push_back({decoded(trimmed(text)), lines_.number()});
    }
}

std::optional<std::vector<Cell>> CellRows::next_cells() {
    while (auto line = lines_.next()) {
        auto const content = without_comment(*line);
        keep(line->substr(content.size()));
        auto const separator = separator_.value_or(separator_of(content));
        auto cells = parted(content, separator);
        if (cells.empty()) {
            continue;
        }
        if (cells.size() > 1 || !cells.front().text.empty()) {
            separator_ = separator;
            return cells;
        }
    }
    return std::nullopt;
}

std::optional<std::vector<Cell>> CellRows::next() {
    auto cells = next_cells();
    if (cells && cells->size() != header_.size()) {
        fail(cells->back(),
             fmt::format("{} columns (the header has {}{}). Complete or shorten the row", cells->size(), header_.size(),
                         may_be_decimal_commas(*cells, header_.size(), separator_.value_or(','))
                             ? "; are there decimal commas?"
                             : ""));
    }
    return cells;
}

std::optional<bool> CellRows::yes_or_no(Cell const& cell) {
    auto const word = lowered(cell.text);
    bool const yes = word == "1" || word == "yes" || word == "true";
    bool const no = word == "0" || word == "no" || word == "false";
    return yes || no ? std::optional(yes) : std::nullopt;
}

std::string_view CellRows::why_no_number(Cell const& cell) {
    return std::ranges::count(cell.text, ',') == 1 ? "a decimal comma, not a decimal point" : "not a number";
}

void CellRows::fail(Cell const& cell, std::string const& message) const {
    throw InputError({file_, lines_.number(), cell.column}, message);
}

void CellRows::fail(std::string const& message) const { throw InputError({file_, lines_.number(), 0}, message); }

}  // namespace overturn
