#include "motion/detail/numbered_names.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <string_view>

#include "core/units.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

using Text = std::string_view;

struct Entry {
    std::size_t number = 0;  ///< 0: it is none
    Text name;
};

/// "column 2: NS (gal)"
Entry entry_in(Text part) {
    constexpr auto words = std::to_array<Text>(
        {"columna", "column", "colonna", "colonne", "spalte", "col.", "col", "s\xC3\xBCtun", "\xE5\x88\x97"});
    part = trimmed(part.substr(std::min(part.find_first_not_of(" \t#%!*-"), part.size())));
    auto const lower = lowered(part);
    auto const* const word = std::ranges::find_if(words, [&](Text each) { return lower.starts_with(each); });
    if (word == words.end()) {
        return {};
    }
    auto rest = trimmed(part.substr(word->size()));
    auto const end = std::min(rest.find_first_not_of("0123456789"), rest.size());
    constexpr std::size_t most = 2;  // digits
    if (end == 0 || end > most) {
        return {};
    }
    std::size_t number = 0;
    for (char const c : rest.substr(0, end)) {
        number = 10 * number + static_cast<std::size_t>(c - '0');
    }
    rest = rest.substr(end);
    auto const name = trimmed(rest.substr(std::min(rest.find_first_not_of(" \t:=.)-"), rest.size())));
    return name.empty() ? Entry{} : Entry{number, name};
}

}  // namespace

NumberedNames numbered_names(TextTable const& table) {
    std::map<std::size_t, std::string> found;
    NumberedNames numbered;
    for (auto const* lines : {&table.head, &table.notes}) {
        for (auto const& line : *lines) {
            for (auto const part : parted_at(line.text, ",;|")) {
                auto const [number, name] = entry_in(part);
                if (number == 0) {
                    continue;
                }
                numbered.lines.push_back(line.number);
                auto const [at, fresh] = found.try_emplace(number, name);
                if (!fresh && at->second != name) {
                    return {};
                }
            }
        }
    }
    for (auto const& [number, name] : found) {
        if (number != numbered.names.size() + 1) {
            return {};
        }
        numbered.names.push_back(name);
    }
    return numbered;
}

}  // namespace overturn
