/// Description of a key of a campaign, stated once: its readers take unit, range and default from here, and so does the
/// reference that is made of it (`overturn list keys`).
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <stdexcept>
#include <string_view>
#include <type_traits>
#include <vector>

#include "config/range.hpp"
#include "core/units.hpp"

namespace overturn::config {

/// Form of a key's value. A key that may be written in several ways has several forms.
enum class Form : unsigned {
    number = 1U,    ///< of the key's dimension, or a text with a unit of it
    integer = 2U,   ///< a whole number
    boolean = 4U,   ///< true or false
    word = 8U,      ///< one of the key's words
    text = 16U,     ///< any other text, for example a file's name
    numbers = 32U,  ///< a list of numbers
    pairs = 64U,    ///< a list of [number, number]
    texts = 128U,   ///< a list of texts
    table = 256U,   ///< one of the key's tables
    tables = 512U,  ///< a list of them
};
[[nodiscard]] constexpr unsigned bit(Form form) { return static_cast<unsigned>(form); }

/// Value of an absent key.
struct Default {
    /// required: nothing is, the key must be there. none: its absence means something. value: what is stated here.
    /// in_words: a default that follows from other keys, in words.
    enum class Kind { required, none, value, in_words };

    Kind kind = Kind::required;
    std::optional<double> number = {};  ///< [SI]
    std::optional<std::int64_t> integer = {};
    std::optional<bool> boolean = {};
    std::string_view words = {};  ///< a text, or the default in words
};

/// A text that a key takes, and what it means.
struct Word {
    std::string_view name, summary;
};

struct KeyTable;

/// One key. Dimensions and ranges are those of its number, or of the numbers of its list.
struct Key {
    std::string_view name, meaning;
    unsigned forms = 0;
    Dimension dimension = Dimension::none;  ///< of pairs that of the second
    Dimension first = Dimension::none;      ///< of pairs that of the first
    std::string_view dimension_of = {};     ///< the unit is that of another key, in words; empty: `dimension` holds
    Range range = Range::any();
    std::int64_t least = std::numeric_limits<std::int64_t>::min();  ///< of a whole number
    std::int64_t most = std::numeric_limits<std::int64_t>::max();
    std::vector<Word> (*words)() = nullptr;
    std::vector<KeyTable const*> (*tables)() = nullptr;
    Default absent = {};
    std::string_view where = {};  ///< other keys under which it has a meaning, in words; empty: always

    [[nodiscard]] constexpr bool takes(Form form) const { return (forms & bit(form)) != 0; }

    /// The key may be left out: its absence means something that no value would.
    [[nodiscard]] constexpr Key optional() const { return with({.kind = Default::Kind::none}); }
    /// \param value [SI] that stands in for an absent key: a number, a whole number, true or false, or a word
    template <class Value> [[nodiscard]] constexpr Key otherwise(Value const& value) const {
        Default made{.kind = Default::Kind::value};
        if constexpr (std::same_as<Value, bool>) {
            made.boolean = value;
        } else if constexpr (std::is_arithmetic_v<Value>) {
            if (takes(Form::integer)) {
                made.integer = static_cast<std::int64_t>(value);
            } else {
                made.number = static_cast<double>(value);
            }
        } else {
            made.words = value;
        }
        return with(made);
    }
    /// \param in_words default of an absent key in words, where other keys decide it
    [[nodiscard]] constexpr Key otherwise_in_words(std::string_view in_words) const {
        return with({.kind = Default::Kind::in_words, .words = in_words});
    }
    /// \param condition other keys under which this one has a meaning
    [[nodiscard]] constexpr Key only(std::string_view condition) const {
        auto made = *this;
        made.where = condition;
        return made;
    }
    /// \param whose the key whose unit this one's numbers are of, in words
    [[nodiscard]] constexpr Key in_unit_of(std::string_view whose) const {
        auto made = *this;
        made.dimension_of = whose;
        return made;
    }
    /// A key that may be written in this form too, with that one's words, tables, dimension and range.
    [[nodiscard]] constexpr Key or_as(Key const& other) const {
        auto made = *this;
        made.forms |= other.forms;
        // By the forms: under GCC's sanitizers an address compared with nullptr is no constant expression.
        made.words = other.takes(Form::word) ? other.words : words;
        made.tables = other.takes(Form::table) || other.takes(Form::tables) ? other.tables : tables;
        made.first = other.takes(Form::pairs) ? other.first : first;
        if (other.takes(Form::number)) {
            made.dimension = other.dimension;
            made.range = other.range;
        }
        return made;
    }

