/// What stands behind a Table: seen by the sources of table.hpp only.
#pragma once

#include <memory>
#include <set>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <toml++/toml.h>

#include "config/table.hpp"
#include "core/error.hpp"

namespace overturn::config {

/// A view of one toml table. The root node owns the document; children keep their parent, hence the document, alive.
struct Table::Node {
    std::shared_ptr<toml::table> document;
    toml::table const* table = nullptr;
    std::string file;
    std::string path;  // "waves.target", "bodies[1]"; empty at the root
    std::set<std::string, std::less<>> used;
    bool complete = false;                     // `asked` holds every key there may be
    std::set<std::string, std::less<>> asked;  // also optional keys that are absent: what a misspelt key may have meant

    [[nodiscard]] toml::node const* find(std::string_view key) {
        asked.emplace(key);
        auto const* found = table->get(key);
        if (found != nullptr) {
            used.emplace(key);
        }
        return found;
    }
    [[nodiscard]] Location locate(toml::node const* at) const {
        auto const begin = (at != nullptr ? at : static_cast<toml::node const*>(table))->source().begin;
        return {file, static_cast<int>(begin.line), static_cast<int>(begin.column)};
    }
    [[nodiscard]] std::string full(std::string_view key) const {
        return path.empty() || key.empty() ? fmt::format("{}{}", path, key) : fmt::format("{}.{}", path, key);
    }
};

}  // namespace overturn::config
