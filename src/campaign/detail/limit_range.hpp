/// Possible and usual values of a limited quantity, in trials of a body that stands. Thresholds are checked against
/// them: can they be passed, can they be kept, are they likely to be meant?
#pragma once

#include <string>
#include <string_view>

#include "campaign/body_spec.hpp"
#include "campaign/limit_state.hpp"

namespace overturn {

struct LimitRange {
    double at_rest = 0;               ///< of a body that nothing moves [SI]
    double least = 0, most = 0;       ///< in any trial that stands; `most` may be infinite [SI]
    double usual_low = 0;             ///< less passes with any shaking [SI]
    double usual_high = 0;            ///< more is hardly reached; infinite where nothing is known [SI]
    std::string_view low_known = {};  ///< why so
    std::string_view high_known = {};
};

[[nodiscard]] LimitRange range_of(LimitQuantity const& quantity, BodySpec const& body);

/// Trials that stand and can pass a limit of `above` or `below`, whatever shakes them.
enum class Passable { none, some, all };

[[nodiscard]] Passable passable(LimitState const& limit, LimitRange const& range);

/// Does a body pass it that nothing moves? \pre a limit of `above` or `below`
[[nodiscard]] bool passed_at_rest(LimitState const& limit, LimitRange const& range);

}  // namespace overturn
