// Where values come from: {value = ..., basis = "...", source = "...", range = [...]} in place of a value; of a whole
// table basis = "..." and source = "..." among its keys, or a table `basis` with an entry per key. An entry "assumed"
// may speak of a key that is left out: then its absence is what is assumed.
#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include <toml++/toml.h>

#include "config/detail/table_node.hpp"
#include "config/suggestion.hpp"

namespace overturn::config {
namespace {

constexpr std::array bases{Entry<Basis>{"published", "printed where others can read it", Basis::published},
                           Entry<Basis>{"measured", "measured by whoever states it", Basis::measured},
                           Entry<Basis>{"assumed", "neither", Basis::assumed}};
constexpr std::string_view others = "others";  // of a table `basis`: all keys that it does not name

// A distribution has a key `value` too, and is a table of its own.
bool is_with_origin(toml::node const& node) {
    auto const* table = node.as_table();
    return table != nullptr && table->contains("value") && !table->contains("distribution")
           && (table->contains("basis") || table->contains("source") || table->contains("range"));
}

// As people write it, on one line: texts without their quotes, numbers without digits that nobody stated.
std::string one_line(toml::node const& node) {
    std::string line;
    if (auto const* list = node.as_array()) {
        for (auto const& element : *list) {
            line += (line.empty() ? "" : ", ") + one_line(element);
        }
        return "[" + line + "]";
    }
    if (auto const* table = node.as_table()) {
        for (auto const& [key, value] : *table) {
            line += fmt::format("{}{} = {}", line.empty() ? "" : ", ", key.str(), one_line(value));
        }
        return "{" + line + "}";
    }
    if (auto const text = node.value_exact<std::string>()) {
        return *text;
    }
    if (auto const truth = node.value_exact<bool>()) {
        return *truth ? "true" : "false";
    }
    auto const number = node.value<double>();
    return number ? fmt::format("{}", *number) : "a date";
}

// The ends of a range, of a number held to it.
std::vector<std::string> range_of(toml::array const& ends, std::optional<double> number, Dimension dimension) {
    if (number) {
        double const low = quantity_of(*ends.get(0), dimension);
        double const high = quantity_of(*ends.get(1), dimension);
        validate(low <= *number && *number <= high, "{:.6g} outside its range ({:.6g} to {:.6g}). Mend one of them",
                 *number, low, high);
    }
    return {one_line(*ends.get(0)), one_line(*ends.get(1))};
}

}  // namespace

toml::node const* value_in(toml::node const* node) {
    return node != nullptr && is_with_origin(*node) ? node->as_table()->get("value") : node;
}

namespace {

// Reads statements of where values come from, each with its place.
class OriginReader {
  public:
    OriginReader(std::string file, std::string name) : file_(std::move(file)), name_(std::move(name)) {}

    [[noreturn]] void fail(toml::node const& at, std::string const& message) const {
        auto const begin = at.source().begin;
        throw InputError({file_, static_cast<int>(begin.line), static_cast<int>(begin.column)},
                         fmt::format("{}: {}", name_, message));
    }

    // "assumed", "published: PATRAM 2013"
    [[nodiscard]] Origin from_text(toml::node const& node) const {
        auto const text = node.value_exact<std::string>();
        if (!text) {
            fail(node, "basis is no text (must be published, measured or assumed). Put it in quotes");
        }
        auto const colon = text->find(':');
        auto const word = std::string(trimmed(std::string_view(*text).substr(0, colon)));
        Origin origin{.stated_at = &node};
        try {
            origin.basis = find_entry<Basis>(bases, word, "basis").value;
        } catch (InputError const& error) {
            fail(node, error.what());
        }
        if (colon != std::string::npos) {
            origin.source = std::string(trimmed(std::string_view(*text).substr(colon + 1)));
        }
        return origin;
    }

    void add_source(Origin& origin, toml::node const& node) const {
        auto const text = node.value_exact<std::string>();
        if (!text || text->empty()) {
            fail(node, "source is no text (must say where the value stands). Put it in quotes");
        }
        if (!origin.source.empty()) {
            fail(node, "source stated twice (behind the basis already). Keep one of them");
        }
        origin.source = *text;
    }

    // {basis = "...", source = "...", range = [...]}, with `value` where that is not stated elsewhere
    [[nodiscard]] Origin from_table(toml::table const& table) const {
        static std::vector<std::string> const known{"value", "basis", "source", "range"};
        for (auto const& [key, node] : table) {
            if (std::string_view const name = key.str(); nearest_name(name, known) != name) {
                fail(node, fmt::format("unknown key '{}' (beside a value stand basis, source and range). {}", name,
                                       suggestion(name, known)));
            }
        }
        if (!table.contains("basis")) {
            fail(table,
                 "no basis (its source or range is stated). Add basis = \"published\", \"measured\" or "
                 "\"assumed\"");
        }
        auto origin = from_text(*table.get("basis"));
        if (auto const* source = table.get("source")) {
            add_source(origin, *source);
        }
        if (auto const* range = table.get("range")) {
            auto const* ends = range->as_array();
            if (ends == nullptr || ends->size() != 2) {
                fail(*range, "range is no pair (must be the lowest and highest plausible value). Write [low, high]");
            }
            origin.range = ends;
        }
        return origin;
    }

    [[nodiscard]] Origin from_entry(toml::node const& node) const {
        return node.is_table() ? from_table(*node.as_table()) : from_text(node);
    }

