#include <algorithm>

#include "core/units.hpp"
#include "motion/text_table.hpp"

namespace overturn {
namespace {

using Text = std::string_view;

std::string without_quotes(Text name) {
    std::string plain(trimmed(name));
    std::erase(plain, '"');
    return std::string(trimmed(plain));
}

std::vector<std::string> parted_by(Text line, Text separator) {
    std::vector<std::string> names;
    for (bool more = true; more;) {
        auto const end = line.find(separator);
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

}  // namespace overturn
