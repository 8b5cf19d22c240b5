#include "motion/detail/text_encoding.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include <iconv.h>

namespace overturn {
namespace {

using Text = std::string_view;

// acceleration, velocity, displacement (two ways), time (four ways), NS, EW (two ways), UD, plumb, level, unit;
// acceleration, velocity, displacement of Korea
constexpr std::array known_words{"\xE5\x8A\xA0\xE9\x80\x9F\xE5\xBA\xA6",
                                 "\xE9\x80\x9F\xE5\xBA\xA6",
                                 "\xE5\xA4\x89\xE4\xBD\x8D",
                                 "\xE4\xBD\x8D\xE7\xA7\xBB",
                                 "\xE6\x99\x82\xE9\x96\x93",
                                 "\xE6\x97\xB6\xE9\x97\xB4",
                                 "\xE6\x99\x82\xE5\x88\xBB",
                                 "\xE6\x97\xB6\xE5\x88\xBB",
                                 "\xE5\x8D\x97\xE5\x8C\x97",
                                 "\xE6\x9D\xB1\xE8\xA5\xBF",
                                 "\xE4\xB8\x9C\xE8\xA5\xBF",
                                 "\xE4\xB8\x8A\xE4\xB8\x8B",
                                 "\xE9\x89\x9B\xE7\x9B\xB4",
                                 "\xE6\xB0\xB4\xE5\xB9\xB3",
                                 "\xE5\x8D\x98\xE4\xBD\x8D",
                                 "\xE5\x8D\x95\xE4\xBD\x8D",
                                 "\xE7\xAB\x96\xE5\x90\x91",
                                 "\xE5\x9E\x82\xE7\x9B\xB4",
                                 "\xEA\xB0\x80\xEC\x86\x8D\xEB\x8F\x84",
                                 "\xEC\x86\x8D\xEB\x8F\x84",
                                 "\xEB\xB3\x80\xEC\x9C\x84"};

bool is_ascii(Text text) {
    return std::ranges::all_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

std::optional<std::string> converted(Text text, char const* from) {
    auto* const conversion = iconv_open("UTF-8", from);
    if (conversion == iconv_t(-1)) {  // NOLINT(performance-no-int-to-ptr): as iconv.h says
        return std::nullopt;
    }
    std::string in(text);
    constexpr std::size_t longest = 4;  // bytes of a letter
    std::string out(longest * in.size() + 1, '\0');
    char* from_at = in.data();
    char* to_at = out.data();
    auto from_left = in.size();
    auto to_left = out.size();
    bool const done = iconv(conversion, &from_at, &from_left, &to_at, &to_left) != std::size_t(-1);
    iconv_close(conversion);
    out.resize(out.size() - to_left);
    return done ? std::optional(std::move(out)) : std::nullopt;
}

bool holds_known_word(Text text) {
    return std::ranges::any_of(known_words, [&](Text word) { return text.find(word) != Text::npos; });
}

/// Of West Europe or Turkey, of which the first's letters but six are the second's too; a byte that is none is a "?".
std::string from_latin(Text line) {
    constexpr unsigned first = 0x80;
    static auto const letters = [] {
        std::array<std::string, first> made;
        for (unsigned i = 0; i < first; ++i) {
            char const c = static_cast<char>(first + i);
            made.at(i) = converted({&c, 1}, "CP1254").value_or("?");
        }
        return made;
    }();
    std::string text;
    for (char const c : line) {
        auto const byte = static_cast<unsigned char>(c);
        byte < first ? (void)text.push_back(c) : (void)text.append(letters.at(byte - first));
    }
    return text;
}

std::string as_utf8(Text line) {
    if (line.find("\x1b$") != Text::npos) {  // of seven bits, shifted by escapes
        return converted(line, "ISO-2022-JP-2").value_or(std::string(line));
    }
    if (is_ascii(line) || converted(line, "UTF-8")) {
        return std::string(line);
    }
    for (char const* encoding : {"CP932", "EUC-JP", "GB18030", "BIG5", "EUC-KR"}) {
        auto const text = converted(line, encoding);
        if (text && holds_known_word(*text)) {
            return *text;
        }
    }
    return from_latin(line);
}

/// U+FF01 to U+FF5E are those of ASCII, U+3000 is a blank.
std::string without_full_width(std::string const& text) {
    std::string plain;
    for (std::size_t at = 0; at < text.size(); ++at) {
        auto const rest = Text(text).substr(at);
        constexpr std::size_t bytes = 3;
        auto const last = rest.size() >= bytes ? static_cast<unsigned char>(rest[2]) : 0U;
        if (rest.starts_with("\xE3\x80\x80")) {
            plain += ' ';
        } else if (rest.starts_with("\xEF\xBC") && last >= 0x81) {
            plain += static_cast<char>(last - 0x60);
        } else if (rest.starts_with("\xEF\xBD") && last >= 0x80 && last <= 0x9E) {
            plain += static_cast<char>(last - 0x20);
        } else {
            plain += text[at];
            continue;
        }
        at += bytes - 1;
    }
    return plain;
}

/// Tags of HTML begin with a letter or a slash: "<i>T</i>".
std::string without_tags(std::string text) {
    for (auto open = text.find('<'); open != std::string::npos; open = text.find('<', open)) {
        auto const close = text.find('>', open);
        constexpr std::size_t longest = 12;
        char const next = open + 1 < text.size() ? text[open + 1] : ' ';
        bool const tag = close != std::string::npos && close - open < longest
                         && ((next >= 'a' && next <= 'z') || next == '/' || (next >= 'A' && next <= 'Z'));
        tag ? (void)text.erase(open, close - open + 1) : (void)++open;
    }
    return text;
}

}  // namespace

std::string decoded(std::string_view line) {
    auto const text = as_utf8(line);
    return without_tags(is_ascii(text) ? text : without_full_width(text));
}

}  // namespace overturn
