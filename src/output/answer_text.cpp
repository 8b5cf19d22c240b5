#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "campaign/cautions.hpp"
#include "campaign/limit_state.hpp"
#include "core/text_width.hpp"
#include "core/wrapped.hpp"
#include "output/answer.hpp"

namespace overturn::output {
namespace {

std::string trimmed_end(std::string text) {
    text.erase(text.find_last_not_of(' ') + 1);
    return text + "\n";
}

// Both ends stay: names that number things differ at the end.
std::string shortened(std::string const& name, std::size_t most) {
    if (text_width(name) <= most) {
        return name;
    }
    auto const tail = (most - 2) / 2;
    return fmt::format("{}..{}", text_head(name, most - 2 - tail), text_tail(name, tail));
}

// Columns as wide as they need, and wider where a line has room; where it has not, names are shortened.
struct Widths {
    static constexpr std::size_t usual_cell = 22, shortest_row = 12, most_of_body = 18, names = 2;
    std::size_t body = 4, row = 0;
    std::vector<std::size_t> cells;  // of the levels beside each other

    Widths(AnswerSheet const& sheet, std::size_t across) : cells(across) {
        std::size_t all_rows = 0;
        std::size_t least = 0;
        auto const measure = [&](std::vector<std::string> const& line) {
            body = std::clamp(text_width(line[0]), body, most_of_body);
            all_rows = std::max(all_rows, text_width(line[1]));
            if (!is_of_all_levels(line, sheet)) {
                row = std::max(row, text_width(line[1]));
                least = std::max(least, std::min(text_width(line[1]), shortest_row + words_of(line[1]).size()));
                for (std::size_t p = names; p < line.size(); ++p) {
                    auto& cell = cells[(p - names) % across];
                    cell = std::max(cell, text_width(line[p]));
                }
            }
        };
        measure(sheet.head);
        std::ranges::for_each(sheet.rows, measure);
        row = all_rows + widest(0) <= line_width - body - 1 ? all_rows : row;
        auto const left = std::max(line_width - body - 1, widest(0)) - widest(0);
        row = std::max(least, std::min(row, left));
        auto wide = usual_cell;
        while (wide > 0 && !fits(wide)) {
            --wide;
        }
        for (auto& cell : cells) {
            cell = std::max(cell, wide);
        }
    }
    // One cell for all levels.
    static bool is_of_all_levels(std::vector<std::string> const& line, AnswerSheet const& sheet) {
        return line.size() == names + 1 && sheet.head.size() > line.size();
    }
    [[nodiscard]] bool fits(std::size_t wide = 0) const { return body + 1 + row + widest(wide) <= line_width; }
    // Of all levels beside each other, each at least so wide, with the blanks before them.
    [[nodiscard]] std::size_t widest(std::size_t wide) const {
        std::size_t sum = 0;
        for (auto const cell : cells) {
            sum += 1 + std::max(cell, wide);
        }
        return sum;
    }
    // " without overturning)", which is never shortened.
    static std::string_view words_of(std::string_view name) {
        auto const at = name.rfind(without_overturning);
        return at != std::string_view::npos && name.ends_with(')') ? name.substr(at) : std::string_view();
    }
    // "P(hits n..hbour)": the name inside is shortened.
    [[nodiscard]] std::string shortened_row(std::string const& name) const {
        if (!name.starts_with("P(")) {
            return shortened(name, row);
        }
        auto const end = words_of(name).empty() ? std::string(")") : std::string(words_of(name));
        return "P(" + shortened(name.substr(2, name.size() - 2 - end.size()), row - 2 - end.size()) + end;
    }
    /// Of a row: one for each level; or one for all, which begins further right where the row's name is long.
    enum class Cells { of_levels, one };
    /// \param first, last of the columns behind the names
    [[nodiscard]] std::string line(std::vector<std::string> const& parts, std::size_t first, std::size_t last,
                                   Cells kind = Cells::of_levels) const {
        auto const& name = parts[1];
        bool const whole = text_width(name) <= row
                           || (kind == Cells::one && body + 2 + text_width(name) + text_width(parts[2]) <= line_width);
        auto text =
            fmt::format("{:<{}} {:<{}}", shortened(parts[0], body), body, whole ? name : shortened_row(name), row);
        for (std::size_t p = first; p < std::min(last, parts.size()); ++p) {
            text += fmt::format(" {:<{}}", parts[p], kind == Cells::one ? 0 : cells[(p - first) % cells.size()]);
        }
        return trimmed_end(text);
    }
};

std::string cautions_text(Answered const& of) {
    std::string text;
    for (auto const& caution : cautions_of(of.spec)) {
        text += wrapped("caution: " + caution + '.', 4);
    }
    return text;
}

// With up to three levels beside each other, further ones below.
struct Shown {
    std::size_t levels;
    std::size_t across;
    std::size_t rows;  // at most

    [[nodiscard]] std::size_t parts() const { return (levels + across - 1) / across; }
};

// Title, levels, rows, and a note of what was left out.
std::string table_text(std::string const& title, AnswerSheet const& sheet, std::size_t across) {
    constexpr auto names = Widths::names;
    auto text = title.empty() ? std::string() : shortened(title, line_width) + "\n";
    text += wrapped(sheet.title);
    Widths const widths(sheet, across);
    for (std::size_t first = names; first < sheet.head.size(); first += across) {
        text += widths.line(sheet.head, first, first + across);
        for (auto const& row : sheet.rows) {
            bool const of_all_levels = Widths::is_of_all_levels(row, sheet);
            if (!of_all_levels || first + across >= sheet.head.size()) {
                text += of_all_levels ? widths.line(row, names, names + 1, Widths::Cells::one)
                                      : widths.line(row, first, first + across);
            }
        }
    }
    return text + (sheet.left_out.empty() ? std::string() : wrapped(sheet.left_out));
}

}  // namespace

std::string answer_text(Answered const& of) {
    constexpr std::size_t most_across = 3;
    constexpr std::ptrdiff_t most_lines = 15;
    auto const levels = answer_levels(of.spec.levels).size();
    Shown shown{levels, std::clamp<std::size_t>(levels, 1, most_across), most_lines - 2};
    auto sheet = answer_sheet(of, shown.rows, shown.parts());
    if (sheet.rows.empty()) {
        return cautions_text(of);
    }
    while (shown.across > 1 && !Widths(sheet, shown.across).fits()) {
        --shown.across;
        sheet = answer_sheet(of, shown.rows, shown.parts());
    }
    auto text = table_text(of.spec.title, sheet, shown.across);
    while (shown.rows > 1 && std::ranges::count(text, '\n') > most_lines) {
        --shown.rows;
        sheet = answer_sheet(of, shown.rows, shown.parts());
        text = table_text(of.spec.title, sheet, shown.across);
    }
    return text + cautions_text(of) + wrapped(sheet.dependence);
}

}  // namespace overturn::output
