/// The parts that a body is assembled from, as a campaign or body file states them.
#pragma once

#include <vector>

#include "body/parts.hpp"
#include "config/table.hpp"

namespace overturn {

/// [[parts]]: kind (cylinder, box or point), mass, then diameter or width, height and bottom, or height alone.
/// \throws InputError
extern config::KeyTable const part_table;
[[nodiscard]] std::vector<BodyPart> read_parts(config::Table const& table);

/// The same with all lengths multiplied; masses stay.
[[nodiscard]] std::vector<BodyPart> with_lengths(std::vector<BodyPart> parts, double factor);

}  // namespace overturn
