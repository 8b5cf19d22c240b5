/// Columns whose values have names: read by name, whatever number a file gives it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/field.hpp"
#include "store/detail/h5.hpp"

namespace overturn::store {

/// Advice for a file that holds an impossible value.
inline constexpr auto advice =
    "(it was edited or damaged, or another program wrote it). Restore it, or run the campaign again";

/// Reads `count` rows from `first` on.
void read_some(Dataset const& dataset, std::string const& name, hid_t memory_type, std::int64_t first,
               std::int64_t count, void* values);

/// Is it an enumeration?
[[nodiscard]] bool is_category(Dataset const& dataset);

/// Values of an enumeration, as they are stored: HDF5 converts enumerations only to their own kind.
[[nodiscard]] std::vector<std::int64_t> read_categories(Dataset const& dataset, std::string const& name,
                                                        std::int64_t first, std::int64_t count);

/// The names of an enumeration's values, with the numbers that stand for them in the file.
[[nodiscard]] std::vector<Category> stored_names(Dataset const& dataset);

/// The names that an integer's attributes flag_values and flag_meanings give; none where it has none.
[[nodiscard]] std::vector<Category> flagged_names(Dataset const& dataset);

/// The file's numbers as those that `wanted` gives to the same names; unknown_category where it has no such name.
/// \throws InputError where one has no name in the file, or is essential and not wanted
void rename_values(std::vector<std::int64_t>& values, std::span<Category const> stored,
                   std::span<Category const> wanted, std::string const& column, bool essential);

}  // namespace overturn::store
