/// Making datasets and writing their rows.
#pragma once

#include <cstdint>
#include <string>

#include "store/detail/h5.hpp"

namespace overturn::store {

/// Identical content gives identical bytes: no object times, default library version, storage allocated when created.
[[nodiscard]] PropertyList dataset_properties();

/// Writes `count` rows from `first` on.
void write_rows(Dataset const& dataset, hid_t memory_type, void const* values, std::int64_t first, std::int64_t count,
                std::string const& name);

}  // namespace overturn::store
