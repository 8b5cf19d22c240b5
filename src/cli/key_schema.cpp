// A JSON schema for editors: what a key takes, word for word; what several keys say together is left to the program.
#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "campaign/withdrawn_keys.hpp"
#include "cli/key_list.hpp"

namespace overturn::cli {
namespace {

using config::Default;
using config::Form;
using config::Key;
using config::KeyTable;

// How a number may be written in quotes (parse_number of core/units).
constexpr std::string_view number_pattern = R"(^\s*[+-]?(\d+\.?\d*|\.\d+)([eEdD][+-]?\d+)?)";

// Units in capitals and small letters, as the program takes them.
std::string unit_pattern(Dimension dimension) {
    std::string pattern;
    for (char const c : accepted_units(dimension) + ",") {
        auto const lower = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
        if (lower >= 'a' && lower <= 'z') {
            pattern += fmt::format("[{}{}]", lower, static_cast<char>(lower - 'a' + 'A'));
        } else if (c == ',') {
            pattern += '|';
        } else if (c == '*' || c == '^' || c == '/') {
            pattern += fmt::format("[{}{}]", c == '^' ? "\\" : "", c);
        } else if (c != ' ' || pattern.empty() || pattern.back() != '|') {
            pattern += c;  // the blank behind a comma is none of a unit
        }
    }
    pattern.pop_back();
    return pattern;
}

class SchemaWriter {
  public:
    explicit SchemaWriter(KeyTable const& root) : root_(root) {
        for (auto const& placed : tables_within(root)) {
            auto const& place = placed.places.front();
            auto const word = place.condition.substr(std::min(place.condition.size(), place.condition.find(" = ") + 3));
            names_[placed.table] = place.condition.empty() ? place.path : fmt::format("{}-{}", place.path, word);
            order_.push_back(placed.table);
        }
    }

    [[nodiscard]] Json schema() {
        Json whole{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                   {"title", std::string("overturn: ") + std::string(root_.meaning)}};
        whole.update(object(root_));
        Json definitions;
        for (auto const* table : order_) {
            if (table != &root_) {
                definitions[names_.at(table)] = object(*table);
            }
        }
        definitions["basis"] = {{"type", "string"}, {"pattern", "^\\s*(published|measured|assumed)\\s*(:.*)?$"}};
        for (auto const& [name, dimension] : quantities_) {
            auto const unit =
                dimension == Dimension::none ? "" : fmt::format("([ \\t]+({}))?", unit_pattern(dimension));
            definitions[name] = {{"type", "string"}, {"pattern", fmt::format("{}{}\\s*$", number_pattern, unit)}};
        }
        definitions["any-quantity"] = {{"type", "string"},
                                       {"pattern", fmt::format("{}([ \\t]+\\S.*)?$", number_pattern)}};
        whole["$defs"] = std::move(definitions);
        return whole;
    }

  private:
    [[nodiscard]] static Json reference(std::string const& name) { return {{"$ref", "#/$defs/" + name}}; }

    // A number in SI, and the same with a unit, in quotes.
    [[nodiscard]] std::vector<Json> numbers(Key const& key, Dimension dimension, bool ranged) {
        Json bare{{"type", "number"}};
        if (ranged && key.dimension_of.empty()) {
            if (std::isfinite(key.range.low)) {
                bare[key.range.low_open ? "exclusiveMinimum" : "minimum"] = key.range.low;
            }
            if (std::isfinite(key.range.high)) {
                bare[key.range.high_open ? "exclusiveMaximum" : "maximum"] = key.range.high;
            }
        }
        if (!key.dimension_of.empty()) {
            return {bare, reference("any-quantity")};
        }
        std::string name(name_of(dimension));
        std::ranges::replace(name, ' ', '-');  // what refers to it is part of an address
        quantities_[name] = dimension;
        return {bare, reference(name)};
    }

    [[nodiscard]] static Json any_of(std::vector<Json> ways) {
        return ways.size() == 1 ? std::move(ways.front()) : Json{{"anyOf", std::move(ways)}};
    }

    [[nodiscard]] static Json words_of(Key const& key) {
        Json words{{"type", "string"}, {"enum", Json::array()}};
        for (auto const& word : key.words()) {
            words["enum"].push_back(word.name);
        }
        return words;
    }

