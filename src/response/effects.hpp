/// A campaign's choice of effects.
#pragma once

#include <string>
#include <vector>

#include "model/effect.hpp"

namespace overturn {

/// Choice of effects: those that each scene needs, none at all (plain rocking), or a stated list.
enum class EffectMode { automatic, none, forced };

struct EffectRequest {
    EffectMode mode = EffectMode::automatic;
    /// Forced: those, and no others. Automatic: those in any case, as far as a scene can have them, beside what each
    /// calls for.
    EffectMask include = 0;

    /// Effects that may be simulated; all of them where each scene calls for its own.
    [[nodiscard]] EffectMask wanted() const;
};

/// "auto" or "none". \throws InputError with a suggestion
[[nodiscard]] EffectRequest parse_effect_mode(std::string const& text);
/// Names of effects that are forced on. \throws InputError on an unknown one
[[nodiscard]] EffectRequest parse_effect_list(std::vector<std::string> const& names);
/// "auto", "none" or a comma separated list of effect names. \throws InputError on an unknown name
[[nodiscard]] EffectRequest parse_effects(std::string const& text);

/// "vertical, sliding"; "none" for the empty set.
[[nodiscard]] std::string names_of_effects(EffectMask mask);
/// "auto", "none" or the forced ones, as parse_effects reads them.
[[nodiscard]] std::string text_of(EffectRequest const& request);

}  // namespace overturn
