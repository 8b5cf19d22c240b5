/// The parts that a body is assembled from, as a campaign or body file states them.
#pragma once

#include <vector>

#include "body/parts.hpp"
#include "config/table.hpp"

namespace overturn {

/// Keys of one of [[parts]].
extern config::KeyTable const part_table;

/// \throws InputError
[[nodiscard]] std::vector<BodyPart> read_parts(config::Table const& table);

/// The same with all lengths multiplied; masses stay.
[[nodiscard]] std::vector<BodyPart> with_lengths(std::vector<BodyPart> parts, double factor);

}  // namespace overturn
