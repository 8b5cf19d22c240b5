/// The reference of all keys, made from their descriptions: which tables there are, where they stand, what keys take.
#pragma once

#include <string>
#include <vector>

#include "config/key.hpp"

namespace overturn::config {

/// Place of a table: its path "waves.target", and its condition on other keys "waves.source = harmonic".
struct TablePlace {
    std::string path;       ///< empty: the file itself
    bool is_list = false;   ///< [[path]]
    std::string condition;  ///< empty: none

    friend bool operator==(TablePlace const&, TablePlace const&) = default;
};

/// A table and all places where it may stand, in the order of the description.
struct PlacedTable {
    KeyTable const* table;
    std::vector<TablePlace> places;
};

/// `root` and every table in it, each once, before those that stand in it.
[[nodiscard]] std::vector<PlacedTable> tables_within(KeyTable const& root);

/// "[waves.target], [waves.vertical.target], where waves.source = spectrum-compatible"; "" of the file itself.
[[nodiscard]] std::string heading_of(PlacedTable const& placed);

/// Text of the values that a key takes: "time [s] above 0 or list of them", "one of each, ensemble, none".
[[nodiscard]] std::string takes_text(Key const& key);

/// Text of an absent key's meaning: "required", "optional", "0.01 s", "1/10 of the duration".
[[nodiscard]] std::string default_text(Key const& key);

/// The meaning, behind the condition under which the key has one: "where shape = points: ...".
[[nodiscard]] std::string meaning_text(Key const& key);

}  // namespace overturn::config
