// All of a table that is not as it is described, found without its readers: each value is read as its key says.
#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "config/detail/key_value.hpp"
#include "config/detail/table_node.hpp"

namespace overturn::config {
namespace {

using Text = std::string_view;

/// Takes `word` off the beginning of `text`.
bool take(Text& text, Text word) {
    if (!text.starts_with(word)) {
        return false;
    }
    text.remove_prefix(word.size());
    return true;
}

Text take_word(Text& text) {
    auto const word = text.substr(0, text.find(' '));
    text.remove_prefix(word.size());
    return word;
}

/// What stands at `key`, or its default, as a text.
std::string text_at(toml::table const& table, Key const& key) {
    auto const* node = value_in(table.get(key.name));
    return node == nullptr ? std::string(key.absent.words) : node->value_or(std::string());
}

Key const* key_in(std::span<KeyTable const* const> tables, Text name) {
    for (auto const* table : tables) {
        if (auto const* key = table->find(name)) {
            return key;
        }
    }
    return nullptr;
}

/// Is one of two keys needed, and either will do?
bool is_instead_of(Text where, Text key) { return where.starts_with("there ") && where.find(key) != Text::npos; }

/// "there is no file and no parts", "kind = cylinder or box", "file is stated"; nothing of other conditions.
std::optional<bool> is_met(Key const& of, toml::table const& table, std::span<KeyTable const* const> tables) {
    auto where = of.where;
    if (where.empty()) {
        return true;
    }
    if (take(where, "there is no ")) {
        bool absent = true;
        do {
            auto const key = take_word(where);
            auto const* other = key_in(tables, key);
            if (other == nullptr || is_instead_of(other->where, of.name)) {
                return std::nullopt;
            }
            absent = absent && !table.contains(key);
        } while (take(where, " and no "));
        return where.empty() ? std::optional(absent) : std::nullopt;
    }
    auto const name = take_word(where);
    auto const* key = key_in(tables, name);
    if (key == nullptr) {
        return std::nullopt;
    }
    if (where == " is stated") {
        return table.contains(name);
    }
    if (!take(where, " = ")) {
        return std::nullopt;
    }
    auto const stated = text_at(table, *key);
    bool met = false;
    do {
        met = take_word(where) == stated || met;
    } while (take(where, " or "));
    return where.empty() ? std::optional(met) : std::nullopt;
}

/// Tables that may stand here, by the key that distinguishes them.
std::vector<KeyTable const*> narrowed(std::vector<KeyTable const*> const& tables, toml::table const& table) {
    std::vector<KeyTable const*> chosen;
    for (auto const* one : tables) {
        auto const* by = one->chosen_by.empty() ? nullptr : one->find(one->chosen_by);
        if (by != nullptr && text_at(table, *by) == one->word) {
            chosen.push_back(one);
        }
    }
    return chosen.empty() ? tables : chosen;
}

bool is_required(KeyTable const& described, Text key, toml::table const& table) {
    auto const* found = described.find(key);
    std::array const tables{&described};
    return found != nullptr && found->absent.kind == Default::Kind::required
           && is_met(*found, table, tables).value_or(false);
}

}  // namespace

/// Looks through a table and those within it.
class Table::FaultFinder {
  public:
    [[nodiscard]] std::vector<Fault> take() { return std::move(faults_); }

    void look_through(std::shared_ptr<Node> const& from) {
        if (from->described.empty()) {
            return;
        }
        Table const table(blank_copy(*from));
        auto& node = *table.node_;
        catching(node.locate(nullptr), [&] { node.table->contains("basis") ? node.check_origins() : void(); });
        std::vector<std::string> unknown;
        for (auto const& [key, value] : *node.table) {
            auto const found = node.descriptions(key.str());
            if (!found.empty()) {
                look_at(table, key.str(), value, found);
            } else if (!node.speaks_of_origin(key.str())) {
                unknown.emplace_back(key.str());
            }
        }
        tell_missing(table, unknown);
        for (auto const& key : unknown) {
            faults_.push_back({node.locate(node.table->get(key)), false, node.unknown_key(key)});
        }
    }

  private:
    /// As `from` before anything was read, with a ledger that nobody looks at.
    static std::shared_ptr<Node> blank_copy(Node const& from) {
        auto node = std::make_shared<Node>(from);
        node->ledger = std::make_shared<Ledger>();
        node->described = narrowed(from.described, *from.table);
        node->used.clear();
        node->asked.clear();
        node->complete = true;
        for (auto const* described : node->described) {
            for (auto const* key : described->every_key()) {
                node->asked.emplace(key->name);
            }
        }
        return node;
    }

    template <class Read> bool catching(Location const& where, Read&& read) {
        try {
            read();
            return true;
        } catch (InputError const& error) {
            faults_.push_back({where, false, error.what()});
            return false;
        }
    }

    void look_at(Table const& table, Text key, toml::node const& node, std::vector<Key const*> const& found) {
        auto const* value = value_in(&node);
        auto const where = table.node_->locate(&node);
        // Of several descriptions that might be meant, one that the value meets will do.
        bool const fits = std::ranges::any_of(found, [&](Key const* one) {
            try {
                read_value(table, *one, *value);
                return true;
            } catch (InputError const&) {
                return false;
            }
        });
        if (!fits) {
            (void)catching(where, [&] { read_value(table, *found.front(), *value); });
            return;
        }
        if (value->is_table() && std::ranges::any_of(found, [](Key const* one) { return one->takes(Form::table); })) {
            look_through(table.child(key).node_);
        } else if (value->is_array()
                   && std::ranges::any_of(found, [](Key const* one) { return one->takes(Form::tables); })) {
            for (auto const& inner : table.children(key)) {
                look_through(inner.node_);
            }
        }
    }

    void tell_missing(Table const& table, std::vector<std::string>& unknown) {
        auto const& node = *table.node_;
        for (auto const* key : node.described.front()->every_key()) {
            bool const required = std::ranges::all_of(node.described, [&](KeyTable const* described) {
                return is_required(*described, key->name, *node.table);
            });
            if (!required || node.table->contains(key->name)) {
                continue;
            }
            auto const misspelt = nearest_name(key->name, unknown);
            auto const where = node.locate(misspelt.empty() ? nullptr : node.table->get(misspelt));
            try {
                table.fail_missing(key->name);
            } catch (InputError const& error) {
                faults_.push_back({where, misspelt.empty(), error.what()});
            }
            std::erase(unknown, misspelt);
        }
    }

    std::vector<Fault> faults_;
};

std::vector<Fault> Table::faults() const {
    FaultFinder finder;
    finder.look_through(node_);
    auto faults = finder.take();
    std::ranges::stable_sort(faults, {}, [](Fault const& one) { return std::pair(one.where.line, one.where.column); });
    return faults;
}

}  // namespace overturn::config
