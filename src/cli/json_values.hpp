/// Numbers as JSON has them: null where nothing is known.
#pragma once

#include <cmath>
#include <utility>

#include <nlohmann/json.hpp>

#include "stats/proportion.hpp"

namespace overturn::cli {

using Json = nlohmann::ordered_json;

[[nodiscard]] inline Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
[[nodiscard]] inline Json ends(Interval const& interval) {
    return Json::array({number(interval.lower), number(interval.upper)});
}
/// An intensity's lower end 0 says that nothing bounds it from below.
[[nodiscard]] inline Json intensity_ends(Interval const& interval) {
    return Json::array({interval.lower > 0 ? number(interval.lower) : Json(nullptr), number(interval.upper)});
}
[[nodiscard]] inline Json or_null(bool known, Json value) { return known ? std::move(value) : Json(nullptr); }

}  // namespace overturn::cli