  private:
    [[nodiscard]] constexpr Key with(Default const& otherwise) const {
        auto made = *this;
        made.absent = otherwise;
        return made;
    }
};

/// The keys that a file keeps to itself, found by name when it is compiled: one that is not there is no program.
template <std::size_t count> struct Keys {
    std::array<Key, count> all;

    [[nodiscard]] consteval Key const& operator[](std::string_view name) const {
        for (auto const& key : all) {
            if (key.name == name) {
                return key;
            }
        }
        throw std::logic_error("no such key is described");
    }
};
template <class... Each> Keys(Each...) -> Keys<sizeof...(Each)>;

/// A table of a file: the keys it may have. The tables in it are those of its keys, so that the campaign's own table
/// holds them all.
struct KeyTable {
    std::string_view meaning;
    std::span<Key const> keys;
    std::array<KeyTable const*, 2> also = {};  ///< whose keys are here too
    std::string_view chosen_by = {};           ///< of several tables in one place: the key that distinguishes them
    std::string_view word = {};                ///< value of that key for this table

    /// This table's keys and those it has from others.
    [[nodiscard]] std::vector<Key const*> every_key() const;
    /// The key of this name, or none.
    [[nodiscard]] Key const* find(std::string_view name) const;
};

/// \name Keys by what stands behind them.
/// @{
[[nodiscard]] constexpr Key number_key(std::string_view name, Dimension dimension, Range range,
                                       std::string_view meaning) {
    return {.name = name, .meaning = meaning, .forms = bit(Form::number), .dimension = dimension, .range = range};
}
[[nodiscard]] constexpr Key numbers_key(std::string_view name, Dimension dimension, Range range,
                                        std::string_view meaning) {
    auto key = number_key(name, dimension, range, meaning);
    key.forms = bit(Form::numbers);
    return key;
}
[[nodiscard]] constexpr Key pairs_key(std::string_view name, Dimension first, Dimension second,
                                      std::string_view meaning) {
    auto key = number_key(name, second, Range::any(), meaning);
    key.forms = bit(Form::pairs);
    key.first = first;
    return key;
}
[[nodiscard]] constexpr Key integer_key(std::string_view name, std::int64_t least, std::int64_t most,
                                        std::string_view meaning) {
    return {.name = name, .meaning = meaning, .forms = bit(Form::integer), .least = least, .most = most};
}
[[nodiscard]] constexpr Key boolean_key(std::string_view name, std::string_view meaning) {
    return {.name = name, .meaning = meaning, .forms = bit(Form::boolean)};
}
[[nodiscard]] constexpr Key text_key(std::string_view name, std::string_view meaning) {
    return {.name = name, .meaning = meaning, .forms = bit(Form::text)};
}
[[nodiscard]] constexpr Key texts_key(std::string_view name, std::string_view meaning) {
    return {.name = name, .meaning = meaning, .forms = bit(Form::texts)};
}

/// The names and summaries of a registry: an array of entries, or a function that returns them.
template <auto const& entries> [[nodiscard]] std::vector<Word> words_of() {
    std::vector<Word> words;
    auto const add = [&](auto const& all) {
        for (auto const& entry : all) {
            words.push_back({entry.name, entry.summary});
        }
    };
    if constexpr (std::is_function_v<std::remove_reference_t<decltype(entries)>>) {
        add(entries());
    } else {
        add(entries);
    }
    return words;
}
template <auto const& entries> [[nodiscard]] constexpr Key word_key(std::string_view name, std::string_view meaning) {
    return {.name = name, .meaning = meaning, .forms = bit(Form::word), .words = &words_of<entries>};
}

/// \param words the texts that it takes
[[nodiscard]] constexpr Key word_key(std::string_view name, std::vector<Word> (*words)(), std::string_view meaning) {
    return {.name = name, .meaning = meaning, .forms = bit(Form::word), .words = words};
}
/// A list of texts, each one of a registry's.
template <auto const& entries> [[nodiscard]] constexpr Key words_key(std::string_view name, std::string_view meaning) {
    auto key = word_key<entries>(name, meaning);
    key.forms = bit(Form::texts);
    return key;
}

template <KeyTable const&... tables> [[nodiscard]] std::vector<KeyTable const*> tables_of() { return {&tables...}; }

template <KeyTable const&... tables>
[[nodiscard]] constexpr Key table_key(std::string_view name, std::string_view meaning) {
    return {.name = name, .meaning = meaning, .forms = bit(Form::table), .tables = &tables_of<tables...>};
}
/// \param tables those that may stand there, distinguished by their `chosen_by`
[[nodiscard]] constexpr Key table_key(std::string_view name, std::vector<KeyTable const*> (*tables)(),
                                      std::string_view meaning) {
    return {.name = name, .meaning = meaning, .forms = bit(Form::table), .tables = tables};
}
/// A list of tables: [[name]].
template <KeyTable const&... tables>
[[nodiscard]] constexpr Key tables_key(std::string_view name, std::string_view meaning) {
    auto key = table_key<tables...>(name, meaning);
    key.forms = bit(Form::tables);
    return key;
}
/// @}

}  // namespace overturn::config