    [[nodiscard]] std::vector<Json> plain(Key const& key) {
        std::vector<Json> ways;
        if (key.takes(Form::number)) {
            ways = numbers(key, key.dimension, true);
        }
        if (key.takes(Form::integer)) {
            ways.push_back({{"type", "integer"}, {"minimum", key.least}, {"maximum", key.most}});
        }
        if (key.takes(Form::boolean)) {
            ways.push_back({{"type", "boolean"}});
        }
        if (key.takes(Form::word)) {
            ways.push_back(words_of(key));
        }
        if (key.takes(Form::text)) {
            ways.push_back({{"type", "string"}});
        }
        if (key.takes(Form::numbers)) {
            ways.push_back({{"type", "array"}, {"items", any_of(numbers(key, key.dimension, true))}});
        }
        if (key.takes(Form::pairs)) {
            ways.push_back({{"type", "array"},
                            {"items",
                             {{"type", "array"},
                              {"prefixItems", Json::array({any_of(numbers({}, key.first, false)),
                                                           any_of(numbers(key, key.dimension, false))})},
                              {"minItems", 2},
                              {"maxItems", 2}}}});
        }
        if (key.takes(Form::texts)) {
            ways.push_back(
                {{"type", "array"}, {"items", key.words == nullptr ? Json{{"type", "string"}} : words_of(key)}});
        }
        return ways;
    }

    // {value = ..., basis = "...", source = "...", range = [low, high]} in place of a plain value.
    [[nodiscard]] static Json with_origin(std::vector<Json> const& values) {
        Json const end{{"type", Json::array({"number", "string"})}};
        return {{"type", "object"},
                {"properties",
                 {{"value", any_of(values)},
                  {"basis", reference("basis")},
                  {"source", {{"type", "string"}}},
                  {"range", {{"type", "array"}, {"items", end}, {"minItems", 2}, {"maxItems", 2}}}}},
                {"required", {"value", "basis"}},
                {"additionalProperties", false}};
    }

    [[nodiscard]] Json property(Key const& key) {
        auto ways = plain(key);
        if (!ways.empty()) {
            ways.push_back(with_origin(ways));
        }
        for (auto const* table : key.tables == nullptr ? std::vector<KeyTable const*>{} : key.tables()) {
            auto one = reference(names_.at(table));
            ways.push_back(key.takes(Form::tables) ? Json{{"type", "array"}, {"items", one}} : one);
        }
        Json described{
            {"description", fmt::format("{} [{}; {}]", meaning_text(key), takes_text(key), absent_text(key))}};
        described.update(any_of(std::move(ways)));
        return described;
    }

    [[nodiscard]] Json object(KeyTable const& table) {
        Json properties;
        auto required = Json::array();
        for (auto const* key : listed_keys(table)) {
            properties[std::string(key->name)] = property(*key);
            if (key->absent.kind == Default::Kind::required && key->where.empty()) {
                required.push_back(key->name);
            }
            if (!table.word.empty() && key->name == table.chosen_by) {
                properties[std::string(key->name)] = {{"const", table.word}};
            }
        }
        // Where this table's values come from.
        properties["basis"] = {{"anyOf", Json::array({reference("basis"), {{"type", "object"}}})}};
        if (!properties.contains("source")) {
            properties["source"] = {{"type", "string"}};
        }
        return {{"description", table.meaning},
                {"type", "object"},
                {"properties", std::move(properties)},
                {"required", std::move(required)},
                {"additionalProperties", false}};
    }

    KeyTable const& root_;
    std::map<KeyTable const*, std::string> names_;
    std::vector<KeyTable const*> order_;
    std::map<std::string, Dimension> quantities_;
};

// The keys of a table, and of the tables among the definitions, stand on lines of their own.
constexpr int deepest_lines = 4;

void write_lines(Json const& value, int depth, std::string& text) {
    if (!value.is_object() || value.empty() || depth == deepest_lines) {
        text += value.dump();
        return;
    }
    std::string const indent(depth + 1, ' ');
    std::string_view before = "{\n";
    for (auto const& [name, inner] : value.items()) {
        text += fmt::format("{}{}{}: ", before, indent, Json(name).dump());
        write_lines(inner, depth + 1, text);
        before = ",\n";
    }
    text += "\n" + indent.substr(1) + "}";
}

}  // namespace

Json keys_schema(KeyTable const& root) { return SchemaWriter(root).schema(); }

std::string schema_text(Json const& schema) {
    std::string text;
    write_lines(schema, 0, text);
    return text + "\n";
}

}  // namespace overturn::cli
