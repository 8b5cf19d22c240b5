/// The support of a body by its keys base, pad, inertia_y and inertia_z.
#pragma once

#include "campaign/body_spec.hpp"
#include "config/table.hpp"

namespace overturn {

/// Keys base, pad and the inertias of a body in space.
extern config::KeyTable const footing_table;

/// Points from corner to corner of a square base that states none.
[[nodiscard]] int usual_points_across(bool before_format_5);

/// Keys that are not there leave what stands. Before format 5 a table beside a file left nothing. \throws InputError
void read_footing(config::Table const& table, Footing& footing, bool before_format_5);

/// The footing of the body in force: scaled, and matched where the restitution was stated. \throws InputError at the
/// key that no base can follow
void settle_footing(config::Table const& table, BodySpec& spec);

}  // namespace overturn
