/// `overturn list keys`: the reference of all that a campaign may state.
#pragma once

#include <span>
#include <string>

#include "cli/json_values.hpp"
#include "config/key_reference.hpp"

namespace overturn::cli {

/// "required", "optional", or "default ...".
[[nodiscard]] std::string absent_text(config::Key const& key);

/// For people at a terminal: at most 100 columns.
[[nodiscard]] std::string keys_text(std::span<config::PlacedTable const> tables);
/// The same as Markdown, as campaigns/KEYS.md has it.
[[nodiscard]] std::string keys_markdown(std::span<config::PlacedTable const> tables);
/// The same for scripts.
[[nodiscard]] Json keys_json(std::span<config::PlacedTable const> tables);
/// A JSON schema (draft 2020-12) of files whose outermost table is `root`, for editors of TOML.
[[nodiscard]] Json keys_schema(config::KeyTable const& root);
/// A schema as a file, a key a line.
[[nodiscard]] std::string schema_text(Json const& schema);

}  // namespace overturn::cli
