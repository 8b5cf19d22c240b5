#include "motion/percent_in_name.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "core/units.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

using Text = std::string_view;

constexpr Text figures = "0123456789.";
constexpr auto percents = std::to_array<Text>({"%", "percent", "per cent", "pct"});

/// Without one of the words and the separators before it, if it begins so.
template <std::size_t N> bool cut_word(Text& text, std::array<Text, N> const& words, Text separators) {
    auto const rest = text.substr(std::min(text.find_first_not_of(separators), text.size()));
    for (Text const word : words) {
        auto const behind = rest.substr(std::min(word.size(), rest.size()));
        bool const goes_on = !behind.empty() && behind.front() >= 'a' && behind.front() <= 'z' && word != "%";
        if (rest.starts_with(word) && !goes_on) {
            text = behind;
            return true;
        }
    }
    return false;
}

std::optional<double> cut_figure(Text& text, Text separators) {
    auto const rest = text.substr(std::min(text.find_first_not_of(separators), text.size()));
    auto const end = std::min(rest.find_first_not_of(figures), rest.size());
    double value = 0;
    if (!parse_number(rest.substr(0, end), value)) {
        return std::nullopt;
    }
    text = rest.substr(end);
    return value;
}

/// "in 50 years", "/50yr"
bool cut_years(Text& text) {
    constexpr auto in = std::to_array<Text>({"in", "/", "per"});
    constexpr auto years = std::to_array<Text>({"years", "year", "yrs", "yr", "y", "a"});
    auto rest = text;
    bool const joined = text.starts_with('-') || text.starts_with('_');
    if (!cut_word(rest, in, " -_") && !joined) {  // "damping 5 % 475 yr" is none
        return false;
    }
    if (!cut_figure(rest, " -_/") || !cut_word(rest, years, " -_.")) {
        return false;
    }
    text = rest;
    return true;
}

constexpr auto probability = std::to_array<Text>(
    {"probability", "prob", "poe", "pe", "exceedance", "exceedence", "exceeded", "exceeding", "chance"});
constexpr auto between = std::to_array<Text>({"of", "being", "annual", "the"});

/// How much of what stands behind a percentage makes it a hazard level; 0: nothing does.
std::size_t level_behind(Text text) {
    auto rest = text;
    bool level = false;
    while (cut_word(rest, probability, " .-_(") || (level && cut_word(rest, between, " .-_"))) {
        level = true;
    }
    level = cut_years(rest) || level;
    return level ? text.size() - rest.size() : 0;
}

/// Where the words before it begin that make it one, "probability of exceedance: "; its own end if there are none.
std::size_t level_before(Text text) {
    auto begin = text.size();
    constexpr Text separators = " \t:=_-(";
    for (bool more = true; more;) {
        auto const stop = text.substr(0, begin).find_last_not_of(separators);
        auto const left = text.substr(0, stop == Text::npos ? 0 : stop + 1);
        auto const start = left.find_last_of(" \t:=_-(,;#[");
        auto const word = left.substr(start == Text::npos ? 0 : start + 1);
        bool const known = std::ranges::find(probability, word) != probability.end();
        more = !word.empty() && (known || std::ranges::find(between, word) != between.end());
        begin = more ? left.size() - word.size() : begin;
    }
    auto const words = text.substr(begin);
    bool const any = std::ranges::any_of(probability, [&](Text word) { return words.find(word) != Text::npos; });
    return any ? begin : text.size();
}

}  // namespace

std::string without_hazard_levels(std::string_view text) {
    auto const lower = lowered(text);
    std::string plain(text);
    for (Text const percent : percents) {
        for (auto at = lower.find(percent); at != std::string::npos; at = lower.find(percent, at + 1)) {
            auto const before = trimmed(Text(lower).substr(0, at));
            auto const last = before.find_last_not_of(figures);
            auto const begin = last == Text::npos ? 0 : last + 1;
            auto const first = static_cast<std::size_t>(before.data() - lower.data()) + begin;
            if (begin == before.size()) {
                continue;
            }
            auto const end = at + percent.size();
            auto const behind = level_behind(Text(lower).substr(end));
            auto const start = level_before(Text(lower).substr(0, first));
            if (behind > 0 || start < first) {
                std::fill(plain.begin() + start, plain.begin() + (end + behind), ' ');
            }
        }
    }
    return plain;
}

bool is_damping_alone(std::string_view lower) {
    constexpr double highest = 30;
    constexpr auto at = std::to_array<Text>({"@", "at", "for", "with"});
    constexpr auto damping = std::to_array<Text>({"damping", "damped", "damp", "ratio", "of", "critical", "viscous"});
    auto rest = trimmed(lower);
    (void)cut_word(rest, at, " ,(");
    auto const share = cut_figure(rest, " ,(");
    if (!share || *share <= 0 || *share > highest || !cut_word(rest, percents, " ")) {
        return false;
    }
    while (cut_word(rest, damping, " -_")) {}
    return trimmed(rest).find_first_not_of(".)") == Text::npos;
}

}  // namespace overturn
