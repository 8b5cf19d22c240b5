/// Making datasets and writing their rows.
#pragma once

#include <cstdint>
#include <string>

#include "store/detail/h5.hpp"
#include "store/results_file.hpp"

namespace overturn::store {

/// Identical content gives identical bytes: no object times, default library version, storage allocated when created.
[[nodiscard]] PropertyList dataset_properties();

/// Lays a column of more than so many rows out in chunks, shuffled and deflated; a shorter one stays as it is.
/// \param access keeps the one chunk in memory that is being filled
void pack(PropertyList const& made, PropertyList const& access, hsize_t rows, hsize_t more_than = rows_of_a_chunk);

/// Writes `count` rows from `first` on.
void write_rows(Dataset const& dataset, hid_t memory_type, void const* values, std::int64_t first, std::int64_t count,
                std::string const& name);

}  // namespace overturn::store
