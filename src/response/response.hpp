/// One trial's answer, and which models gave it.
#pragma once

#include "core/field.hpp"
#include "model/outcome.hpp"

namespace overturn {

struct Response : Outcome {
    std::int64_t effects = 0;  ///< EffectMask of those that ran
    std::int64_t model = 0;    ///< one of model_categories()
    std::int64_t reason = 0;   ///< one of reasons(): why that model
};

/// Fields of the outcome, with all models' verdicts, and those of the response.
template <> [[nodiscard]] Fields const& fields_of<Response>();

}  // namespace overturn
