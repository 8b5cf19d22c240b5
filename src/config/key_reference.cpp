#include "config/key_reference.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "config/suggestion.hpp"

namespace overturn::config {
namespace {

void visit(KeyTable const& table, TablePlace const& place, std::vector<PlacedTable>& found) {
    auto const known = std::ranges::find(found, &table, &PlacedTable::table);
    if (known == found.end()) {
        found.push_back({&table, {place}});
    } else {
        known->places.push_back(place);
    }
    for (auto const* key : table.every_key()) {
        if (key->tables == nullptr) {
            continue;
        }
        auto const path = place.path.empty() ? std::string(key->name) : fmt::format("{}.{}", place.path, key->name);
        for (auto const* inner : key->tables()) {
            auto const condition =
                inner->word.empty() ? place.condition : fmt::format("{}.{} = {}", path, inner->chosen_by, inner->word);
            visit(*inner, {path, key->takes(Form::tables), condition}, found);
        }
    }
}

std::string quantity_text(Key const& key, Dimension dimension) {
    if (!key.dimension_of.empty()) {
        return fmt::format("quantity in the unit of {}", key.dimension_of);
    }
    return dimension == Dimension::none ? std::string("number")
                                        : fmt::format("{} [{}]", name_of(dimension), si_symbol(dimension));
}

std::string ranged(Key const& key) {
    auto quantity = quantity_text(key, key.dimension);
    auto const& range = key.range;
    if (std::isinf(range.low) && std::isinf(range.high)) {
        return quantity;
    }
    return fmt::format("{} {}", quantity, range.text());
}

std::string integer_text(Key const& key) {
    if (key.most == std::numeric_limits<std::int64_t>::max()) {
        return fmt::format("whole number from {}", key.least);
    }
    return fmt::format("whole number from {} to {}", key.least, key.most);
}

std::string words_text(Key const& key) {
    std::vector<std::string> names;
    for (auto const& word : key.words()) {
        names.emplace_back(word.name);
    }
    return joined(names);
}

}  // namespace

std::vector<PlacedTable> tables_within(KeyTable const& root) {
    std::vector<PlacedTable> found;
    visit(root, {}, found);
    return found;
}

std::string heading_of(PlacedTable const& placed) {
    std::string heading;
    std::string conditions;
    std::vector<std::string> listed;
    for (auto const& [path, is_list, condition] : placed.places) {
        auto const name = is_list ? fmt::format("[[{}]]", path) : fmt::format("[{}]", path);
        if (!path.empty() && std::ranges::find(listed, name) == listed.end()) {
            heading += heading.empty() ? name : ", " + name;
            listed.push_back(name);
        }
        if (!condition.empty() && std::ranges::find(listed, condition) == listed.end()) {
            conditions += conditions.empty() ? condition : " or" + condition.substr(condition.find(" = ") + 2);
            listed.push_back(condition);
        }
    }
    return conditions.empty() ? heading : fmt::format("{}, where {}", heading, conditions);
}

std::string takes_text(Key const& key) {
    std::vector<std::string> ways;
    if (key.takes(Form::number)) {
        ways.push_back(ranged(key));
    }
    if (key.takes(Form::integer)) {
        ways.push_back(integer_text(key));
    }
    if (key.takes(Form::boolean)) {
        ways.emplace_back("true or false");
    }
    if (key.takes(Form::word)) {
        ways.push_back(words_text(key));
    }
    if (key.takes(Form::text)) {
        ways.emplace_back("text");
    }
    if (key.takes(Form::numbers)) {
        ways.push_back(key.takes(Form::number) ? "list of them" : fmt::format("list of {}", ranged(key)));
    }
    if (key.takes(Form::pairs)) {
        ways.push_back(
            fmt::format("list of [{}, {}]", quantity_text({}, key.first), quantity_text(key, key.dimension)));
    }
    if (key.takes(Form::texts)) {
        ways.push_back(key.words == nullptr ? "list of texts" : "list of " + words_text(key));
    }
    if (key.takes(Form::table)) {
        ways.emplace_back("table");
    }
    if (key.takes(Form::tables)) {
        ways.emplace_back("list of tables");
    }
    return fmt::format("{}", fmt::join(ways, ", or "));
}

std::string default_text(Key const& key) {
    auto const& absent = key.absent;
    if (absent.kind == Default::Kind::required) {
        return "required";
    }
    if (absent.kind == Default::Kind::none) {
        return "optional";
    }
    if (absent.number) {
        auto const unit = si_symbol(key.dimension);
        return fmt::format("{:.6g}{}{}", *absent.number, unit.empty() ? "" : " ", unit);
    }
    if (absent.integer) {
        return fmt::format("{}", *absent.integer);
    }
    if (absent.boolean) {
        return *absent.boolean ? "true" : "false";
    }
    return std::string(absent.words);
}

std::string meaning_text(Key const& key) {
    return key.where.empty() ? std::string(key.meaning) : fmt::format("if {}: {}", key.where, key.meaning);
}

}  // namespace overturn::config
