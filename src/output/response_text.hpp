/// The response of one body to one record, in words and as JSON.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "campaign/body_spec.hpp"
#include "motion/drift.hpp"
#include "motion/recording.hpp"
#include "output/json.hpp"
#include "output/shown_velocity.hpp"
#include "response/model_selector.hpp"
#include "response/response.hpp"

namespace overturn::output {

/// A response with all that it came from.
struct OneResponse {
    BodySpec const& spec;
    PlacedRecord const& record;
    Drift drift;
    Response const& response;
    ModelSelector const& selector;
    std::span<std::byte const> extra;  ///< columns of the models' own, as the selector lays them out
};

/// All columns of a trial [SI], and "stated": those with units in the units of the body's file. What never came is
/// null.
[[nodiscard]] Json json_of(OneResponse const& of);
[[nodiscard]] std::string text_of(OneResponse const& of, ShownVelocity const& unit);

}  // namespace overturn::output
