/// The support of a body by its keys base, pad, inertia_y and inertia_z.
#pragma once

#include "campaign/body_spec.hpp"
#include "config/table.hpp"

namespace overturn {

/// Keys base, pad and the inertias of a body in space.
extern config::KeyTable const footing_table;

/// Keys that are not there leave what stands. \param points_across of a square base that states none \throws InputError
void read_footing(config::Table const& table, Footing& footing, int points_across);

/// The footing of the body in force: scaled, and matched where the restitution was stated. \throws InputError at the
/// key that no base can follow
void settle_footing(config::Table const& table, BodySpec& spec);

}  // namespace overturn
