#include "model/model.hpp"

#include <algorithm>

namespace overturn {

EffectMask ModelTraits::brings() const {
    EffectMask mask = 0;
    for (auto const& effect : effects) {
        mask |= mask_of(effect.value);
    }
    return mask;
}

bool ModelTraits::computes(std::string_view quantity, bool common) const {
    if (common) {
        return std::ranges::find(lacks, quantity) == lacks.end();
    }
    return std::ranges::find(fields, quantity, &Field::name) != fields.end();
}

EffectMask Model::possible(Trial const& /*trial*/) const { return traits().brings(); }

Requirement Model::required_of(Trial const& /*trial*/, Outcome const* earlier) const {
    return {earlier == nullptr ? 0 : traits().brings() & static_cast<EffectMask>(earlier->required)};
}

}  // namespace overturn
