#include "motion/pair_table.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "core/error.hpp"
#include "motion/detail/table_columns.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

Names names_of(TextTable const& table, std::string const& file, PairForm const& form) {
    auto const are = [&](Names const& found, bool lowest) {
        bool const kept = lowest && !found.comment && !found.by_blanks && may_be_names(found.names);
        return kept || form.are_names(found.names[0], found.names[1]);
    };
    auto const elsewhere = [&](TextLine const& line, bool lowest) {
        constexpr std::size_t most = 12;
        bool others = names_others(line, lowest, table);
        for (std::size_t n = 3; lowest && n <= most; ++n) {
            auto const names = names_on(line.text, n).names;
            others = others || (!names.empty() && form.are_names(names[0], names[1]));
        }
        if (others) {
            throw InputError({file, line.number},
                             fmt::format("{} above two columns (another number of names than columns). Mend the names",
                                         in_quotes(line.text)));
        }
    };
    return names_above(table, are, elsewhere);
}

}  // namespace

PairTable read_pair_table(std::string_view content, std::string const& name, PairForm const& form) {
    auto const advice = fmt::format("Give two columns, {}", form.meaning);
    auto rows = read_text_table(content, name, {.begin_with = advice, .columns = 2, .motion = false});
    if (rows.last_row_short) {
        throw InputError({name, rows.line.back()},
                         fmt::format("a row of one number (must be two: {}). Mend the row", form.meaning));
    }
    PairTable table;
    auto names = names_of(rows, name, form);
    if (names.line > 0) {
        table.first_name = std::move(names.names[0]);
        table.second_name = std::move(names.names[1]);
        table.names_line = names.line;
    }
    table.points.reserve(rows.line.size());
    for (std::size_t i = 0; i < rows.line.size(); ++i) {
        table.points.emplace_back(rows.column[0][i], rows.column[1][i]);
    }
    table.line = std::move(rows.line);
    std::ranges::copy_if(rows.head, std::back_inserter(table.text),
                         [&](TextLine const& line) { return line.number != table.names_line; });
    std::ranges::move(rows.notes, std::back_inserter(table.text));
    if (form.check) {
        check_rows(table, name, form.check);
    }
    return table;
}

void check_rows(PairTable const& table, std::string const& name, RowCheck const& check) {
    for (std::size_t i = 0; i < table.points.size(); ++i) {
        try {
            check(table.points[i], i == 0 ? nullptr : &table.points[i - 1]);
        } catch (InputError const& error) {
            throw InputError({name, table.line[i]}, error.what());
        }
    }
}

std::vector<Pair> read_pairs(std::string_view content, std::string const& name, PairForm const& form) {
    auto table = read_pair_table(content, name, form);
    if (table.names_line > 0 && !form.are_names(table.first_name, table.second_name)) {
        throw InputError({name, table.names_line},
                         fmt::format("'{}' and '{}' over the columns (must be {}). Mend the names, or the columns",
                                     table.first_name, table.second_name, form.meaning));
    }
    return std::move(table.points);
}

}  // namespace overturn
