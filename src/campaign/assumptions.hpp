/// What a campaign takes for granted: the values it was given, by where they come from, and what the model itself
/// assumes.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "campaign/campaign_spec.hpp"
#include "config/input_value.hpp"

namespace overturn {

/// In which direction overturning is misjudged where an assumption does not hold: unsafe, more falls than is computed.
enum class Misjudged { safe, unsafe, unknown };
[[nodiscard]] std::string_view name_of(Misjudged direction);

/// Does an assumption bear on a campaign: on none of its trials, on all, or on those that auto does not find another
/// effect called for?
enum class Bears { no, yes, where_not_called_for };

/// One fixed assumption of the model.
struct ModelAssumption {
    std::string_view name;     ///< "one-plane"
    std::string_view assumed;  ///< what is
    Misjudged direction = Misjudged::unknown;
    std::string_view key;       ///< of the campaign, that does without it; "none"
    std::string_view effect;    ///< as measured by a study of this project; "not measured"
    std::string_view evidence;  ///< author and year, or the study's file
    Bears (*bears)(CampaignSpec const& spec);
};
[[nodiscard]] std::span<ModelAssumption const> model_assumptions();

/// The inputs of [waves], [[bodies]] and [levels] that stand for something: no names, no files, no choices of how much
/// is computed.
[[nodiscard]] std::vector<config::InputValue> physical_inputs(CampaignSpec const& spec);

/// How many of them come from where.
struct InputTally {
    std::int64_t assumed = 0, published = 0, measured = 0, not_stated = 0, by_default = 0;

    [[nodiscard]] std::int64_t all() const { return assumed + published + measured + not_stated + by_default; }
};
[[nodiscard]] InputTally tally_of(std::span<config::InputValue const> inputs);
/// "12 of 30 inputs are assumed, 9 published, 0 measured, 2 not stated, 7 defaults of this program"
[[nodiscard]] std::string text_of(InputTally const& tally);

}  // namespace overturn
