#include "motion/pair_table.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/units.hpp"
#include "motion/column_unit.hpp"
#include "motion/detail/text_encoding.hpp"
#include "motion/detail/text_row.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

Pair parse_row(std::string_view row, std::string_view meaning) {
    if (has_decimal_commas(row)) {
        throw InputError(decimal_comma_said(row));
    }
    auto const split = row.find_first_of(" \t,;");
    auto const second = row.substr(std::min(row.find_first_not_of(" \t,;", split), row.size()));
    Pair point;
    validate(parse_number(row.substr(0, split), point.first) && parse_number(second, point.second),
             "'{}' (must be two numbers: {}). Mend the line", row, meaning);
    return point;
}

/// A line of text: its first field begins no number and is no "nan" or "inf".
bool is_text(std::string_view row) {
    auto const first = lowered(row.substr(0, row.find_first_of(" \t,;(")));
    auto const bare = first.substr(std::min(first.find_first_not_of("+-."), first.size()));
    bool const numeric = !bare.empty() && bare[0] >= '0' && bare[0] <= '9';
    return !bare.empty() && !numeric && bare != "nan" && bare != "inf" && bare != "infinity";
}

std::string without_quotes(std::string text) {
    std::erase(text, '"');
    return text;
}

/// Names are parted by a comma or semicolon, else by blanks; what follows a bracket's opening belongs to its name.
void take_names(std::string_view row, int line, PairTable& table) {
    auto const first_end = [&] {
        if (auto const comma = row.find_first_of(",;\t"); comma != std::string_view::npos) {
            return comma;
        }
        auto end = row.find(' ');
        auto const next = row.find_first_not_of(' ', end);
        if (next != std::string_view::npos && (row[next] == '(' || row[next] == '[')) {
            end = row.find_first_of(")]", next);
            end = end == std::string_view::npos ? end : end + 1;
        }
        return end;
    }();
    if (first_end == std::string_view::npos || first_end >= row.size()) {
        return;
    }
    auto const second = row.substr(row.find_first_not_of(" \t,;", first_end) == std::string_view::npos
                                       ? row.size()
                                       : row.find_first_not_of(" \t,;", first_end));
    table.first_name = trimmed(row.substr(0, first_end));
    table.second_name = trimmed(second);
    table.names_line = line;
}

/// A comment names the columns if it ends in a unit, "T [s], Sa [gal]" or "Sa in gal", and not in a quantity, "300
/// gal".
void take_comment(std::string_view comment, int line, PairTable& table) {
    PairTable named;
    take_names(comment, line, named);
    auto const [unit, bracketed] = unit_text_in_name(named.second_name);
    bool const known = unit_spelled(unit, Dimension::acceleration) || unit_spelled(unit, Dimension::velocity)
                       || (bracketed && unit_spelled(unit, Dimension::length));
    bool const quantity = named.second_name.find_first_of("0123456789")
                          < named.second_name.size() - (bracketed ? unit.size() + 1 : unit.size());
    if (named.names_line > 0 && known && (bracketed || (unit.size() > 1 && !quantity))) {
        bool const words = comment.find_first_of(",;\t") == std::string_view::npos;  // "Sa in gal"
        auto const length = unit_text_in_name(named.first_name).text.size();
        table.first_name = words && named.first_name.size() > 1 && length == 0 ? std::string() : named.first_name;
        table.second_name = named.second_name;
        table.names_line = line;
    }
}

/// Names without a unit, below a comment that says one: "# Sa in gal" over "T,Sa".
void keep_unit_of(PairTable const& said, PairTable& table) {
    auto const [unit, bracketed] = unit_text_in_name(table.second_name);
    bool const has_own =
        bracketed || unit_spelled(unit, Dimension::acceleration) || unit_spelled(unit, Dimension::velocity);
    if (said.names_line > 0 && !has_own) {
        table.second_name = fmt::format("{} ({})", table.second_name, unit_text_in_name(said.second_name).text);
        table.names_line = said.names_line;
    }
}

void take_head(std::string_view text, bool comment, int number, PairTable& table) {
    if (comment) {
        take_comment(trimmed(text.substr(1)), number, table);
        return;
    }
    auto const said = table;
    take_names(text, number, table);
    keep_unit_of(said, table);
}

}  // namespace

PairTable read_pair_table(std::string_view content, std::string const& name, std::string_view meaning,
                          std::function<void(Pair const&, Pair const*)> const& check) {
    PairTable table;
    TextLines lines(content);
    while (auto const line = lines.next()) {
        auto const row = trimmed(line->substr(0, line->find_first_of("#!")));
        bool const above = table.points.empty();
        if (row.empty() || (above && is_text(row))) {
            auto const text = without_quotes(decoded(trimmed(row.empty() ? *line : row)));
            if (text.size() > 1 && table.head.size() < std::size_t(head_lines_at_most)) {
                table.head.push_back({text, lines.number()});
            }
            if (above && text.size() > 1) {
                take_head(text, row.empty(), lines.number(), table);
            }
            continue;
        }
        try {
            auto const point = parse_row(row, meaning);
            check(point, above ? nullptr : &table.points.back());
            table.points.push_back(point);
            table.line.push_back(lines.number());
        } catch (InputError const& error) {
            throw InputError({name, lines.number()}, error.what());
        }
    }
    return table;
}

std::vector<Pair> read_pairs(std::string_view content, std::string const& name, std::string_view meaning,
                             std::function<void(Pair const&, Pair const*)> const& check) {
    return read_pair_table(content, name, meaning, check).points;
}

}  // namespace overturn
