/// Units in which people read a campaign's numbers: those in which its file states them.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "campaign/campaign_spec.hpp"
#include "campaign/text_units.hpp"
#include "config/table.hpp"
#include "core/units.hpp"
#include "motion/drift.hpp"
#include "stats/intensity_unit.hpp"

namespace overturn {

/// The unit of that name, if there is one of the dimension; in small letters where it was not written as usual.
[[nodiscard]] std::optional<IntensityUnit> unit_named(std::string_view written, Dimension dimension);

/// The unit in which a campaign states quantities of a dimension; of several the first that stands in the levels, in a
/// limit state, in its other keys, in a target spectrum. Empty where it states none, or bare numbers.
/// A velocity that nobody states is in ft/s or in/s where bodies are in ft or in.
/// For lengths it is that of distances (limit states and [site]), else that of the bodies.
[[nodiscard]] std::optional<IntensityUnit> typed_unit(CampaignSpec const& spec, Dimension dimension);

/// The same for columns that stand beside those in SI: inches for feet, so that a slip keeps its digits.
[[nodiscard]] std::optional<IntensityUnit> unit_of_columns(CampaignSpec const& spec, Dimension dimension);

[[nodiscard]] TypedUnits typed_units(CampaignSpec const& spec);
/// The same of a body file, from its values.
[[nodiscard]] TypedUnits typed_units(std::span<config::InputValue const> inputs);

/// For texts of the ground's motion.
[[nodiscard]] MotionUnits motion_units(TypedUnits const& units);

/// The unit for texts and tables of a response that is stored in `stored`, an SI symbol: of "m" that of slip, of "rad"
/// degrees.
[[nodiscard]] IntensityUnit shown_unit(TypedUnits const& units, std::string const& stored);
[[nodiscard]] IntensityUnit shown_unit(CampaignSpec const& spec, std::string const& stored);

}  // namespace overturn
