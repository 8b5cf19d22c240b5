/// The physical mechanisms that a trial may include.
#pragma once

#include <cstdint>
#include <string_view>

namespace overturn {

/// One bit each. A model may bring another one: a further bit, stated in its traits. Values are stored in results
/// files: never renumber them.
enum class Effect : std::uint32_t { vertical = 1, sliding = 2, contact = 4, spatial = 8 };

/// A set of effects.
using EffectMask = std::uint32_t;

[[nodiscard]] constexpr EffectMask mask_of(Effect effect) { return static_cast<EffectMask>(effect); }
[[nodiscard]] constexpr bool has(EffectMask mask, Effect effect) { return (mask & mask_of(effect)) != 0; }
/// Is every effect of `part` in `whole`?
[[nodiscard]] constexpr bool holds_all(EffectMask whole, EffectMask part) { return (part & ~whole) == 0; }

/// Line of an effect in `overturn list`.
struct EffectEntry {
    Effect value;
    std::string_view name;
    std::string_view summary;  ///< its physics, and when it is required
};

}  // namespace overturn
