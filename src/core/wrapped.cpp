#include "core/wrapped.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/text_width.hpp"

namespace overturn {

std::string wrapped(std::string_view text, std::size_t indent, std::size_t width, std::string begun) {
    auto lines = std::move(begun);
    std::size_t column = text_width(lines);
    bool fresh = true;  // no word stands in the line yet
    while (!text.empty()) {
        auto end = std::min(text.find(' '), text.size());
        if (text.substr(end).starts_with(" %")) {
            end = std::min(text.find(' ', end + 1), text.size());
        }
        auto const word = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        if (!fresh && column + 1 + text_width(word) > width) {
            lines += '\n' + std::string(indent, ' ');
            column = indent;
        } else if (!fresh) {
            lines += ' ';
            ++column;
        }
        lines += word;
        column += text_width(word);
        fresh = false;
    }
    return lines + '\n';
}

namespace {

// Of a line that is too long.
std::string narrowed_line(std::string_view line) {
    constexpr std::size_t more = 4;
    constexpr std::string_view command_mark = ": overturn ";
    auto const indent = std::min(line.find_first_not_of(' '), line.size());
    auto const before = line.rfind(command_mark);
    auto const text = line.substr(indent, before == std::string_view::npos ? before : before + 1 - indent);
    auto lines = wrapped(text, indent + more, line_width, std::string(indent, ' '));
    if (before == std::string_view::npos) {
        return lines;
    }
    auto const command = line.substr(before + 2);
    lines.pop_back();
    auto const last = std::string_view(lines).substr(lines.rfind('\n') + 1);
    bool const fits = text_width(last) + 1 + text_width(command) <= line_width;
    return lines + (fits ? " " : "\n" + std::string(indent + more, ' ')) + std::string(command) + '\n';
}

}  // namespace

std::string narrowed(std::string_view text) {
    std::string lines;
    while (!text.empty()) {
        auto const end = std::min(text.find('\n'), text.size());
        auto const line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        lines += text_width(line) <= line_width ? std::string(line) + '\n' : narrowed_line(line);
    }
    return lines;
}

std::string labelled(std::string_view label, std::string_view text, std::size_t columns) {
    return wrapped(text, columns, line_width, fmt::format("{:<{}}", label, columns));
}

}  // namespace overturn
