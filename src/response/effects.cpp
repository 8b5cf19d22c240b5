#include "response/effects.hpp"

#include <algorithm>
#include <array>

#include "config/registry.hpp"
#include "core/parts_of.hpp"
#include "core/units.hpp"
#include "response/registry.hpp"

namespace overturn {
namespace {

constexpr std::array modes{config::Entry<EffectMode>{"auto", "effects that each trial requires", EffectMode::automatic},
                           config::Entry<EffectMode>{"none", "plain rocking", EffectMode::none}};

}  // namespace

EffectMask EffectRequest::wanted() const {
    return mode == EffectMode::automatic ? ~EffectMask{0} : mode == EffectMode::none ? 0 : include;
}

EffectRequest parse_effect_mode(std::string const& text) {
    return {config::find_entry(std::span<config::Entry<EffectMode> const>(modes), text, "mode").value, 0};
}

EffectRequest parse_effect_list(std::vector<std::string> const& names) {
    EffectRequest request{EffectMode::forced, 0};
    for (auto const& name : names) {
        request.include |= mask_of(config::find_entry(effects(), name, "effect").value);
    }
    return request;
}

EffectRequest parse_effects(std::string const& text) {
    if (std::ranges::any_of(modes, [&](auto const& mode) { return mode.name == text; })) {
        return parse_effect_mode(text);
    }
    std::vector<std::string> names;
    for (auto const part : parts_of(text, ',')) {
        names.emplace_back(trimmed(part));
    }
    return parse_effect_list(names);
}

std::string names_of_effects(EffectMask mask) {
    std::string names;
    for (auto const& entry : effects()) {
        if (has(mask, entry.value)) {
            names += names.empty() ? "" : ", ";
            names += entry.name;
        }
    }
    return names.empty() ? "none" : names;
}

std::string text_of(EffectRequest const& request) {
    for (auto const& mode : modes) {
        if (mode.value == request.mode) {
            return std::string(mode.name);
        }
    }
    return names_of_effects(request.include);
}

}  // namespace overturn
