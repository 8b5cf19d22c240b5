// The side of a Table that watches: where keys stand, which are missing, which nobody read, in which unit they are.
#include <algorithm>
#include <string>
#include <vector>

#include <toml++/toml.h>

#include "config/detail/table_node.hpp"
#include "config/suggestion.hpp"
#include "core/units.hpp"

namespace overturn::config {

Location Table::where(std::string_view key) const {
    return node_->locate(key.empty() ? nullptr : node_->table->get(key));
}

void Table::fail(std::string_view key, std::string_view message) const {
    auto const name = node_->full(key);
    // A message that already names its file came from deeper down and says it better.
    if (message.starts_with(node_->file + ":")) {
        throw InputError(std::string(message));
    }
    throw InputError(where(key), name.empty() ? std::string(message) : fmt::format("{}: {}", name, message));
}

void Table::may_have(std::initializer_list<std::string_view> keys) const {
    node_->complete = true;
    for (auto const key : keys) {
        node_->asked.emplace(key);
    }
}

void Table::fail_missing(std::string_view key, std::string_view advice) const {
    std::vector<std::string> unread;
    std::string unknown;
    for (auto const& [there, node] : *node_->table) {
        bool const known = node_->complete && node_->asked.contains(there.str());
        if (!node_->used.contains(there.str()) && !known && !node_->speaks_of_origin(there.str())) {
            unread.emplace_back(there.str());
            unknown += fmt::format("{}'{}'", unknown.empty() ? "" : ", ", there.str());
        }
    }
    if (auto const near = nearest_name(key, unread); !near.empty()) {
        fail(near, fmt::format("unknown key (nothing reads it, and '{0}' is missing). Did you mean '{0}'?", key));
    }
    if (node_->complete && !unknown.empty()) {
        fail(key, fmt::format("missing (there is no default; {} is no key here). {}", unknown, advice));
    }
    fail(key, fmt::format("missing (there is no default). {}", advice));
}

namespace {

// Depth first, in the order of the text.
std::string first_unit(toml::node const& node) {
    if (auto const text = node.value_exact<std::string>()) {
        auto const quantity = trimmed(*text);
        auto const blank = quantity.find_first_of(" \t");
        double value = 0;
        bool const is_one = blank != std::string_view::npos && parse_number(quantity.substr(0, blank), value);
        return is_one ? std::string(trimmed(quantity.substr(blank))) : std::string();
    }
    std::string unit;
    if (auto const* list = node.as_array()) {
        for (auto const& element : *list) {
            unit = unit.empty() ? first_unit(element) : unit;
        }
    } else if (auto const* table = node.as_table()) {
        for (auto const& [key, element] : *table) {
            bool const of_origin = key.str() == "basis" || key.str() == "source";  // "2013 PATRAM" has no unit
            unit = unit.empty() && !of_origin ? first_unit(element) : unit;
        }
    }
    return unit;
}

bool holds_bare_number(toml::node const& node) {
    if (auto const text = node.value_exact<std::string>()) {
        double value = 0;
        return parse_number(trimmed(*text), value);
    }
    if (auto const* list = node.as_array()) {
        return std::any_of(list->begin(), list->end(), holds_bare_number);
    }
    if (auto const* table = node.as_table()) {
        return std::any_of(table->begin(), table->end(), [](auto const& entry) {
            return entry.first.str() != "count" && holds_bare_number(entry.second);
        });
    }
    return node.is_number();
}

}  // namespace

bool Table::is_bare_at(std::string_view key) const {
    auto const* node = value_in(node_->table->get(key));
    return node != nullptr && holds_bare_number(*node);
}

std::string Table::unit_at(std::string_view key) const {
    auto const* node = value_in(node_->table->get(key));
    return node == nullptr ? std::string() : first_unit(*node);
}

std::string Table::Node::unknown_key(std::string_view key) const {
    std::vector<std::string> const known(asked.begin(), asked.end());
    auto near = nearest_name(key, known);
    if (auto const below = further_down(key); near.empty() && !below.empty()) {
        near = full(below);
    }
    return fmt::format(
        "{}unknown key '{}' (nothing reads it{}). {}", locate(table->get(key)).prefix(), full(key),
        near.empty() ? " here" : "",
        near.empty() ? std::string("Remove it or check its spelling") : fmt::format("Did you mean '{}'?", near));
}

void Table::finish() const {
    if (node_->table->contains("basis")) {
        node_->check_origins();
    }
    for (auto const& [key, node] : *node_->table) {
        if (node_->used.contains(key.str()) || node_->speaks_of_origin(key.str())) {
            continue;
        }
        auto const described = node_->descriptions(key.str());
        auto const conditional = std::ranges::find_if(described, [](Key const* one) { return !one->where.empty(); });
        if (conditional != described.end()) {
            throw InputError(
                node_->locate(&node),
                fmt::format("key '{}' (not used here: only if {}). Remove it, or the key that overrides it",
                            node_->full(key.str()), (*conditional)->where));
        }
        if (node_->complete && node_->asked.contains(key.str())) {
            throw InputError(
                node_->locate(&node),
                fmt::format("key '{}' (not used with the other keys here). Remove it, or the key that overrides it",
                            node_->full(key.str())));
        }
        throw InputError(node_->unknown_key(key.str()));
    }
}

}  // namespace overturn::config
