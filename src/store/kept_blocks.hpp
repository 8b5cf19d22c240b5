/// Finished blocks beside a file that is not, or no longer, what their run would make of them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace overturn::store {

/// Finished blocks of a run that was begun for `output`, by the names of their files. 0 also where nothing is on
/// record.
[[nodiscard]] std::int64_t blocks_beside(std::filesystem::path const& output);

/// What to do about a file at `output` that holds no results: `otherwise`, or where finished blocks lie beside it, that
/// they are kept and what makes the file of them.
[[nodiscard]] std::string advice_beside_blocks(std::filesystem::path const& output, std::string_view otherwise);

}  // namespace overturn::store
