#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "core/units.hpp"
#include "motion/column_role.hpp"
#include "motion/text_lines.hpp"
#include "motion/text_table.hpp"

namespace overturn {
namespace {

using Text = std::string_view;

std::string without_quotes(Text name) {
    std::string plain(trimmed(name));
    std::erase(plain, '"');
    return std::string(trimmed(plain));
}

/// Where the separator stands next, outside quotes where these are closed: "Displacement (cm), N-S" is one name.
std::size_t find_outside_quotes(Text line, Text separator) {
    bool const closed = std::ranges::count(line, '"') % 2 == 0;
    bool quoted = false;
    for (std::size_t at = 0; at < line.size(); ++at) {
        quoted = closed && (line[at] == '"') != quoted;
        if (!quoted && line.substr(at).starts_with(separator)) {
            return at;
        }
    }
    return Text::npos;
}

std::vector<std::string> parted_by(Text line, Text separator) {
    std::vector<std::string> names;
    for (bool more = true; more;) {
        auto const end = find_outside_quotes(line, separator);
        more = end != Text::npos;
        names.push_back(without_quotes(line.substr(0, end)));
        line = more ? line.substr(end + separator.size()) : Text{};
        if (separator == "  ") {
            line = trimmed(line);
        }
    }
    return names;
}

/// At single blanks; "(cm/s s)" and "[sec]" stay with the word before them.
std::vector<std::string> parted_by_blanks(Text line) {
    std::vector<std::string> names;
    int depth = 0;
    bool fresh = true;
    for (char const c : line) {
        bool const open = c == '(' || c == '[';
        if ((c == ' ' || c == '\t') && depth == 0) {
            fresh = true;
            continue;
        }
        if (fresh && (!open || names.empty())) {
            names.emplace_back();
        } else if (fresh) {
            names.back() += ' ';
        }
        fresh = false;
        depth += open ? 1 : c == ')' || c == ']' ? -1 : 0;
        depth = std::max(depth, 0);
        names.back() += c;
    }
    return names;
}

/// Without the brackets around it, and without a key: "units: s" of a row of units.
std::string bare_unit(std::string text) {
    constexpr auto keys = std::to_array<Text>({"unit", "units", "einheit", "unidad", "unidades", "birim",
                                               "\xE5\x8D\x98\xE4\xBD\x8D", "\xE5\x8D\x95\xE4\xBD\x8D"});
    if (auto const colon = text.find(':'); colon != std::string::npos) {
        bool const key = colon + 1 < text.size()
                         && std::ranges::find(keys, Text(lowered(trimmed(Text(text).substr(0, colon))))) != keys.end();
        text = key ? text.substr(colon + 1) : text;
    }
    std::erase_if(text, [](char c) { return Text("()[]").find(c) != Text::npos; });
    return std::string(trimmed(text));
}

/// "(s),(gal)", "sec  cm/s2"
bool is_units_row(std::vector<std::string> const& names) {
    return !names.empty() && std::ranges::all_of(names, [](std::string const& name) {
        auto const unit = bare_unit(name);
        bool const in_a_year = unit == "1/yr" || unit == "1/a" || unit == "1/year";
        return unit.empty() || unit == "-" || in_a_year || column_role("x (" + unit + ")").unit;
    });
}

bool all_blank_or_rule(Text line) { return line.find_first_not_of(" \t-=_,;|#%") == Text::npos; }

}  // namespace

Names names_on(std::string_view line, std::size_t count) {
    line = trimmed(line);
    while (!line.empty() && Text("#%!/*").find(line.front()) != Text::npos) {
        line = trimmed(line.substr(1));
    }
    for (Text const separator : {",", ";", "\t", "|", "  "}) {
        if (line.find(separator) == Text::npos) {
            continue;
        }
        auto names = parted_by(line, separator);
        if (names.size() == count + 1 && names.back().empty()) {
            names.pop_back();
        }
        if (names.size() == count) {
            return {std::move(names), separator == "  "};
        }
    }
    auto names = parted_by_blanks(line);
    return {names.size() == count ? std::move(names) : std::vector<std::string>{}, true};
}

Names names_above(TextTable const& table, std::function<bool(Names const&, bool lowest)> const& are,
                  std::function<void(TextLine const&, bool lowest)> const& elsewhere) {
    std::vector<std::string> units;
    int units_line = 0;
    bool lowest = true;  // but for units and rules
    for (auto line = table.head.rbegin(); table.columns() > 1 && line != table.head.rend(); ++line) {
        if (all_blank_or_rule(line->text)) {
            continue;
        }
        auto found = names_on(line->text, table.columns());
        found.comment = is_comment(line->text);
        if (!found.names.empty() && units.empty() && is_units_row(found.names)) {
            units = std::move(found.names);
            units_line = line->number;
            continue;
        }
        bool const last = std::exchange(lowest, false);
        if (!found.names.empty() && are(found, last)) {
            for (std::size_t i = 0; i < units.size(); ++i) {
                auto const unit = bare_unit(units[i]);
                found.names[i] =
                    unit.empty() || unit == "-" ? found.names[i] : fmt::format("{} ({})", found.names[i], unit);
            }
            found.line = line->number;
            return found;
        }
        elsewhere(*line, last);
    }
    for (auto& unit : units) {
        unit = fmt::format("({})", bare_unit(unit));
    }
    return {std::move(units), false, false, units_line};
}

}  // namespace overturn
