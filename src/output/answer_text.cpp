#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

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

// Columns of names as wide as they need, within what three levels leave of a line.
struct Widths {
    static constexpr std::size_t cell = 22, names = 31, most_of_body = 18;
    std::size_t body = 4, row = 0;

    explicit Widths(AnswerSheet const& sheet) {
        body = std::clamp(text_width(sheet.head[0]), body, most_of_body);
        for (auto const& line : sheet.rows) {
            body = std::clamp(text_width(line[0]), body, most_of_body);
        }
        for (auto const& line : sheet.rows) {
            row = std::max(row, std::min(text_width(line[1]), names - 1 - body + words_of(line[1]).size()));
        }
    }
    [[nodiscard]] std::size_t levels_in_a_line() const {
        return std::max<std::size_t>(1, (line_width - body - 1 - row) / (1 + cell));
    }
    // " without overturning)", which is never shortened.
    static std::string_view words_of(std::string_view name) {
        auto const at = name.rfind(without_overturning);
        return at != std::string_view::npos && name.ends_with(')') ? name.substr(at) : std::string_view();
    }
    /// Of a row: one for each level; or one for all, which begins further right where the row's name is long.
    enum class Cells { of_levels, one };
    /// \param first, last of the columns behind the names
    [[nodiscard]] std::string line(std::vector<std::string> const& parts, std::size_t first, std::size_t last,
                                   Cells cells = Cells::of_levels) const {
        // "P(hits n..hbour)": the name inside is shortened.
        auto const& name = parts[1];
        bool const fits = text_width(name) <= row
                          || (cells == Cells::one && body + 2 + text_width(name) + text_width(parts[2]) <= line_width);
        auto const end = words_of(name).empty() ? std::string(")") : std::string(words_of(name));
        auto const inside = row - 2 - end.size();
        auto const what = fits ? name
                          : name.starts_with("P(")
                              ? "P(" + shortened(name.substr(2, name.size() - 2 - end.size()), inside) + end
                              : shortened(name, row);
        auto text = fmt::format("{:<{}} {:<{}}", shortened(parts[0], body), body, what, row);
        for (std::size_t p = first; p < std::min(last, parts.size()); ++p) {
            text += fmt::format(" {:<{}}", parts[p], cell);
        }
        return trimmed_end(text);
    }
};

std::string cautions_text(Answered const& of) {
    std::string text;
    for (auto const& caution : cautions_of(of)) {
        text += wrapped("caution: " + caution, 4);
    }
    return text;
}

}  // namespace

std::string answer_text(Answered const& of) {
    // With title, levels and a note of what was left out 15 lines; so many levels beside each other as fit, at most
    // three, further ones below.
    constexpr std::size_t most_lines = 13;
    constexpr std::size_t names = 2;
    auto const sheet_of = [&](std::size_t across) {
        auto const parts = (answer_levels(of.spec.levels).size() + across - 1) / across;
        return answer_sheet(of, most_lines - parts, parts);
    };
    std::size_t across = 3;
    auto sheet = sheet_of(across);
    if (sheet.rows.empty()) {
        return cautions_text(of);
    }
    if (auto const fit = Widths(sheet).levels_in_a_line(); fit < across) {
        across = fit;
        sheet = sheet_of(across);
    }
    auto text = of.spec.title.empty() ? std::string() : shortened(of.spec.title, line_width) + "\n";
    text += wrapped(sheet.title);
    Widths const widths(sheet);
    for (std::size_t first = names; first < sheet.head.size(); first += across) {
        text += widths.line(sheet.head, first, first + across);
        for (auto const& row : sheet.rows) {
            bool const of_all_levels = row.size() == names + 1 && sheet.head.size() > row.size();
            if (!of_all_levels || first + across >= sheet.head.size()) {
                text += of_all_levels ? widths.line(row, names, names + 1, Widths::Cells::one)
                                      : widths.line(row, first, first + across);
            }
        }
    }
    return text + (sheet.left_out.empty() ? std::string() : sheet.left_out + "\n") + cautions_text(of)
           + wrapped(sheet.dependence);
}

}  // namespace overturn::output