  private:
    std::string file_, name_;
};

}  // namespace

std::string_view name_of(Basis basis) {
    constexpr std::array names{"published", "measured", "assumed", "not stated", "default"};
    return names.at(static_cast<std::size_t>(basis));
}

bool Table::Node::speaks_of_origin(std::string_view key) const {
    auto const* basis = table->get("basis");
    return basis != nullptr && (key == "basis" || (key == "source" && basis->is_string() && !used.contains(key)));
}

Origin Table::Node::origin_of(std::string_view key) const {
    auto const* node = table->get(key);
    OriginReader const reader(file, full(key));
    if (node != nullptr && is_with_origin(*node)) {
        return reader.from_table(*node->as_table());
    }
    auto const* basis = table->get("basis");
    if (basis == nullptr) {
        return inherited;
    }
    if (auto const* entries = basis->as_table()) {
        auto const* entry = entries->get(key);
        entry = entry != nullptr ? entry : entries->get(others);
        return entry == nullptr ? inherited : reader.from_entry(*entry);
    }
    OriginReader const own(file, full("basis"));
    auto origin = own.from_text(*basis);
    if (auto const* source = table->get("source"); source != nullptr && speaks_of_origin("source")) {
        own.add_source(origin, *source);
    }
    return origin;
}

Key const* Table::Node::left_out(std::string_view key) const {
    if (table->contains(key) || !asked.contains(key)) {
        return nullptr;
    }
    auto const found = descriptions(key);
    auto const at =
        std::ranges::find_if(found, [](Key const* one) { return one->absent.kind != Default::Kind::required; });
    return at == found.end() ? nullptr : *at;
}

void Table::Node::keep_left_out(Key const& key, Origin const& origin) const {
    bool const in_words = key.absent.kind == Default::Kind::in_words;
    InputValue kept{ledger_key(key.name), in_words ? std::string(key.absent.words) : "not stated", origin.basis,
                    origin.source};
    kept.file = file;
    kept.depth = depth;
    ledger->add_left_out(std::move(kept));
}

void Table::Node::check_origins() const {
    auto const* basis = table->get("basis");
    auto const* entries = basis == nullptr ? nullptr : basis->as_table();
    if (entries == nullptr) {
        (void)origin_of("basis");
        return;
    }
    std::vector<std::string> there;
    for (auto const& [key, node] : *table) {
        there.emplace_back(key.str());
    }
    OriginReader const reader(file, full("basis"));
    for (auto const& [key, node] : *entries) {
        std::string const name(key.str());
        auto const origin = OriginReader(file, full("basis." + name)).from_entry(node);
        if (auto const* absent = left_out(name);
            absent != nullptr && origin.basis == Basis::assumed && origin.range == nullptr) {
            keep_left_out(*absent, origin);
            continue;
        }
        if (name != others && (!table->contains(name) || name == "basis")) {
            auto const near = nearest_name(name, there);
            reader.fail(node, fmt::format("'{}' (no value of this table). {}", name,
                                          near.empty() ? "State its basis where the value stands"
                                                       : fmt::format("Did you mean '{}'?", near)));
        }
    }
}

std::shared_ptr<Table::Node> Table::Node::below(std::string_view key, toml::table const& inner,
                                                std::optional<std::size_t> place) const {
    auto const numbered = place ? fmt::format("{}[{}]", key, *place) : std::string(key);
    auto node = std::make_shared<Node>(Node{document, &inner, file, full(numbered)});
    node->ledger = ledger;
    node->ledger_path = ledger_key(numbered);
    node->depth = depth;
    node->described = tables_at(key);
    node->inherited = origin_of(key);
    validate(node->inherited.range == nullptr,
             "range of a table (it is each value that lies between two). State it "
             "there");
    return node;
}

void Table::Node::keep(std::string_view key, toml::node const& value, std::optional<double> number,
                       Dimension dimension) const {
    auto const origin = origin_of(key);
    bool const by_hand = value.source().begin.line == 0;  // --set, of which the file's word on the value is none
    bool const stated_by_hand = origin.stated_at != nullptr && origin.stated_at->source().begin.line == 0;
    InputValue kept{ledger_key(key), one_line(value), origin.basis, origin.source};
    if (by_hand && !stated_by_hand) {
        kept.basis = Basis::not_stated;
        kept.source = "--set";
    } else if (origin.range != nullptr) {
        validate(!value.is_array() && !value.is_boolean(),
                 "range of what is no number (nothing lies between). Remove "
                 "it");
        kept.range = range_of(*origin.range, number, dimension);
    }
    kept.number = number;
    kept.dimension = dimension;
    kept.file = file;
    kept.depth = depth;
    auto const& region = value.source();
    kept.span = {static_cast<int>(region.begin.line), static_cast<int>(region.begin.column),
                 static_cast<int>(region.end.line), static_cast<int>(region.end.column)};
    ledger->add(std::move(kept));
}

void Table::keep_default(std::string_view key, std::string text) const {
    InputValue kept{node_->ledger_key(key), std::move(text), Basis::by_default, ""};
    kept.file = node_->file;
    kept.depth = node_->depth;
    node_->ledger->add(std::move(kept));
}

std::vector<InputValue> Table::inputs() const { return node_->ledger->values(); }

Table Table::named_document(std::string_view text, std::string file) const {
    auto document = parse(text, std::move(file));
    document.node_->ledger = node_->ledger;
    document.node_->ledger_path = node_->ledger_path;
    document.node_->depth = node_->depth + 1;
    document.node_->described = node_->described;
    return document;
}

}  // namespace overturn::config
