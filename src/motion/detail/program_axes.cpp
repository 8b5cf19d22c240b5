#include "motion/detail/program_axes.hpp"

#include <algorithm>
#include <string>

#include "core/units.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

using Text = std::string_view;

/// "v", "a_v (g)", "av": the letter alone; 0 of any other name
char letter_of(Text name) {
    auto const stem = lowered(trimmed(name.substr(0, name.find_first_of("(["))));
    auto const at = stem.find_last_of("_ -.");
    auto const word = Text(stem).substr(at == std::string::npos ? 0 : at + 1);
    bool const prefixed = word.size() == 2 && word.front() == 'a';
    return word.size() == 1 || prefixed ? word.back() : '\0';
}

bool is_mapped(TableColumns const& columns, std::size_t column) {
    return std::ranges::find(columns.mapped, column, &MappedColumn::column) != columns.mapped.end();
}

/// "t,d,v,a": is v a velocity or the vertical? So too "t,v".
void check_letter_v(TableColumns const& columns, Location const& names, Text advice) {
    auto const has = [&](Text name) {
        return std::ranges::any_of(columns.roles, [&](ColumnRole const& role) { return lowered(role.name) == name; });
    };
    auto const is_v = [&](PlacedColumn const& motion) {
        return lowered(motion.role.name) == "v" && !is_mapped(columns, motion.column);
    };
    if (std::ranges::any_of(columns.motions, is_v) && (has("a") || has("d") || columns.motions.size() == 1)) {
        throw InputError(names, fmt::format("column 'v' (alone, or beside 'a' or 'd', a velocity as well as the "
                                            "vertical one). {}",
                                            advice));
    }
}

}  // namespace

void check_program_axes(TableColumns const& columns, Location const& names, std::string_view advice) {
    check_letter_v(columns, names, advice);
    std::string letters, named_axes;
    for (auto const& [column, role] : columns.motions) {
        if (!is_mapped(columns, column)) {
            letters += letter_of(role.name);
            named_axes += fmt::format("{}'{}'", named_axes.empty() ? "" : ", ", role.name);
        }
    }
    auto const has = [&](char letter) { return letters.find(letter) != std::string::npos; };
    int const axes = (has('u') ? 1 : 0) + (has('v') ? 1 : 0) + (has('w') ? 1 : 0);
    if (axes >= 2 && !has('n') && !has('s')) {
        throw InputError(names, fmt::format("columns {} (u, v and w are axes of a program, of which any may be the "
                                            "vertical one). {}",
                                            named_axes, advice));
    }
}

}  // namespace overturn
