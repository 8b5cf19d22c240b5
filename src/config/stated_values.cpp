#include "config/stated_values.hpp"

#include <sstream>

#include <fmt/format.h>
#include <toml++/toml.h>

#include "config/detail/settings.hpp"
#include "core/error.hpp"

namespace overturn::config {
namespace {

using Values = std::map<std::string, std::string>;

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
    std::ostringstream out;
    node.visit([&](auto const& value) { out << value; });
    return out.str();
}

void collect(toml::node const& node, std::string const& path, Values& values);

std::string name_in(toml::array const& list, std::size_t place) {
    return (*list.get_as<toml::table>(place))["name"].value<std::string>().value_or(fmt::format("{}", place + 1));
}

void collect_tables(toml::array const& list, std::string const& path, Values& values) {
    std::string order;
    for (std::size_t i = 0; i < list.size(); ++i) {
        auto const name = name_in(list, i);
        order += (i > 0 ? ", " : "") + name;
        collect(*list.get(i), below(path, name), values);
    }
    values[path] = order;
}

void collect(toml::node const& node, std::string const& path, Values& values) {
    if (auto const* const table = node.as_table()) {
        for (auto const& [key, each] : *table) {
            collect(each, below(path, key.str()), values);
        }
    } else if (auto const* const list = node.as_array(); list != nullptr && list->is_array_of_tables()) {
        collect_tables(*list, path, values);
    } else {
        values[path] = text_of(node);
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

std::map<std::string, std::string> stated_values(std::string_view text, std::string const& file,
                                                 std::span<std::string const> settings) {
    Values values;
    collect(document_of(text, file, settings), "", values);
    return values;
}

std::vector<std::string> names_in_list(std::string_view text, std::string const& file,
                                       std::span<std::string const> settings, std::string_view list) {
    auto const document = document_of(text, file, settings);
    auto const* const tables = document[list].as_array();
    std::vector<std::string> names;
    for (std::size_t i = 0; tables != nullptr && tables->is_array_of_tables() && i < tables->size(); ++i) {
        names.push_back(name_in(*tables, i));
    }
    return names;
}

}  // namespace overturn::config
