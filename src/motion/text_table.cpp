#include "motion/text_table.hpp"

#include <algorithm>
#include <cmath>

#include "core/digit.hpp"
#include "core/error.hpp"
#include "core/units.hpp"
#include "motion/detail/text_encoding.hpp"
#include "motion/detail/text_row.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

using Text = std::string_view;

constexpr std::size_t columns_at_most = 64;

/// Nothing but that it is the end: "*** End Data ***", "end of file". "end of file, all in g" says more.
bool says_end_alone(Text line) {
    auto const lower = lowered(line);
    constexpr auto ends =
        std::to_array<Text>({"end", "of", "data", "file", "record", "records", "the", "eof", "table"});
    return std::ranges::all_of(parted_at(lower, " \t*-/&=_.:<>[]()"),
                               [&](Text word) { return std::ranges::find(ends, word) != ends.end(); });
}

/// "*** End Data ***", "End of data", "END", "/&"
bool is_trailer(Text line) {
    line = trimmed(line);
    bool const marked =
        line.starts_with('*') || line.starts_with('-') || line.starts_with('/') || line.starts_with('&');
    auto const lower = lowered(line);
    return (marked && lower.find("end") != std::string::npos) || lower.starts_with("end of ")
           || ((lower.starts_with("end") || lower == "eof") && says_end_alone(line));
}

/// 8.117 has three decimals and four figures, 1.667E-02 five and four.
void note_digits(Text text, TextTable::Digits& digits) {
    auto const exponent_at = std::min(text.find_first_of("eEdD"), text.size());
    constexpr double beyond_doubles = 400;
    double exponent = 0;
    (void)parse_number(text.substr(std::min(exponent_at + 1, text.size())), exponent);
    auto const mantissa = text.substr(0, exponent_at);
    auto const point = mantissa.find('.');
    auto const decimals = point == Text::npos ? 0 : static_cast<int>(mantissa.size() - point - 1);
    int figures = 0;
    bool leading = true;
    for (char const c : mantissa) {
        leading = leading && !(c >= '1' && c <= '9');
        figures += !leading && is_digit(c) ? 1 : 0;
    }
    exponent = std::clamp(exponent, -beyond_doubles, beyond_doubles);
    digits.decimals = std::max(digits.decimals, decimals - static_cast<int>(exponent));
    digits.figures = std::max(digits.figures, figures);
}

class Reader {
  public:
    Reader(Text content, std::string const& file, TableForm const& form)
        : lines_(content), bytes_(content.size()), where_{file}, form_(form) {}

    TextTable read() && {
        TextRow row;
        while (auto const line = lines_.next()) {
            where_.line = lines_.number();
            if (is_comment(*line)) {
                take_text(*line);
                continue;
            }
            if (!table_.line.empty() && is_trailer(*line)) {
                ended_ = true;
                if (!says_end_alone(*line)) {
                    take_text(*line);
                }
                continue;
            }
            read_row(*line, row);
            take(without_note(*line, row), row);
        }
        if (table_.line.empty()) {
            throw InputError({where_.file, where_.line},
                             fmt::format("no row of numbers (nothing to read). {}", form_.begin_with));
        }
        set_count_and_step_apart();
        return std::move(table_);
    }

  private:
    void take_text(Text line) { take_text(line, table_.line.empty() ? table_.head : table_.notes); }
    void take_text(Text line, std::vector<TextLine>& lines) {
        bool const kept = &lines == &table_.head || lines.size() < std::size_t(head_lines_at_most);
        if (kept && !trimmed(line).empty()) {
            lines.push_back({decoded(trimmed(line)), where_.line});
        }
    }

    /// The numbers before a comment, "1.0 2.0 ! knee", which is text.
    Text without_note(Text line, TextRow& row) {
        auto const mark = row.numbers || form_.motion ? Text::npos : line.find_first_of("#!");
        if (mark == Text::npos) {
            return line;
        }
        TextRow before;
        read_row(line.substr(0, mark), before);
        constexpr std::size_t telling = 2;  // "1992 # Landers" is none
        bool const names = table_.line.empty() && line.substr(0, mark).find_first_of(",;\t") != Text::npos;
        if (!before.numbers && names) {
            take_text(line.substr(mark), table_.notes);
            return line.substr(0, mark);
        }
        if (!before.numbers || (table_.line.empty() && before.values.size() < telling)) {
            return line;
        }
        take_text(line.substr(mark), table_.notes);
        row = std::move(before);
        return line.substr(0, mark);
    }

    void take(Text line, TextRow const& row) {
        bool const above = table_.line.empty();
        if (!row.numbers && above && !begins_like_numbers(line, row)) {
            take_text(line);
            return;
        }
        if (row.decimal_comma) {
            throw InputError(where_, decimal_comma_text(line));
        }
        if (ended_) {
            throw InputError(where_, "numbers behind the end of the data (which ones count?). Keep one block");
        }
        if (!row.numbers) {
            throw InputError(where_, fmt::format("{} in column {} (not a finite number). Mend the row",
                                                 in_quotes(row.bad), row.bad_at));
        }
        append(line, row);
    }

