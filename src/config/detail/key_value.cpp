#include "config/detail/key_value.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "config/suggestion.hpp"
#include "core/error.hpp"

namespace overturn::config {
namespace {

void check_word(Key const& key, std::string const& text) {
    std::vector<std::string> known;
    for (auto const& word : key.words()) {
        known.emplace_back(word.name);
    }
    validate(std::ranges::find(known, text) != known.end(), "{} '{}' (unknown). {}", key.name, text,
             suggestion(text, known));
}

void read_text(Table const& table, Key const& key, toml::node const& value) {
    auto const text = value.value_or(std::string());
    if (key.takes(Form::text)) {
        return;
    }
    if (key.takes(Form::word)) {
        bool const number = key.takes(Form::number) && text.find_first_of("0123456789") != std::string::npos;
        if (!number) {
            table.located(key.name, [&] { check_word(key, text); });
            return;
        }
    }
    if (key.takes(Form::number)) {
        key.dimension_of.empty() ? (void)table.number(key.name, key.dimension, key.range) : void();
    } else if (key.takes(Form::integer)) {
        (void)table.integer(key.name, key.least, key.most);
    } else if (key.takes(Form::boolean)) {
        (void)table.boolean(key);
    }
}

void read_list(Table const& table, Key const& key) {
    if (key.takes(Form::tables)) {
        (void)table.children(key);
    } else if (key.takes(Form::pairs)) {
        key.dimension_of.empty() ? (void)table.pairs(key) : void();
    } else if (key.takes(Form::numbers)) {
        key.dimension_of.empty() ? (void)table.numbers(key) : void();
    } else if (key.takes(Form::texts)) {
        auto const texts = table.texts(key);
        for (auto const& text : key.words == nullptr ? std::vector<std::string>() : texts) {
            table.located(key.name, [&] { check_word(key, text); });
        }
    }
}

/// Reads a value that is in none of the key's forms, so that its reader says which they are.
void read_as_first_form(Table const& table, Key const& key) {
    if (key.takes(Form::number)) {
        (void)table.number(key.name, key.dimension, key.range);
    } else if (key.takes(Form::integer)) {
        (void)table.integer(key.name, key.least, key.most);
    } else if (key.takes(Form::boolean)) {
        (void)table.boolean(key);
    } else if (key.takes(Form::text) || key.takes(Form::word)) {
        (void)table.text(key.name);
    } else if (key.takes(Form::numbers)) {
        (void)table.numbers(key);
    } else if (key.takes(Form::pairs)) {
        (void)table.pairs(key);
    } else if (key.takes(Form::texts)) {
        (void)table.texts(key);
    } else if (key.takes(Form::tables)) {
        (void)table.children(key);
    } else {
        (void)table.child(key);
    }
}

bool may_be_list(Key const& key) {
    return key.takes(Form::tables) || key.takes(Form::pairs) || key.takes(Form::numbers) || key.takes(Form::texts);
}

bool may_be_text(Key const& key) { return key.takes(Form::text) || key.takes(Form::word) || key.takes(Form::number); }

}  // namespace

void read_value(Table const& table, Key const& key, toml::node const& value) {
    if (value.is_table() && key.takes(Form::table)) {
        (void)table.child(key);
    } else if (value.is_array() && may_be_list(key)) {
        read_list(table, key);
    } else if (value.is_string() && may_be_text(key)) {
        read_text(table, key, value);
    } else if (value.is_integer() && key.takes(Form::integer)) {
        (void)table.integer(key.name, key.least, key.most);
    } else if (value.is_number() && key.takes(Form::number)) {
        key.dimension_of.empty() ? (void)table.number(key.name, key.dimension, key.range) : void();
    } else {
        read_as_first_form(table, key);
    }
}

}  // namespace overturn::config
