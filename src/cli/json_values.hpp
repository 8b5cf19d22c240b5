/// JSON as the verbs write it: null where nothing is known.
#pragma once

#include <utility>

#include "output/json.hpp"

namespace overturn::cli {

using Json = output::Json;

[[nodiscard]] inline Json or_null(bool known, Json value) { return known ? std::move(value) : Json(nullptr); }

}  // namespace overturn::cli