    void append(Text line, TextRow const& row) {
        auto const width = row.values.size();
        if (table_.line.size() == 1 && width != table_.columns() && may_be_count_and_step()) {
            table_.head.push_back({first_row_, table_.line.front()});
            TextTable text{std::move(table_.head), std::move(table_.notes), {}, {}};
            table_ = std::move(text);
        }
        if (table_.line.empty()) {
            begin(line, width);
        }
        if (table_.last_row_short || width > table_.columns()) {
            refuse_width(table_.last_row_short ? last_width_ : width);
        }
        table_.last_row_short = width < table_.columns();
        last_width_ = width;
        for (std::size_t i = 0; i < width; ++i) {
            table_.column[i].push_back(row.values[i]);
        }
        auto rest = trimmed(line);
        for (std::size_t i = 0; i < std::min(width, TextTable::looked_at); ++i) {
            note_digits(cut_field(rest), table_.digits.at(i));
        }
        table_.line.push_back(where_.line);
    }

    /// "1500 0.01" or "0.01 1500" above as many rows "0.00 1.5": text.
    void set_count_and_step_apart() {
        constexpr std::size_t fewest = 4;
        if (table_.line.size() < fewest || !may_be_count_and_step()) {
            return;
        }
        auto const behind = static_cast<double>(table_.line.size() - 1);
        bool const count_first = table_.column[0][0] == behind;
        constexpr double longest_s = 1;
        double const step = table_.column[count_first ? 1 : 0][0];
        auto const& times = table_.column[0];
        if ((!count_first && table_.column[1][0] != behind) || !(step > 0 && step <= longest_s)
            || !std::is_sorted(times.begin() + 1, times.end())) {
            return;
        }
        table_.head.push_back({first_row_, table_.line.front()});
        for (auto& column : table_.column) {
            column.erase(column.begin());
        }
        table_.line.erase(table_.line.begin());
    }

    [[nodiscard]] bool may_be_count_and_step() const {
        constexpr double longest_s = 1;
        auto const counts = [](double value) { return value >= 2 && value == std::floor(value); };
        if (!form_.motion || table_.columns() != 2 || table_.last_row_short) {
            return false;
        }
        double const first = table_.column[0][0];
        return counts(first) || (first > 0 && first <= longest_s && counts(table_.column[1][0]));
    }

    void begin(Text line, std::size_t width) {
        if (form_.columns > 0 && width != form_.columns) {
            throw InputError(where_, fmt::format("a row of {} (it must be of {} numbers). {}", width, form_.columns,
                                                 form_.begin_with));
        }
        if (width > columns_at_most) {
            throw InputError(where_,
                             fmt::format("{} numbers on a line (more than {} columns are no record). Keep those "
                                         "that are meant",
                                         width, columns_at_most));
        }
        first_row_ = std::string(trimmed(line));
        auto const mark = first_row_.find_first_of(",;\t");
        table_.separator = mark == std::string::npos ? ' ' : first_row_[mark];
        table_.column.resize(width);
        for (auto& column : table_.column) {
            column.reserve(bytes_ / (line.size() + 1) + 1);
        }
    }

    [[noreturn]] void refuse_width(std::size_t width) {
        auto const at = table_.last_row_short ? table_.line.back() : where_.line;
        throw InputError({where_.file, at},
                         fmt::format("a row of {} where the first has {} (a value is lost or too many). Mend the row",
                                     width, table_.columns()));
    }

    TextLines lines_;
    std::size_t bytes_;
    Location where_;
    TableForm form_;
    TextTable table_;
    std::string first_row_;
    std::size_t last_width_ = 0;
    bool ended_ = false;
};

}  // namespace

std::size_t TextTable::values() const {
    std::size_t count = 0;
    for (auto const& each : column) {
        count += each.size();
    }
    return count;
}

std::vector<double> TextTable::in_rows() const {
    std::vector<double> all;
    all.reserve(values());
    for (std::size_t row = 0; row < line.size(); ++row) {
        for (auto const& each : column) {
            if (row < each.size()) {
                all.push_back(each[row]);
            }
        }
    }
    return all;
}

bool is_comment(std::string_view line) {
    line = trimmed(line);
    return line.empty() || Text("#%;!").find(line.front()) != Text::npos;
}

TextTable read_text_table(std::string_view content, std::string const& file, TableForm const& form) {
    return Reader(content, file, form).read();
}

bool holds_text_table(std::string_view content) {
    TextLines lines(content);
    TextRow row;
    while (lines.number() < head_lines_at_most) {
        auto const line = lines.next();
        if (!line) {
            return false;
        }
        if (!is_comment(*line)) {
            read_row(*line, row);
            if (row.numbers || begins_like_numbers(*line, row)) {
                return true;
            }
        }
    }
    return false;
}

}  // namespace overturn
