#include <algorithm>

#include "core/digit.hpp"
#include "core/units.hpp"
#include "motion/text_lines.hpp"
#include "spectra/detail/target_names.hpp"

namespace overturn {
namespace {

using Text = std::string_view;

bool has_any(Text text, std::initializer_list<Text> words) {
    return std::ranges::any_of(words, [&](Text word) { return text.find(word) != Text::npos; });
}

std::optional<double> number_behind(Text text) {
    text = text.substr(std::min(text.find_first_not_of(" \t:=of"), text.size()));
    double value = 0;
    return parse_number(text.substr(0, text.find_first_not_of("0123456789.")), value) ? std::optional(value)
                                                                                      : std::nullopt;
}

}  // namespace

std::optional<double> number_at_end(std::string_view text) {
    text = trimmed(text);
    auto const begin = text.find_last_not_of("0123456789.");
    double value = 0;
    return parse_number(text.substr(begin == Text::npos ? 0 : begin + 1), value) ? std::optional(value) : std::nullopt;
}

std::string with_percent_signs(std::string_view text) {
    auto const lower = lowered(text);
    std::string plain;
    for (std::size_t at = 0; at < text.size();) {
        std::size_t length = 0;
        for (Text const word : {" percent", "percent", " per cent", "pct"}) {
            length = length == 0 && Text(lower).substr(at).starts_with(word) ? word.size() : length;
        }
        plain += length > 0 ? '%' : text[at];
        at += std::max<std::size_t>(length, 1);
    }
    return plain;
}

std::optional<double> damping_in(std::string_view lower) {
    auto const plain = with_percent_signs(lower);
    lower = plain;
    // "5 % damped", "2 % of critical": the number right before; "10 % in 50 years, damping 5 %" is none.
    constexpr std::size_t farthest = 16;
    for (Text const word : {"damp", "of critical"}) {
        auto const at = lower.find(word);
        auto const percent = at == Text::npos ? Text::npos : lower.rfind('%', at);
        if (percent == Text::npos || at - percent > farthest
            || lower.substr(percent, at - percent).find_first_of(",;:0123456789") != Text::npos
            || has_any(lower.substr(percent, at - percent), {" in ", "year", "yr", " and "})) {
            continue;
        }
        auto const value = number_at_end(lower.substr(0, percent));
        return value ? std::optional(*value / 100) : std::nullopt;
    }
    for (Text const key :
         {"damping ratio", "damping factor", "damping", "zeta", "\xCE\xB6", "xi", "\xCE\xBE", "h =", "h="}) {
        auto const at = lower.find(key);
        if (at == Text::npos || (at > 0 && is_small_letter(lower[at - 1]))) {
            continue;
        }
        auto const value = number_behind(lower.substr(at + key.size()));
        auto const begin = std::min(lower.find_first_not_of(" \t:=of", at + key.size()), lower.size());
        auto const end = std::min(lower.find_first_not_of("0123456789.", begin), lower.size());
        auto const mark = lower.find_first_not_of(" \t", end);
        bool const percent_behind = value && mark != Text::npos && lower[mark] == '%';
        if (percent_behind && lower.substr(mark + 1).starts_with(" and ")) {
            return std::nullopt;  // "damping 5 % and 2 %"
        }
        double const share = value.value_or(0) / (percent_behind ? 100 : 1);
        if (share > 0 && share < 1) {
            return share;
        }
    }
    return std::nullopt;
}

}  // namespace overturn
