#include "motion/detail/text_row.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <optional>
#include <string>

#include "core/digit.hpp"
#include "core/error.hpp"
#include "core/units.hpp"
#include "motion/column_role.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

using Text = std::string_view;

constexpr Text separators = ",;";

/// "2003-05-29T02:13:22.043400" in seconds since 2000; nothing if it is none.
std::optional<double> seconds_of_date(Text text) {
    constexpr Text shape = "0000-00-00T00:00:00";
    if (text.size() < shape.size()) {
        return std::nullopt;
    }
    for (std::size_t i = 0; i < shape.size(); ++i) {
        bool const digit = is_digit(text[i]);
        if (shape[i] == '0' ? !digit : text[i] != shape[i]) {
            return std::nullopt;
        }
    }
    auto const part = [&](std::size_t at, std::size_t length) {
        double value = 0;
        return parse_number(text.substr(at, length), value) ? value : std::nan("");
    };
    using namespace std::chrono;
    auto const day =
        sys_days(year(static_cast<int>(part(0, 4))) / static_cast<int>(part(5, 2)) / static_cast<int>(part(8, 2)));
    auto const days = (day - sys_days(2000y / 1 / 1)).count();
    auto seconds = text.substr(17);
    seconds = seconds.substr(0, seconds.find('Z'));
    double const whole = 86400.0 * static_cast<double>(days) + 3600 * part(11, 2) + 60 * part(14, 2);
    double value = 0;
    return parse_number(seconds, value) ? std::optional(whole + value) : std::nullopt;
}

}  // namespace

namespace {

/// Up to the quote that ends it.
Text cut_quoted(Text& rest) {
    auto const close = rest.find('"', 1);
    auto const field = trimmed(rest.substr(1, close - 1));
    rest = trimmed(rest.substr(close + 1));
    if (!rest.empty() && separators.find(rest.front()) != Text::npos) {
        rest = trimmed(rest.substr(1));
    }
    return field;
}

bool parse_decimal_comma(Text field, double& value) {
    std::string plain(field);
    std::ranges::replace(plain, ',', '.');
    return parse_number(plain, value);
}

/// "0,123" in quotes
bool has_quoted_comma(Text line) {
    for (auto open = line.find('"'); open != Text::npos; open = line.find('"', open + 1)) {
        auto const close = line.find('"', open + 1);
        if (close == Text::npos) {
            return false;
        }
        if (line.substr(open, close - open).find(',') != Text::npos) {
            return true;
        }
        open = close;
    }
    return false;
}

}  // namespace

Text cut_field(Text& rest) {
    if (rest.starts_with('"') && rest.find('"', 1) != Text::npos) {
        return cut_quoted(rest);
    }
    auto const end = rest.find_first_of(",; \t");
    auto const field = rest.substr(0, end);
    if (end == Text::npos) {
        rest = {};
        return field;
    }
    bool const parted = separators.find(rest[end]) != Text::npos;
    rest = trimmed(rest.substr(end + (parted ? 1 : 0)));
    if (!parted && !rest.empty() && separators.find(rest.front()) != Text::npos) {
        rest = trimmed(rest.substr(1));
    }
    return field;
}

bool has_decimal_commas(Text line) {
    line = trimmed(line);
    if (has_quoted_comma(line)) {
        return true;
    }
    bool const comma = line.find(',') != Text::npos;
    if (comma && line.find(';') != Text::npos) {
        return true;
    }
    if (!comma || line.find('.') != Text::npos) {
        return false;
    }
    auto const digit_at = [&](std::size_t at) { return at < line.size() && is_digit(line[at]); };
    bool between_digits = true;
    bool before_nought = false;
    for (auto at = line.find(','); at != Text::npos; at = line.find(',', at + 1)) {
        between_digits = between_digits && at > 0 && digit_at(at - 1) && digit_at(at + 1);
        before_nought = before_nought || (digit_at(at + 1) && line[at + 1] == '0' && digit_at(at + 2));
    }
    return between_digits && (before_nought || line.find_first_of(" \t") != Text::npos);
}

std::string decimal_comma_text(Text line) {
    return fmt::format("{} (is the comma a decimal point?). Write decimal points", in_quotes(trimmed(line)));
}

void read_row(Text line, TextRow& row) {
    row = {std::move(row.values), {}, 0, false, true};
    row.values.clear();
    bool const parted = line.find_first_of(separators) != Text::npos;
    row.decimal_comma = has_decimal_commas(line);
    if (!parted) {
        try {
            append_numbers(line, {}, 0, row.values);
            return;
        } catch (InputError const&) {
            row.values.clear();
        }
    }
    auto rest = trimmed(line);
    bool const ends_in_separator = !rest.empty() && separators.find(rest.back()) != Text::npos;
    for (std::size_t at = 1; !rest.empty(); ++at) {
        double value = 0;
        auto const field = cut_field(rest);
        auto const date = at == 1 ? seconds_of_date(field) : std::nullopt;
        if (date) {
            value = *date;
        } else if (!parse_number(field, value) && !(row.decimal_comma && parse_decimal_comma(field, value))) {
            row.bad = field;
            row.bad_at = at;
            row.numbers = false;
            return;
        }
        row.values.push_back(value);
    }
    if (ends_in_separator) {
        row.bad_at = row.values.size() + 1;
        row.numbers = false;
    }
}

bool begins_like_numbers(Text line, TextRow const& row) {
    constexpr std::size_t some = 2;
    if (column_role(row.bad).quantity != Quantity::index && column_role(row.bad).is_known()) {
        return false;
    }
    auto const is_odd = [](std::string const& word) {
        constexpr auto odd = std::to_array<Text>({"nan", "inf", "-inf", "+inf", "infinity", "na", "n/a", "null"});
        return std::ranges::find(odd, word) != odd.end();
    };
    auto const first = lowered(trimmed(line).substr(0, trimmed(line).find_first_of(",; \t")));
    bool const odd = is_odd(first) || (row.values.size() == 1 && is_odd(lowered(row.bad)));
    return row.values.size() >= some || (row.values.size() == 1 && (row.bad.size() < 2 || first.empty())) || odd;
}

}  // namespace overturn
