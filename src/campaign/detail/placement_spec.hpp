/// Placement of a body (offset of its centre, slope, initial tilt), and the inputs that it excludes.
#pragma once

#include "campaign/body_spec.hpp"
#include "campaign/campaign_spec.hpp"
#include "config/table.hpp"

namespace overturn {

/// Keys offset, slope and initial_tilt.
extern config::KeyTable const placement_table;

/// Reads these keys; they replace those of the body's file. \throws InputError at the key if the body falls by itself
void read_placement(config::Table const& table, BodySpec& spec);

/// \throws InputError beside base, pad and inertias that only other models hold, and where friction lets it slide away
void validate_placement(config::Table const& table, BodySpec const& spec);

/// \throws InputError where effects or a transverse component ask for models that know nothing of a body's placement
void check_planar(config::Table const& effects, config::Table const& waves, CampaignSpec const& spec);

/// The same of limit states, the linearised block and rare events.
void check_planar_limits(config::Table const& root, CampaignSpec const& spec);

}  // namespace overturn
