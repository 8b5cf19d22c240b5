/// Units in which people read a campaign's numbers: those in which its file states them.
#pragma once

#include <optional>
#include <string>

#include "campaign/campaign_spec.hpp"
#include "core/units.hpp"
#include "stats/intensity_unit.hpp"

namespace overturn {

/// The unit in which a campaign states quantities of a dimension; of several the first that stands in the levels, in a
/// limit state, in its other keys, in a target spectrum. Empty where it states none, or bare numbers.
/// For lengths it is that of distances (limit states and [site]), else that of the bodies.
[[nodiscard]] std::optional<IntensityUnit> typed_unit(CampaignSpec const& spec, Dimension dimension);

/// Units for texts and tables; where the campaign states none, the values here.
struct TypedUnits {
    IntensityUnit mass{"t", 1e3};
    IntensityUnit length{"m", 1};  ///< of bodies
    /// Of slip and distances: mm instead of m or km, inches instead of feet, so that small values keep their digits.
    IntensityUnit slip{"mm", 1e-3};
    IntensityUnit acceleration{"m/s2", 1};
    IntensityUnit velocity{"m/s", 1};
    IntensityUnit pressure{"MPa", 1e6};
};
[[nodiscard]] TypedUnits typed_units(CampaignSpec const& spec);

/// The unit for texts and tables of a response that is stored in `stored`, an SI symbol: of "m" that of slip, of "rad"
/// degrees.
[[nodiscard]] IntensityUnit shown_unit(CampaignSpec const& spec, std::string const& stored);

}  // namespace overturn
