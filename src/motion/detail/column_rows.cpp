#include "motion/detail/column_rows.hpp"

#include <algorithm>

#include "core/units.hpp"
#include "motion/text_lines.hpp"

namespace overturn {

Fields split_fields(std::string_view line) {
    Fields fields;
    line = trimmed(line);
    while (fields.count < fields.text.size()) {
        auto const end = line.find_first_of(",; \t");
        fields.text[fields.count++] = line.substr(0, end);
        if (end == std::string_view::npos) {
            break;
        }
        bool const comma = line[end] == ',' || line[end] == ';';
        line = trimmed(line.substr(end + (comma ? 1 : 0)));
        if (!comma && (line.starts_with(',') || line.starts_with(';'))) {
            line = trimmed(line.substr(1));
        }
    }
    return fields;
}

bool is_skipped(std::string_view line) {
    line = trimmed(line);
    return line.empty() || line.front() == '#' || line.front() == '%' || line.front() == ';';
}

bool is_names(Fields const& fields) {
    auto const first = lowered(fields.text[0]);
    auto const bare = first.substr(std::min(first.find_first_not_of("+-"), first.size()));
    bool const numeric = !bare.empty() && (bare[0] == '.' || (bare[0] >= '0' && bare[0] <= '9'));
    return !bare.empty() && !numeric && bare != "nan" && bare != "inf" && bare != "infinity";
}

std::vector<std::string> names_on(std::string_view line) {
    std::string_view const separators = line.find_first_of(",;") != std::string_view::npos ? ",;" : " \t";
    std::vector<std::string> names;
    for (auto rest = trimmed(line); !rest.empty();) {
        auto const end = rest.find_first_of(separators);
        names.emplace_back(trimmed(rest.substr(0, end)));
        rest = end == std::string_view::npos ? std::string_view{} : trimmed(rest.substr(end + 1));
    }
    return names;
}

namespace {

/// How finely the first column is printed: 8.117 has three decimals and four figures, 1.667E-02 five and four.
void note_digits(std::string_view text, Rows& rows) {
    auto const exponent_at = std::min(text.find_first_of("eEdD"), text.size());
    constexpr double beyond_doubles = 400;
    double exponent = 0;
    (void)parse_number(text.substr(std::min(exponent_at + 1, text.size())), exponent);
    auto const mantissa = text.substr(0, exponent_at);
    auto const point = mantissa.find('.');
    auto const decimals = point == std::string_view::npos ? 0 : static_cast<int>(mantissa.size() - point - 1);
    int figures = 0;
    bool leading = true;
    for (char const c : mantissa) {
        leading = leading && !(c >= '1' && c <= '9');
        figures += !leading && c >= '0' && c <= '9' ? 1 : 0;
    }
    rows.decimals =
        std::max(rows.decimals, decimals - static_cast<int>(std::clamp(exponent, -beyond_doubles, beyond_doubles)));
    rows.figures = std::max(rows.figures, figures);
}

/// A number with a decimal comma where semicolons part the fields.
bool has_decimal_comma(std::string_view line) {
    auto const comma = line.find(',');
    return line.find(';') != std::string_view::npos && comma != std::string_view::npos;
}

void append_row(Fields const& fields, Location const& where, Rows& rows) {
    if (rows.columns == 0) {
        rows.columns = fields.count;
        if (fields.count > columns_at_most) {
            throw InputError(where,
                             "more than 4 columns (which is which cannot be told). Keep "
                             "time,a_horizontal[,a_transverse][,a_vertical]");
        }
    }
    if (fields.count != rows.columns) {
        throw InputError(where,
                         fmt::format("a row of {}{} where the first has {} (columns must not change). Mend the "
                                     "row",
                                     fields.count, fields.count > columns_at_most ? " or more" : "", rows.columns));
    }
    for (std::size_t i = 0; i < fields.count; ++i) {
        double value = 0;
        if (!parse_number(fields.text[i], value)) {
            throw InputError(where, fmt::format("{} in column {} (not a finite number). Mend the row",
                                                in_quotes(fields.text[i]), i + 1));
        }
        rows.column[i].push_back(value);
    }
    note_digits(fields.text[0], rows);
    rows.line.push_back(where.line);
}

}  // namespace

Rows read_rows(std::string_view content, std::string const& file) {
    TextLines lines(content);
    Location where{file};
    Rows rows;
    bool names_seen = false;
    while (auto const line = lines.next()) {
        if (is_skipped(*line)) {
            if (rows.line.empty()) {
                rows.prose.take(*line, lines.number());
            }
            continue;
        }
        where.line = lines.number();
        auto const fields = split_fields(*line);
        if (rows.line.empty() && is_names(fields)) {
            if (names_seen) {
                throw InputError(where,
                                 "a second line of text before the numbers (columns have one line of names at "
                                 "most). Begin further ones with #");
            }
            names_seen = true;
            rows.names = names_on(*line);
            rows.names_line = where.line;
            continue;
        }
        if (has_decimal_comma(*line)) {
            throw InputError(where,
                             "comma and semicolon on one line (is the comma a decimal point?). Write decimal "
                             "points");
        }
        append_row(fields, where, rows);
    }
    if (rows.line.empty()) {
        throw InputError({file, where.line},
                         "no row of numbers (nothing to shake with). Give columns time,a_horizontal");
    }
    return rows;
}

}  // namespace overturn
