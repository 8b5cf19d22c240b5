/// Implementation of Table: only the sources of table.hpp include it.
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <toml++/toml.h>

#include "config/detail/ledger.hpp"
#include "config/table.hpp"
#include "core/error.hpp"

namespace overturn::config {

/// Origin of a value, as far as a file states it.
struct Origin {
    Basis basis = Basis::not_stated;
    std::string source = {};
    toml::array const* range = nullptr;     ///< of a single value: two plausible ends
    toml::node const* stated_at = nullptr;  ///< place of this statement
};

/// A number, or a text such as "1.5 t". \throws InputError
[[nodiscard]] double quantity_of(toml::node const& node, Dimension dimension);

/// The value itself of one that is written with its origin, {value = 0.5, basis = "measured", source = "..."}.
[[nodiscard]] toml::node const* value_in(toml::node const* node);

/// A view of one toml table. The root node owns the document; children keep their parent, hence the document, alive.
struct Table::Node {
    std::shared_ptr<toml::table> document;
    toml::table const* table = nullptr;
    std::string file;
    std::string path;  // "waves.target", "bodies[1]"; empty at the root
    std::set<std::string, std::less<>> used = {};
    bool complete = false;  // `asked` holds every key there may be
    std::set<std::string, std::less<>> asked =
        {};  // also optional keys that are absent: what a misspelt key may have meant
    std::shared_ptr<Ledger> ledger = {};
    std::string ledger_path = {};                 // as `path`, of a file that a table names below that table
    int depth = 0;                                // of files that name files
    Origin inherited = {};                        // of every value that states no other origin
    std::vector<KeyTable const*> described = {};  // one of them says what keys there are; empty: nothing does

    [[nodiscard]] toml::node const* find(std::string_view key) {
        asked.emplace(key);
        auto const* found = table->get(key);
        if (found != nullptr) {
            used.emplace(key);
        }
        return value_in(found);
    }
    [[nodiscard]] Location locate(toml::node const* at) const {
        auto const begin = (at != nullptr ? at : static_cast<toml::node const*>(table))->source().begin;
        return {file, static_cast<int>(begin.line), static_cast<int>(begin.column)};
    }
    [[nodiscard]] std::string full(std::string_view key) const {
        return path.empty() || key.empty() ? fmt::format("{}{}", path, key) : fmt::format("{}.{}", path, key);
    }
    [[nodiscard]] std::string ledger_key(std::string_view key) const {
        return ledger_path.empty() ? std::string(key) : fmt::format("{}.{}", ledger_path, key);
    }

    /// A table of this document below `key`. \param place its number in a list of them
    [[nodiscard]] std::shared_ptr<Node> below(std::string_view key, toml::table const& inner,
                                              std::optional<std::size_t> place) const;
    /// \throws InputError where an origin is wrongly stated
    [[nodiscard]] Origin origin_of(std::string_view key) const;
    /// Descriptions of `key`: several where several tables may stand in this place.
    [[nodiscard]] std::vector<Key const*> descriptions(std::string_view key) const;
    /// The tables that may stand at `key`, as far as they are described.
    [[nodiscard]] std::vector<KeyTable const*> tables_at(std::string_view key) const;
    /// "target.longest": where a table in this one has a key of just this name, if one alone has; else empty.
    [[nodiscard]] std::string further_down(std::string_view key) const;
    /// Message that `key`, which stands in this table, is unknown, with its place and what may have been meant.
    [[nodiscard]] std::string unknown_key(std::string_view key) const;
    /// \throws ContractError unless `key` may be read so, in developers' builds. \param dimension, range of a number
    void check_read(std::string_view key, Form form, std::optional<Dimension> dimension = {},
                    std::optional<Range> range = {}) const;
    /// \throws ContractError unless an absent `key` may count as this, in developers' builds
    void check_default(std::string_view key, Default const& taken) const;
    /// Keeps a value that was read. \param number [SI] if it is one. \throws InputError as origin_of
    void keep(std::string_view key, toml::node const& value, std::optional<double> number, Dimension dimension) const;
    /// Is `key` no value but says where this table's values come from?
    [[nodiscard]] bool speaks_of_origin(std::string_view key) const;
    /// The description of a key that was left out, whose absence means something; none of any other.
    [[nodiscard]] Key const* left_out(std::string_view key) const;
    /// Keeps a key that was left out and of which this table says that its absence is assumed.
    void keep_left_out(Key const& key, Origin const& origin) const;
    /// \throws InputError where this table's own word on origins names no basis, or a key that is neither there nor
    /// left out by assumption
    void check_origins() const;
};

}  // namespace overturn::config
