/// Friction as a body's table states it.
#pragma once

#include "campaign/body_spec.hpp"
#include "config/table.hpp"

namespace overturn {

/// friction = number | distribution | { static = number | distribution, kinetic = number or kinetic_ratio = number }
/// \throws InputError
void read_friction(config::Table const& table, BodySpec& spec);

}  // namespace overturn
