/// Assumptions of the model itself, whatever the campaign states.
#pragma once

#include <span>
#include <string_view>

#include "campaign/campaign_spec.hpp"

namespace overturn {

/// In which direction overturning is misjudged where an assumption does not hold: unsafe, more falls than is computed.
enum class Misjudged { safe, unsafe, unknown };
[[nodiscard]] std::string_view name_of(Misjudged direction);

/// Does an assumption bear on a campaign: on none of its trials, on all, or on those that auto does not find another
/// effect called for?
enum class Bears { no, yes, where_not_required };

/// One fixed assumption of the model.
struct ModelAssumption {
    std::string_view name;     ///< "one-plane"
    std::string_view assumed;  ///< the assumption
    Misjudged direction = Misjudged::unknown;
    std::string_view key;       ///< of the campaign, that does without it; "none"
    std::string_view effect;    ///< as measured by a study of this project; "not measured"
    std::string_view evidence;  ///< author and year, or the study's file
    Bears (*bears)(CampaignSpec const& spec);
};
[[nodiscard]] std::span<ModelAssumption const> model_assumptions();

}  // namespace overturn
