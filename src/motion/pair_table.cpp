#include "motion/pair_table.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "core/units.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

Pair parse_row(std::string_view row, std::string_view meaning) {
    auto const split = row.find_first_of(" \t,;");
    auto const second = row.substr(std::min(row.find_first_not_of(" \t,;", split), row.size()));
    Pair point;
    validate(parse_number(row.substr(0, split), point.first) && parse_number(second, point.second),
             "'{}' (must be two numbers: {}). Mend the line", row, meaning);
    return point;
}

/// A line of names: its first field begins with a letter and is no "nan" or "inf".
bool is_names(std::string_view row) {
    auto const first = lowered(row.substr(0, row.find_first_of(" \t,;(")));
    bool const lettered = !first.empty() && ((first[0] >= 'a' && first[0] <= 'z') || first[0] == '"');
    return lettered && first != "nan" && first != "inf" && first != "infinity";
}

}  // namespace

std::vector<Pair> read_pairs(std::string_view content, std::string const& name, std::string_view meaning,
                             std::function<void(Pair const&, Pair const*)> const& check) {
    std::vector<Pair> points;
    TextLines lines(content);
    bool names_seen = false;
    while (auto const line = lines.next()) {
        auto const row = trimmed(line->substr(0, line->find_first_of("#!")));
        if (row.empty()) {
            continue;
        }
        if (points.empty() && !names_seen && is_names(row)) {
            names_seen = true;
            continue;
        }
        try {
            auto const point = parse_row(row, meaning);
            check(point, points.empty() ? nullptr : &points.back());
            points.push_back(point);
        } catch (InputError const& error) {
            throw InputError({name, lines.number()}, error.what());
        }
    }
    return points;
}

}  // namespace overturn
