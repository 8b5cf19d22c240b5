#include "config/stated_values.hpp"

#include <optional>
#include <sstream>
#include <utility>

#include <fmt/format.h>
#include <toml++/toml.h>

#include "config/detail/settings.hpp"
#include "config/detail/table_node.hpp"
#include "core/error.hpp"
#include "core/units.hpp"

namespace overturn::config {
namespace {

using Values = StatedValues;

std::string below(std::string const& path, std::string_view key) {
    return path.empty() ? std::string(key) : fmt::format("{}.{}", path, key);
}

// Numbers by the fewest digits that distinguish them.
std::string text_of(toml::node const& node) {
    if (auto const* const list = node.as_array()) {
        std::string text;
        for (auto const& each : *list) {
            text += (text.empty() ? "[" : ", ") + text_of(each);
        }
        return text.empty() ? "[]" : text + "]";
    }
    if (auto const* const number = node.as_floating_point()) {
        return fmt::format("{}", number->get());
    }
    if (auto const* const number = node.as_integer()) {
        return fmt::format("{}", number->get());
    }
    std::ostringstream out;
    node.visit([&](auto const& value) { out << value; });
    return out.str();
}

// A number in quotes stays a text: it may be a name.
std::string normal_of(toml::node const& node) {
    if (auto const* const list = node.as_array()) {
        std::string text;
        for (auto const& each : *list) {
            text += (text.empty() ? "[" : ", ") + normal_of(each);
        }
        return text.empty() ? "[]" : text + "]";
    }
    auto const* const stated = node.as_string();
    auto const quantity = stated != nullptr ? quantity_with_unit(stated->get()) : std::nullopt;
    return quantity ? fmt::format("{}", *quantity) : text_of(node);
}

/// Where in a file a value lies: as it is compared, and as a person names it.
struct Place {
    std::string path, key, inside;  ///< "bodies.type-b.friction", "bodies[1].friction", "type-b"

    [[nodiscard]] Place at(std::string_view name) const { return {below(path, name), below(key, name), inside}; }
    [[nodiscard]] Place entry(std::size_t number, std::string const& name) const {
        auto const plain = fmt::format("{}", number);
        return {below(path, name), fmt::format("{}[{}]", key, number), name == plain ? inside : name};
    }
};

void collect(toml::node const& stated, Place const& place, Values& values);

std::string name_in(toml::array const& list, std::size_t place) {
    return (*list.get_as<toml::table>(place))["name"].value<std::string>().value_or(fmt::format("{}", place));
}

void put(std::string const& text, std::string const& normal, Place const& place, Values& values) {
    values[place.path] = {text, normal,
                          place.inside.empty() ? place.key : fmt::format("{} ({})", place.key, place.inside)};
}

void collect_tables(toml::array const& list, Place const& place, Values& values) {
    std::string order;
    for (std::size_t i = 0; i < list.size(); ++i) {
        auto const name = name_in(list, i);
        order += (i > 0 ? ", " : "") + name;
        collect(*list.get(i), place.entry(i, name), values);
    }
    put(order, order, place, values);
}

// Says where values come from: `basis`, and beside a basis in words `source`, which [waves] has as a key of its own.
bool is_origin(toml::table const& table, std::string_view key, Place const& place) {
    auto const* const basis = table.get("basis");
    return basis != nullptr && (key == "basis" || (key == "source" && basis->is_string() && place.path != "waves"));
}

void collect(toml::node const& stated, Place const& place, Values& values) {
    auto const& node = *value_in(&stated);
    if (auto const* const table = node.as_table()) {
        for (auto const& [key, each] : *table) {
            if (!is_origin(*table, key.str(), place)) {
                collect(each, place.at(key.str()), values);
            }
        }
    } else if (auto const* const list = node.as_array(); list != nullptr && list->is_array_of_tables()) {
        collect_tables(*list, place, values);
    } else {
        put(text_of(node), normal_of(node), place, values);
    }
}

toml::table document_of(std::string_view text, std::string const& file, std::span<std::string const> settings) {
    toml::table document;
    try {
        document = toml::parse(text, file);
    } catch (toml::parse_error const& error) {
        auto const begin = error.source().begin;
        throw InputError({file, static_cast<int>(begin.line), static_cast<int>(begin.column)},
                         fmt::format("{} (not valid TOML). Mend the line", error.description()));
    }
    for (auto const& setting : settings) {
        apply_setting(document, setting);
    }
    return document;
}

}  // namespace

StatedValues stated_values(std::string_view text, std::string const& file, std::span<std::string const> settings) {
    Values values;
    collect(document_of(text, file, settings), {}, values);
    return values;
}

std::vector<StatedValues> stated_entries(std::string_view text, std::string const& file,
                                         std::span<std::string const> settings, std::string_view list) {
    auto const document = document_of(text, file, settings);
    std::vector<StatedValues> entries;
    if (auto const* const nodes = document.at_path(list).as_array()) {
        for (std::size_t i = 0; i < nodes->size(); ++i) {
            Values values;
            collect(*nodes->get(i), {"", fmt::format("{}[{}]", list, i), ""}, values);
            entries.push_back(std::move(values));
        }
    }
    return entries;
}

std::string text_at(StatedValues const& values, std::string const& key) {
    auto const found = values.find(key);
    if (found == values.end()) {
        return {};
    }
    auto const& text = found->second.text;
    bool const quoted = text.size() > 1 && text.front() == text.back() && (text[0] == '\'' || text[0] == '"');
    return quoted ? text.substr(1, text.size() - 2) : text;
}

}  // namespace overturn::config
