/// Values that a file states, key by key, to compare two files: comments, order and layout do not count.
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace overturn::config {

/// "waves.count" -> "200", "bodies.type-b.friction" -> "0.5": each value below its path, with the settings applied; a
/// table in a list goes by its name, or by its number from 1, and "bodies" -> "a, b" is their order. \throws InputError
/// if it is no TOML
[[nodiscard]] std::map<std::string, std::string> stated_values(std::string_view text, std::string const& file,
                                                               std::span<std::string const> settings);

/// The names by which stated_values() distinguishes the tables of a list, in their order; none where there is no such
/// list. \throws InputError likewise
[[nodiscard]] std::vector<std::string> names_in_list(std::string_view text, std::string const& file,
                                                     std::span<std::string const> settings, std::string_view list);

}  // namespace overturn::config
