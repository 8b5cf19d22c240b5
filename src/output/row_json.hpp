/// Rows of stored quantities as JSON: SI under the names of their columns, and beside it the units that were typed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "campaign/campaign_spec.hpp"
#include "campaign/rows.hpp"
#include "campaign/text_units.hpp"
#include "core/field.hpp"
#include "output/json.hpp"

namespace overturn::output {

/// A value of a row; null: it never came.
[[nodiscard]] Json value_json(std::span<std::byte const> row, Field const& field);

/// Names of the effects in a mask.
[[nodiscard]] Json effect_names(std::int64_t mask);
/// {"peak_slip": {"value": 12, "unit": "mm"}, ...}: of all fields that are lengths, angles, velocities or
/// accelerations.
[[nodiscard]] Json stated_of(Fields const& fields, std::span<std::byte const> row, TypedUnits const& units);

/// A trial that was computed again.
struct ReplayedTrial {
    CampaignSpec const& spec;
    TrialRows const& trial;  ///< one row
    std::int64_t number = 0, wave_number = 0;
    std::vector<std::string> const& different;  ///< columns that are not bit-equal to the stored row
};

/// Its place, whether it is bit-equal, and "row": all columns of /trials, those of a model in an object of its name.
[[nodiscard]] Json replay_json(ReplayedTrial const& of);

}  // namespace overturn::output
