/// The physical mechanisms that a trial may include, and how a campaign asks for them.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "config/registry.hpp"

namespace overturn {

/// One bit each; values are stored in results files: never renumber them. `contact` and `spatial` are reserved rungs.
enum class Effect : std::uint32_t { vertical = 1, sliding = 2, contact = 4, spatial = 8 };

/// A set of effects.
using EffectMask = std::uint32_t;

[[nodiscard]] constexpr EffectMask mask_of(Effect effect) { return static_cast<EffectMask>(effect); }
[[nodiscard]] constexpr bool has(EffectMask mask, Effect effect) { return (mask & mask_of(effect)) != 0; }

/// How effects are chosen: what each scene calls for, none at all (plain rocking), or a stated list.
enum class EffectMode { automatic, none, forced };

struct EffectRequest {
    EffectMode mode = EffectMode::automatic;
    EffectMask include = 0;  ///< read where mode is forced
};

/// The effects that can be simulated today, each with the line that `overturn list` prints.
[[nodiscard]] std::span<config::Entry<Effect> const> effects();

/// "auto", "none" or a comma separated list of effect names. \throws InputError on an unknown name
[[nodiscard]] EffectRequest parse_effects(std::string const& text);

/// "vertical, sliding"; "none" for the empty set.
[[nodiscard]] std::string names_of_effects(EffectMask mask);

}  // namespace overturn
