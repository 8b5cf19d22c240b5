#include "cli/key_list.hpp"

#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "campaign/withdrawn_keys.hpp"
#include "core/wrapped.hpp"

namespace overturn::cli {
namespace {

using config::Default;
using config::Form;
using config::Key;
using config::PlacedTable;

constexpr std::size_t name_width = 27;  // of the longest key, with two blanks before it and one behind

// `text` behind `begun`, its further lines below the names' meaning.
std::string beside(std::string begun, std::string_view text) {
    return wrapped(text, name_width, line_width, std::move(begun));
}

bool has_default(Key const& key) {
    return key.absent.kind == Default::Kind::value || key.absent.kind == Default::Kind::in_words;
}

std::string title_of(PlacedTable const& placed) {
    auto const heading = heading_of(placed);
    return heading.empty() ? std::string("outermost keys") : heading;
}

// The key that distinguishes a table from others in its place has one word here.
std::string takes_in(config::KeyTable const& table, Key const& key) {
    return !table.word.empty() && key.name == table.chosen_by ? std::string(table.word) : takes_text(key);
}

Json or_nothing(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json json_of(Key const& key) {
    Json one{{"key", key.name}, {"takes", takes_text(key)}};
    if (key.takes(Form::number) || key.takes(Form::numbers)) {
        one["unit"] = key.dimension_of.empty() ? Json(si_symbol(key.dimension)) : Json(nullptr);
        one["low"] = or_nothing(key.range.low);
        one["high"] = or_nothing(key.range.high);
        one["low_is_allowed"] = !key.range.low_open;
        one["high_is_allowed"] = !key.range.high_open;
    }
    if (key.takes(Form::integer)) {
        one["low"] = key.least;
        one["high"] = key.most;
    }
    if (key.words != nullptr) {
        one["words"] = Json::array();
        for (auto const& word : key.words()) {
            one["words"].push_back({{"name", word.name}, {"meaning", word.summary}});
        }
    }
    one["required"] = key.absent.kind == Default::Kind::required;
    one["default"] = has_default(key) ? Json(default_text(key)) : Json(nullptr);
    one["where"] = key.where.empty() ? Json(nullptr) : Json(key.where);
    one["meaning"] = key.meaning;
    return one;
}

}  // namespace

std::string absent_text(Key const& key) { return (has_default(key) ? "default " : "") + default_text(key); }

std::string keys_text(std::span<PlacedTable const> tables) {
    std::string text;
    for (auto const& placed : tables) {
        text += text.empty() ? "" : "\n";
        text += beside("", title_of(placed));
        text += beside("  ", std::string(placed.table->meaning));
        for (auto const* key : listed_keys(*placed.table)) {
            text += beside(fmt::format("  {:<{}}", key->name, name_width - 2),
                           fmt::format("{}; {}", takes_in(*placed.table, *key), absent_text(*key)));
            text += beside(std::string(name_width, ' '), meaning_text(*key));
        }
    }
    return text;
}

std::string keys_markdown(std::span<PlacedTable const> tables) {
    std::string text =
        "# Keys of a campaign\n\n"
        "Written by `overturn list keys --markdown`. A number without unit is SI; a quantity may be a text with its "
        "unit, \"1.5 "
        "t\".\nAny value may state its source: `{value = ..., basis = \"measured\", source = \"...\", range = [low, "
        "high]}`.\nA table may do so with its keys `basis` and `source`.\n";
    for (auto const& placed : tables) {
        text += fmt::format("\n## {}\n\n{}\n\n| key | takes | default | meaning |\n|---|---|---|---|\n",
                            placed.places.front().path.empty() ? "The file itself" : "`" + title_of(placed) + "`",
                            placed.table->meaning);
        for (auto const* key : listed_keys(*placed.table)) {
            text += fmt::format("| `{}` | {} | {} | {} |\n", key->name, takes_in(*placed.table, *key),
                                default_text(*key), meaning_text(*key));
        }
    }
    return text;
}

Json keys_json(std::span<PlacedTable const> tables) {
    auto all = Json::array();
    for (auto const& placed : tables) {
        Json table{{"places", Json::array()}, {"meaning", placed.table->meaning}, {"keys", Json::array()}};
        for (auto const& [path, is_list, condition] : placed.places) {
            table["places"].push_back(
                {{"path", path}, {"list", is_list}, {"where", condition.empty() ? Json(nullptr) : Json(condition)}});
        }
        for (auto const* key : listed_keys(*placed.table)) {
            table["keys"].push_back(json_of(*key));
        }
        all.push_back(std::move(table));
    }
    return all;
}

}  // namespace overturn::cli
