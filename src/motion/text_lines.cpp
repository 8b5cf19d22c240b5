#include "motion/text_lines.hpp"

#include <algorithm>
#include <array>

#include "core/error.hpp"
#include "core/units.hpp"

namespace overturn {
namespace {

constexpr std::string_view digits = "0123456789";

bool is_sign(char c) { return c == '+' || c == '-'; }
bool is_blank(char c) { return c == ' ' || c == '\t'; }

std::size_t past_digits(std::string_view text, std::size_t at) {
    return std::min(text.find_first_not_of(digits, at), text.size());
}

/// Where a number's text ends and where its exponent's sign or letter stands; all zero if there is no number.
struct NumberExtent {
    std::size_t end = 0;
    std::size_t exponent = 0;
    bool exponent_lost_its_letter = false;
};

NumberExtent number_at_front(std::string_view text) {
    std::size_t at = !text.empty() && is_sign(text[0]) ? 1 : 0;
    auto const whole = at;
    at = past_digits(text, at);
    auto figures = at - whole;
    bool const point = at < text.size() && text[at] == '.';
    if (point) {
        auto const fraction = at + 1;
        at = past_digits(text, fraction);
        figures += at - fraction;
    }
    if (figures == 0) {
        return {};
    }
    auto const mantissa = at;
    if (at < text.size() && std::string_view("eEdD").find(text[at]) != std::string_view::npos) {
        at += at + 1 < text.size() && is_sign(text[at + 1]) ? 2 : 1;
        auto const end = past_digits(text, at);
        return end > at ? NumberExtent{end, mantissa} : NumberExtent{};
    }
    // Fortran drops the letter before three exponent digits; a glued next number would have a point of its own.
    if (point && at < text.size() && is_sign(text[at])) {
        auto const end = past_digits(text, at + 1);
        if (end - at == 4 && (end == text.size() || text[end] != '.')) {
            return {end, mantissa, true};
        }
    }
    return {mantissa, mantissa};
}

}  // namespace

TextLines::TextLines(std::string_view content) : rest_(content.substr(0, content.find('\x1a'))) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (rest_.starts_with(byte_order_mark)) {
        rest_.remove_prefix(byte_order_mark.size());
    }
}

std::optional<std::string_view> TextLines::next() {
    if (rest_.empty()) {
        return std::nullopt;
    }
    ++number_;
    auto const end = rest_.find_first_of("\r\n");
    auto const line = rest_.substr(0, end);
    if (end == std::string_view::npos) {
        rest_ = {};
        return line;
    }
    auto const feed = std::min(rest_.find_first_not_of('\r', end), rest_.size());
    rest_.remove_prefix(feed < rest_.size() && rest_[feed] == '\n' ? feed + 1 : end + 1);
    return line;
}

void append_numbers(std::string_view line, std::string const& file, int line_number, std::vector<double>& values) {
    while (true) {
        line.remove_prefix(std::min(line.find_first_not_of(" \t\f\v"), line.size()));
        if (line.empty()) {
            return;
        }
        auto const extent = number_at_front(line);
        auto const end = extent.end;
        bool const parted = end > 0 && (end == line.size() || is_blank(line[end]) || is_sign(line[end]));
        double value = 0;
        bool read = false;
        if (parted && extent.exponent_lost_its_letter) {
            std::string text(line.substr(0, end));
            read = parse_number(text.insert(extent.exponent, 1, 'e'), value);
        } else if (parted) {
            read = parse_number(line.substr(0, end), value);
        }
        if (!read) {
            throw InputError({file, line_number},
                             fmt::format("{} (not a finite number). Mend the value or fetch the file anew",
                                         in_quotes(line.substr(0, line.find_first_of(" \t", end)))));
        }
        values.push_back(value);
        line.remove_prefix(end);
    }
}

std::optional<FixedFormat> fixed_format_in(std::string_view text) {
    for (auto open = text.find('('); open != std::string_view::npos; open = text.find('(', open + 1)) {
        auto const letter = past_digits(text, open + 1);
        if (letter == text.size() || std::string_view("FEDGIfedgi").find(text[letter]) == std::string_view::npos) {
            continue;
        }
        auto const end = past_digits(text, letter + 1);
        double per_line = 1;
        double width = 0;
        if ((letter == open + 1 || parse_number(text.substr(open + 1, letter - open - 1), per_line))
            && parse_number(text.substr(letter + 1, end - letter - 1), width) && per_line >= 1 && width >= 1) {
            return FixedFormat{static_cast<std::size_t>(per_line), static_cast<std::size_t>(width)};
        }
    }
    return std::nullopt;
}

