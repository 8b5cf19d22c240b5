/// The price list of a room: one explicit table of named kinds, each with the line that `overturn list` prints.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "config/suggestion.hpp"
#include "core/error.hpp"

namespace overturn::config {

/// One line of a price list: what users write, what it is, and what makes it.
template <class Value> struct Entry {
    std::string_view name;
    std::string_view summary;
    Value value;
};

template <class Value> [[nodiscard]] std::vector<std::string> names_of(std::span<Entry<Value> const> entries) {
    std::vector<std::string> names;
    for (auto const& entry : entries) {
        names.emplace_back(entry.name);
    }
    return names;
}

/// The entry called `name`. \throws InputError with a suggestion if there is none; `what` names the kind in the
/// message.
template <class Value>
[[nodiscard]] Entry<Value> const& find_entry(std::span<Entry<Value> const> entries, std::string_view name,
                                             std::string_view what) {
    for (auto const& entry : entries) {
        if (entry.name == name) {
            return entry;
        }
    }
    throw InputError(fmt::format("{} '{}' (unknown). {}", what, name, suggestion(name, names_of(entries))));
}

}  // namespace overturn::config
