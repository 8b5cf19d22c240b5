#include <algorithm>
#include <array>

#include "core/digit.hpp"
#include "motion/column_unit.hpp"
#include "motion/detail/statement_words.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

using Text = std::string_view;

constexpr Text letters = "abcdefghijklmnopqrstuvwxyz";

/// The word that ends before `at`, without blanks, colons and equals signs between.
Text word_before(Text line, std::size_t at) {
    auto const end = line.find_last_not_of(" \t:=", at == 0 ? 0 : at - 1);
    if (at == 0 || end == Text::npos || !is_small_letter(line[end])) {
        return {};
    }
    auto const begin = line.find_last_not_of(letters, end);
    return line.substr(begin == Text::npos ? 0 : begin + 1, end - (begin == Text::npos ? 0 : begin + 1) + 1);
}

/// A letter is a unit where it stands in brackets, or behind a word that says so.
bool is_marked(Text line, std::size_t at, std::size_t length) {
    bool const bracketed = at > 0 && (line[at - 1] == '(' || line[at - 1] == '[') && at + length < line.size()
                           && (line[at + length] == ')' || line[at + length] == ']');
    auto const word = word_before(line, at);
    constexpr std::array words{"in", "of", "unit", "units", "is", "are"};
    return bracketed || std::ranges::find(words, word) != words.end();
}

/// "9.81 m/s2", "300 gal": a quantity, which says nothing of the file's numbers.
bool is_quantity(Text line, std::size_t at) {
    auto const end = line.find_last_not_of(" \t", at == 0 ? 0 : at - 1);
    auto const digit_at = [&](std::size_t i) { return is_digit(line[i]); };
    return at > 0 && end != Text::npos && (digit_at(end) || (line[end] == '.' && end > 0 && digit_at(end - 1)));
}

/// "in g / 1000", "m/s2 (x 0.01)", "100 x m/s2", "tenths of g": no unit of the numbers.
bool has_factor(Text line, std::size_t at, std::size_t end) {
    auto const is_sign = [](Text text) {
        return text.starts_with('/') || text.starts_with('*') || text.starts_with('x') || text.starts_with("\xC3\x97");
    };
    auto behind = line.substr(std::min(line.find_first_not_of(" \t([", end), line.size()));
    if (is_sign(behind)) {
        behind = trimmed(behind.substr(behind.starts_with('\xC3') ? 2 : 1));
        if (!behind.empty() && is_digit(behind.front())) {
            return true;
        }
    }
    auto before = trimmed(line.substr(0, at));
    before = before.ends_with('(') ? trimmed(before.substr(0, before.size() - 1)) : before;
    if (before.ends_with(" x") || before.ends_with('*') || before.ends_with("\xC3\x97")) {
        before = trimmed(before.substr(0, before.size() - (before.ends_with('\x97') ? 2 : 1)));
        return !before.empty() && is_digit(before.back());
    }
    before = trimmed(before.substr(0, before.size() - (before.ends_with(" of") ? 2 : 0)));
    constexpr auto shares = std::to_array<Text>(
        {"tenth", "tenths", "hundredth", "hundredths", "thousandth", "thousandths", "percent", "per cent", "%"});
    return std::ranges::any_of(shares, [&](Text share) { return before.ends_with(share); });
}

}  // namespace

void each_unit(Text line, Dimension dimension, std::function<void(double)> const& take) {
    constexpr Text ends = " \t()[]{},;:=\"|";
    constexpr std::size_t telling = 3;
    for (std::size_t at = 0; at < line.size();) {
        at = std::min(line.find_first_not_of(ends, at), line.size());
        auto const end = std::min(line.find_first_of(ends, at), line.size());
        auto word = line.substr(at, end - at);
        while (word.ends_with('.')) {
            word.remove_suffix(1);
        }
        auto const unit = word.empty() ? std::nullopt : unit_spelled(word, dimension);
        if (unit && !is_quantity(line, at) && !has_factor(line, at, end)
            && (word.size() >= telling || is_marked(line, at, word.size()))) {
            take(*unit);
        }
        at = end;
    }
}

}  // namespace overturn
