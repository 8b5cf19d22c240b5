#include "core/wrapped.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace overturn {

std::string wrapped(std::string_view text, std::size_t indent, std::size_t width, std::string begun) {
    auto lines = std::move(begun);
    std::size_t column = lines.size();
    bool fresh = true;  // no word stands in the line yet
    while (!text.empty()) {
        auto end = std::min(text.find(' '), text.size());
        if (text.substr(end).starts_with(" %")) {
            end = std::min(text.find(' ', end + 1), text.size());
        }
        auto const word = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        if (!fresh && column + 1 + word.size() > width) {
            lines += '\n' + std::string(indent, ' ');
            column = indent;
        } else if (!fresh) {
            lines += ' ';
            ++column;
        }
        lines += word;
        column += word.size();
        fresh = false;
    }
    return lines + '\n';
}

std::string narrowed(std::string_view text) {
    constexpr std::size_t more = 4;
    std::string lines;
    while (!text.empty()) {
        auto const end = std::min(text.find('\n'), text.size());
        auto const line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        auto const indent = std::min(line.find_first_not_of(' '), line.size());
        lines += line.size() <= line_width
                     ? std::string(line) + '\n'
                     : wrapped(line.substr(indent), indent + more, line_width, std::string(indent, ' '));
    }
    return lines;
}

std::string labelled(std::string_view label, std::string_view text) {
    return wrapped(text, label_width, line_width, fmt::format("{:<{}}", label, label_width));
}

}  // namespace overturn
