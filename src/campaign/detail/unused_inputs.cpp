#include "campaign/detail/unused_inputs.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "campaign/moves_in_space.hpp"

namespace overturn {
namespace {

// "bodies[2].pad.strength": body 2, and "pad.strength".
struct BodyKey {
    std::size_t body = 0;
    std::string_view key;
};

std::optional<BodyKey> body_key(std::string_view key) {
    constexpr std::string_view begin = "bodies[";
    if (!key.starts_with(begin)) {
        return std::nullopt;
    }
    BodyKey found;
    auto const [end, error] = std::from_chars(key.data() + begin.size(), key.data() + key.size(), found.body);
    found.key = key.substr(end - key.data());
    constexpr std::string_view close = "].";
    if (error != std::errc() || !found.key.starts_with(close)) {
        return std::nullopt;
    }
    found.key.remove_prefix(close.size());
    return found;
}

bool is_of(std::string_view key, std::string_view table) {
    return key.starts_with(table) && (key.size() == table.size() || key[table.size()] == '.');
}

bool allows(CampaignSpec const& spec, Effect effect) { return has(spec.effects.wanted(), effect); }

// Does every trial that is followed run on points, a rim or a disc?
bool always_on_compliant_base(CampaignSpec const& spec, BodySpec const& body) {
    auto const& base = body.footing.base;
    bool const in_space_alone = base.continuous() || base.shape == BaseShape::polygon;
    bool const by_base = !base.on_corners() && allows(spec, in_space_alone ? Effect::spatial : Effect::contact);
    bool const stated = has(spec.effects.include, Effect::contact) || has(spec.effects.include, Effect::spatial);
    return (by_base || stated) && !body.body.needs_planar_rocking();
}

bool may_move_about_all_axes(CampaignSpec const& spec, BodySpec const& body) {
    auto const& base = body.footing.base;
    bool const by_base = base.continuous() || base.shape == BaseShape::polygon;
    return may_move_in_space(spec, body) || (by_base && allows(spec, Effect::spatial));
}

bool states_kinetic_friction(CampaignSpec const& spec, std::size_t body) {
    auto const key = fmt::format("bodies[{}].friction.kinetic", body);
    return std::ranges::find(spec.inputs, key, &config::InputValue::key) != spec.inputs.end();
}

}  // namespace

bool is_unused(config::InputValue const& value, CampaignSpec const& spec) {
    auto const found = body_key(value.key);
    if (!found || found->body >= spec.bodies.size()) {
        return false;
    }
    auto const& [number, key] = *found;
    auto const& body = spec.bodies[number];
    bool const compliant = always_on_compliant_base(spec, body);
    if (is_of(key, "restitution")) {
        auto const& footing = body.footing;
        bool const matched = footing.base.shape != BaseShape::polygon && footing.pad.match_restitution;
        return compliant && !matched;
    }
    if (is_of(key, "friction")) {
        bool const by_kinetic_alone = compliant && states_kinetic_friction(spec, number);
        return !allows(spec, Effect::sliding) || (is_of(key, "friction.static") && by_kinetic_alone);
    }
    if (is_of(key, "base") || is_of(key, "pad")) {
        return !allows(spec, Effect::contact) && !allows(spec, Effect::spatial);
    }
    return (key == "inertia_y" || key == "inertia_z") && !may_move_about_all_axes(spec, body);
}

}  // namespace overturn
