#include "core/text_width.hpp"

#include <fmt/format.h>

namespace overturn {
namespace {

// Where a character begins in UTF-8: all bytes but 10xxxxxx.
bool begins(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U; }

}  // namespace

std::size_t text_width(std::string_view text) {
    // Filled to as many columns as the text has bytes, it gains a blank for each byte beyond its columns.
    return 2 * text.size() - fmt::formatted_size("{:<{}}", text, text.size());
}

std::string_view text_head(std::string_view text, std::size_t width) {
    std::size_t end = 0, columns = 0;
    while (end < text.size()) {
        auto next = end + 1;
        while (next < text.size() && !begins(text[next])) {
            ++next;
        }
        columns += text_width(text.substr(end, next - end));
        if (columns > width) {
            break;
        }
        end = next;
    }
    return text.substr(0, end);
}

std::string_view text_tail(std::string_view text, std::size_t width) {
    std::size_t begin = text.size(), columns = 0;
    while (begin > 0) {
        auto before = begin - 1;
        while (before > 0 && !begins(text[before])) {
            --before;
        }
        columns += text_width(text.substr(before, begin - before));
        if (columns > width) {
            break;
        }
        begin = before;
    }
    return text.substr(begin);
}

}  // namespace overturn