void append_fixed(TextLines& lines, FixedFormat format, std::size_t count, std::string const& file,
                  std::vector<double>& values) {
    for (std::size_t read = 0; read < count;) {
        auto const line = lines.next();
        if (!line) {
            throw InputError({file, lines.number()}, fmt::format("{} values where the header promises {} (the file is "
                                                                 "cut short). Fetch it anew",
                                                                 read, count));
        }
        bool lost_a_blank = false;  // an earlier number stands too far to the left, so that the last one ends too early
        for (std::size_t field = 0; field < format.per_line && read < count; ++field) {
            auto const at = field * format.width;
            auto const cells = at < line->size() ? line->substr(at, format.width) : std::string_view{};
            auto const text = trimmed(cells);
            double value = 0;
            bool const whole = at + format.width <= line->size() || lost_a_blank;  // Fortran sets numbers to the right
            lost_a_blank = lost_a_blank || (!text.empty() && cells.back() == ' ');
            if (!whole || !parse_number(text, value)) {
                throw InputError({file, lines.number()},
                                 fmt::format("{} as value {} of {} (not a finite number; the file is damaged or cut "
                                             "short). Fetch it anew",
                                             in_quotes(text), read + 1, count));
            }
            values.push_back(value);
            ++read;
        }
    }
}

std::vector<std::string_view> parted_at(std::string_view text, std::string_view separators) {
    std::vector<std::string_view> parts;
    for (std::size_t at = 0; at < text.size();) {
        at = std::min(text.find_first_not_of(separators, at), text.size());
        auto const end = std::min(text.find_first_of(separators, at), text.size());
        if (end > at) {
            parts.push_back(text.substr(at, end - at));
        }
        at = end;
    }
    return parts;
}

std::string lowered(std::string_view text) {
    std::string lower(text);
    for (char& c : lower) {
        c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
    return lower;
}

namespace {

/// The length of the character of UTF-8 that `text` begins with, if a terminal may be given it: none of control, of
/// direction or of no width; else 0.
std::size_t shown_length(std::string_view text) {
    auto const byte = [&](std::size_t i) {
        return i < text.size() ? static_cast<unsigned>(static_cast<unsigned char>(text[i])) : 0U;
    };
    constexpr unsigned continued = 0x80, kind = 0xC0, six_bits = 0x3F;
    unsigned const first = byte(0);
    if (first < continued) {
        return first >= ' ' && first <= '~' ? 1 : 0;
    }
    std::size_t const length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
    unsigned point = first & (0xFFU >> (length + 1));
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & kind) != continued) {
            return 0;
        }
        point = (point << 6U) | (byte(i) & six_bits);
    }
    struct Range {
        unsigned first, last;
    };
    constexpr std::array hidden{Range{0, 0x9F},          Range{0xAD, 0xAD},        Range{0x200B, 0x200F},
                                Range{0x2028, 0x202E},   Range{0x2060, 0x206F},    Range{0xD800, 0xF8FF},
                                Range{0xFE00, 0xFE0F},   Range{0xFEFF, 0xFEFF},    Range{0xFFF0, 0xFFFF},
                                Range{0xE0000, 0xFFFFF}, Range{0x100000, 0xFFFFFF}};
    constexpr std::array least{0U, 0U, 0x80U, 0x800U, 0x10000U};
    bool const plain =
        std::ranges::none_of(hidden, [&](Range range) { return point >= range.first && point <= range.last; });
    return plain && point >= least.at(length) && first < 0xF8 && first >= 0xC2 ? length : 0;
}

}  // namespace

std::string in_quotes(std::string_view text) {
    constexpr std::size_t most = 30;
    std::string shown;
    std::size_t characters = 0;
    for (; !text.empty() && characters < most; ++characters) {
        auto const length = shown_length(text);
        shown += length == 0 ? std::string_view("?") : text.substr(0, length);
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return fmt::format("'{}{}'", shown, text.empty() ? "" : "...");
}

}  // namespace overturn
