/// The band of periods that matters to a body of a campaign.
#pragma once

#include "body/rigid_body.hpp"
#include "spectra/band_rule.hpp"

namespace overturn {

/// T0 and T1 of a body, under its own gravity.
[[nodiscard]] inline PeriodBand rocking_band(RigidBody const& body, RadiusUnit unit = RadiusUnit::centimetre) {
    return rocking_period_band(body.radius_m(), unit, body.gravity_mps2());
}

}  // namespace overturn
