#include "response/effects.hpp"

#include <array>

#include "core/units.hpp"

namespace overturn {
namespace {

constexpr std::array entries{
    config::Entry<Effect>{"vertical",
                          "vertical motion changes gravity; called for when the wave has a vertical component",
                          Effect::vertical},
    config::Entry<Effect>{
        "sliding",
        "Coulomb stick-slip, slide-rocking, slip at impacts; called for when the no-slip motion would "
        "need more friction than the static coefficient",
        Effect::sliding},
};

struct Named {
    Effect effect;
    char const* name;
};
constexpr std::array all_names{Named{Effect::vertical, "vertical"}, Named{Effect::sliding, "sliding"},
                               Named{Effect::contact, "contact"}, Named{Effect::spatial, "spatial"}};

}  // namespace

std::span<config::Entry<Effect> const> effects() { return entries; }

EffectRequest parse_effects(std::string const& text) {
    if (text == "auto") {
        return {EffectMode::automatic, 0};
    }
    if (text == "none") {
        return {EffectMode::none, 0};
    }
    EffectRequest request{EffectMode::forced, 0};
    for (std::size_t begin = 0; begin <= text.size();) {
        auto const comma = std::min(text.find(',', begin), text.size());
        auto const name = trimmed(std::string_view(text).substr(begin, comma - begin));
        request.include |= mask_of(config::find_entry(effects(), name, "effect").value);
        begin = comma + 1;
    }
    return request;
}

std::string names_of_effects(EffectMask mask) {
    std::string names;
    for (auto const& [effect, name] : all_names) {
        if (has(mask, effect)) {
            names += names.empty() ? "" : ", ";
            names += name;
        }
    }
    return names.empty() ? "none" : names;
}

}  // namespace overturn
