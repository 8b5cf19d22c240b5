/// Inputs that a study of sensitivity varies.
#pragma once

#include <vector>

#include "config/input_value.hpp"
#include "cost/sensitivity.hpp"

namespace overturn::cost {

struct VariedInputs {
    std::vector<config::InputValue> values;  ///< one for each of `inputs`: where it stands
    std::vector<VariedInput> inputs;
    std::vector<UnvariedInput> unvaried;
};
[[nodiscard]] VariedInputs varied_inputs(CampaignSpec const& spec);

}  // namespace overturn::cost
