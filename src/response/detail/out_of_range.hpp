/// Shaking that no model follows.
#pragma once

#include "model/effect.hpp"
#include "model/excitation.hpp"

namespace overturn {

/// Is a component that these effects look at beyond a million g? There nothing means anything, and products overflow
/// without a sound.
[[nodiscard]] bool out_of_range(Excitation const& shaking, EffectMask simulated);

}  // namespace overturn
