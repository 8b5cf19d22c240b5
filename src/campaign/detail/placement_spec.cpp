#include "campaign/detail/placement_spec.hpp"

#include <cmath>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

#include "response/effects.hpp"

namespace overturn {

using config::Range;
using config::Table;

char const* BodySpec::planar_key() const {
    return stated.offset_m != 0           ? "offset"
           : stated.slope_rad != 0        ? "slope"
           : stated.initial_tilt_rad != 0 ? "initial_tilt"
                                          : nullptr;
}

namespace {

constexpr config::Keys placement_keys{
    config::number_key("offset", Dimension::length, Range::any(),
                       "offset of the centre of gravity from the middle of the base, towards +x")
        .otherwise(0),
    config::number_key("slope", Dimension::angle, Range::any(), "slope of the ground, falling towards +x").otherwise(0),
    config::number_key("initial_tilt", Dimension::angle, Range::any(), "rotation at t = 0, released from rest")
        .otherwise(0)};

}  // namespace

constinit config::KeyTable const placement_table{.meaning = "what is not straight about a body and its pad",
                                                 .keys = placement_keys.all};

// Where the centre of gravity, the ground and the body's axis are off what symmetry would have.
void read_placement(Table const& table, BodySpec& spec) {
    for (auto const& [key, value] : {std::pair{placement_keys["offset"], &BodyInput::offset_m},
                                     {placement_keys["slope"], &BodyInput::slope_rad},
                                     {placement_keys["initial_tilt"], &BodyInput::initial_tilt_rad}}) {
        if (table.has(key.name)) {
            spec.stated.*value = table.number(key);
            auto placed = spec.stated;
            placed.restitution = placed.restitution.value_or(0);  // which one is judged when all is read
            (void)table.located(key.name, [&] { return RigidBody(placed); });
        }
    }
}

// What the planar models of rocking and sliding hold and no other: the rest of the table must not ask for another.
void validate_placement(Table const& table, BodySpec const& spec) {
    auto const* const key = spec.planar_key();
    if (key == nullptr) {
        return;
    }
    auto const& footing = spec.stated_footing;
    if (footing.stated || footing.inertia_across_kgm2 || footing.inertia_vertical_kgm2) {
        auto const* const what = footing.stated ? "base or pad" : "inertia_y or inertia_z";
        table.fail(table.has(key) ? key : "",
                   fmt::format("{} beside {} (not supported on compliant points or in space). Leave one of them out",
                               key, what));
    }
    double const runs = std::tan(std::abs(spec.stated.slope_rad));
    auto const& held = spec.scatter.friction;
    if (held && runs > 0) {
        double const least = held->lowest() * spec.friction->kinetic_coefficient / spec.friction->static_coefficient;
        if (!(least > runs)) {
            table.fail(table.has("slope") ? "slope" : "friction",
                       fmt::format("friction down to {:.4g} on a slope of tan {:.4g} (once it slips it would never "
                                   "stop). Raise it{}, or lower the slope",
                                   least, runs, held->scatters() ? " by its key low" : ""));
        }
    }
}

namespace {

bool shakes_across(Table const& waves, CampaignSpec const& spec) {
    if (waves.has("transverse")) {
        return true;
    }
    auto const count =
        spec.source->about().available && spec.source->about().grid_periods_s.empty() ? spec.wave_count : 0;
    for (std::int64_t wave = 0; wave < count; ++wave) {
        std::uint64_t const number = wave;
        if (spec.source->drift(number)
            && !spec.source->make_unjudged(spec.seed, number).motion.transverse_mps2.empty()) {
            return true;
        }
    }
    return false;
}

}  // namespace

// Offset, slope and initial tilt live in the models of one plane: what calls for others is refused, not left out.
void check_planar(Table const& effects, Table const& waves, CampaignSpec const& spec) {
    auto const dearer = mask_of(Effect::contact) | mask_of(Effect::spatial);
    for (auto const& body : spec.bodies) {
        auto const* const key = body.planar_key();
        if (key == nullptr) {
            continue;
        }
        if ((spec.effects.include & dearer) != 0) {
            effects.fail("include",
                         fmt::format("{} beside {} of '{}' (only rocking and sliding in one plane hold it). Leave one "
                                     "of them out",
                                     names_of_effects(spec.effects.include & dearer), key, body.name));
        }
        if (spec.effects.mode == EffectMode::automatic && body.axes >= 2 && shakes_across(waves, spec)) {
            waves.fail(waves.has("transverse") ? "transverse" : "",
                       fmt::format("a transverse component beside {} of '{}' (only rocking and sliding in one plane "
                                   "hold it). State axes = 1 for the body, or leave one of them out",
                                   key, body.name));
        }
    }
}

void check_planar_limits(Table const& root, CampaignSpec const& spec) {
    auto const dearer = mask_of(Effect::contact) | mask_of(Effect::spatial);
    for (auto const& body : spec.bodies) {
        auto const* const key = body.planar_key();
        if (key != nullptr && (spec.effects.include & dearer) != 0) {
            root.fail("limits", fmt::format("a quantity of {} beside {} of '{}' (only rocking and sliding in one plane "
                                            "hold it). Leave one of them out",
                                            names_of_effects(spec.effects.include & dearer), key, body.name));
        }
        if (spec.accuracy.rocking.restoring == Restoring::linear && body.body.lopsided()) {
            root.child("accuracy")
                .fail("restoring",
                      fmt::format("linear beside {} of '{}' (corners that differ are followed with sin and cos "
                                  "as they are). Use nonlinear",
                                  key, body.name));
        }
        if (spec.rare && body.stated.initial_tilt_rad != 0) {
            root.fail("rare", fmt::format("beside initial_tilt of '{}' (rare events are sought from rest). Leave one "
                                          "of them out",
                                          body.name));
        }
    }
}

}  // namespace overturn
