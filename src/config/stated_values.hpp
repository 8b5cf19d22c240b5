/// Values that a file states, key by key, to compare two files: comments, order, layout, units and statements of where
/// a value comes from (`basis`, `source`, `range`) do not count.
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace overturn::config {

/// A value as a person wrote it, and as it is compared.
struct StatedValue {
    std::string text;    ///< "'1.36 m'"
    std::string normal;  ///< "1.36": in SI, where it has a unit
    std::string key;     ///< as --set takes it, and in which table of a list: "bodies[1].friction (type-b)"

    /// By what it is compared.
    friend bool operator==(StatedValue const& a, StatedValue const& b) { return a.normal == b.normal; }
};

/// By path.
using StatedValues = std::map<std::string, StatedValue>;

/// "waves.count" -> 200, "bodies.type-b.friction" -> 0.5: each value below its path, with the settings applied; a table
/// in a list goes by its name, or by its place from 0, and "bodies" -> "a, b" is their order. \throws InputError if it
/// is no TOML
[[nodiscard]] StatedValues stated_values(std::string_view text, std::string const& file,
                                         std::span<std::string const> settings);

/// Entries of a list ("bodies", "waves.files") in their order, each by its own paths; that of a plain value is "". None
/// where there is no such list. \throws InputError likewise
[[nodiscard]] std::vector<StatedValues> stated_entries(std::string_view text, std::string const& file,
                                                       std::span<std::string const> settings, std::string_view list);

/// A stated text without its quotes; empty where the key is not there.
[[nodiscard]] std::string text_at(StatedValues const& values, std::string const& key);

}  // namespace overturn::config
