// The model's own assumptions, as one table. A measured effect is one that a study of this project found; its file says
// under which waves.
#include "campaign/model_assumptions.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "body/joints.hpp"
#include "campaign/detail/stated_waves.hpp"
#include "campaign/moves_in_space.hpp"

namespace overturn {
namespace {

bool is_drawn(CampaignSpec const& spec) {
    return std::ranges::any_of(spec.inputs, [](config::InputValue const& input) {
        return input.key == "waves.source" && (input.text == "spectrum-compatible" || input.text == "filtered-noise");
    });
}

template <class Holds> Bears of_bodies(CampaignSpec const& spec, Holds const& holds) {
    return std::ranges::any_of(spec.bodies, holds) ? Bears::yes : Bears::no;
}

// May it be simulated at all?
bool allows(CampaignSpec const& spec, Effect effect) { return has(spec.effects.wanted(), effect); }

bool allows_a_bed(CampaignSpec const& spec) { return allows(spec, Effect::contact) || allows(spec, Effect::spatial); }

Bears always(CampaignSpec const& /*spec*/) { return Bears::yes; }

Bears where_no_second_component(CampaignSpec const& spec) {
    auto const may_move = [&](BodySpec const& body) { return may_move_in_space(spec, body); };
    // Of a square base the second component must be strong enough to tip or slide it.
    bool const all_move = std::ranges::all_of(spec.bodies,
                                              [&](BodySpec const& body) {
                                                  return may_move(body) && body.footing.base.shape != BaseShape::square;
                                              })
                          && always_shakes_across(spec);
    return all_move ? Bears::no : std::ranges::any_of(spec.bodies, may_move) ? Bears::where_not_required : Bears::yes;
}

Bears where_no_vertical_component(CampaignSpec const& spec) {
    bool const shaken = std::ranges::any_of(spec.bodies, [](BodySpec const& body) { return body.axes > 2; });
    return always_shakes_vertically(spec) && shaken && allows(spec, Effect::vertical) ? Bears::no : Bears::yes;
}

Bears where_rigid(CampaignSpec const& spec) { return allows_a_bed(spec) ? Bears::where_not_required : Bears::yes; }

Bears on_corners(CampaignSpec const& spec) {
    return of_bodies(spec, [&](BodySpec const& body) {
        auto const& base = body.footing.base;
        return base.on_corners() || base.shape == BaseShape::polygon || !allows_a_bed(spec);
    });
}

Bears where_pads_are_elastic(CampaignSpec const& spec) {
    return of_bodies(spec, [&](BodySpec const& body) { return !body.footing.pad.strength_pa || !allows_a_bed(spec); });
}

Bears on_points_round_a_rim(CampaignSpec const& spec) {
    return of_bodies(spec,
                     [&](BodySpec const& body) { return body.footing.base.is_rim_of_points() && allows_a_bed(spec); });
}

// On its corners a square body turns from one edge to the next, and what rolling loses hardly shows.
Bears where_bodies_roll(CampaignSpec const& spec) {
    return of_bodies(
        spec, [&](BodySpec const& body) { return !body.footing.base.on_corners() && may_move_in_space(spec, body); });
}

// What holds its place keeps no patch; what is stated as points grips by each.
Bears where_a_rim_grips(CampaignSpec const& spec) {
    return of_bodies(spec, [&](BodySpec const& body) {
        return body.friction && body.footing.base.continuous() && may_move_in_space(spec, body);
    });
}

Bears on_springs(CampaignSpec const& spec) { return allows_a_bed(spec) ? Bears::yes : Bears::no; }

Bears where_no_site(CampaignSpec const& spec) { return spec.site.has_gaps() ? Bears::no : Bears::yes; }

Bears where_parts_may_be_loose(CampaignSpec const& spec) {
    return of_bodies(spec, [](BodySpec const& body) { return body.parts.empty() || any_loose(body.parts); });
}

Bears with_friction(CampaignSpec const& spec) {
    return of_bodies(spec, [](BodySpec const& body) { return body.friction.has_value(); });
}

Bears without_friction(CampaignSpec const& spec) {
    bool const may_not_slide = spec.effects.mode == EffectMode::none || !allows(spec, Effect::sliding);
    return may_not_slide ? Bears::yes : of_bodies(spec, [](BodySpec const& body) { return !body.friction; });
}

Bears of_known_bodies(CampaignSpec const& spec) {
    return of_bodies(spec, [](BodySpec const& body) { return body.scattering().empty(); });
}

Bears of_drawn_waves(CampaignSpec const& spec) { return is_drawn(spec) ? Bears::yes : Bears::no; }

Bears of_one_spectrum(CampaignSpec const& spec) {
    return is_drawn(spec) && !spec.source->about().draws_targets ? Bears::yes : Bears::no;
}

Bears of_several_components(CampaignSpec const& spec) {
    return is_drawn(spec) && (states(spec, "waves.transverse") || states(spec, "waves.vertical")) ? Bears::yes
                                                                                                  : Bears::no;
}

constexpr std::string_view not_measured = "not measured";

constexpr std::array assumptions{
    ModelAssumption{"rigid-body", "cask, contents and pallet are one rigid body that neither bends nor breaks",
                    Misjudged::unknown, "none", not_measured, "Housner 1963", always},
    ModelAssumption{
        "fastened-parts", "the parts of a body are fastened together: a cask neither tips nor slides on its pallet",
        Misjudged::unsafe, "bodies.parts, of which plan warns",
        "by statics a cask 5.4 m high and 2.5 m wide tips on its pallet at 0.463 g; both together tip at 0.651 g",
        "campaigns/bodies/cask_prototype.toml", where_parts_may_be_loose},
    ModelAssumption{"fixed-contents", "nothing inside shifts, rattles or sloshes", Misjudged::unknown, "none",
                    not_measured, "Housner 1963", always},
    ModelAssumption{"known-bodies", "mass, size, restitution and friction are known exactly", Misjudged::unsafe,
                    "distributions in bodies",
                    "type B: beta 0.22 is 0.17 of the waves and 0.13 of the body, mostly its restitution",
                    "campaigns/margin.toml", of_known_bodies},
    ModelAssumption{"given-motion", "the motion of the pad's top is given; body and pad do not act back on the ground",
                    Misjudged::unknown, "none", not_measured,
                    "Luk et al. 2005 (NUREG/CR-6865, not consulted) model pad and soil", always},
    ModelAssumption{"level-pad", "the pad moves without tilting and is plane", Misjudged::unknown, "none", not_measured,
                    "Housner 1963", always},
    ModelAssumption{"one-plane", "the body moves in one vertical plane", Misjudged::unsafe,
                    "waves.transverse and bodies.axes",
                    "overturned of 300, one axis and two: square on corners 12 and 13 (A), 190 and 208 (B); flat 97 "
                    "and 154, 239 and 259; round 60 and 240, 230 and 300",
                    "campaigns/multi_axis.toml", where_no_second_component},
    ModelAssumption{"no-vertical-motion", "the ground does not move vertically", Misjudged::unsafe,
                    "waves.vertical and bodies.axes",
                    "overturned of 1100, without and with a vertical target of 2/3 of the horizontal: 83 and 146 (A), "
                    "690 and 713 (B)",
                    "campaigns/horizontal_vertical.toml", where_no_vertical_component},
    ModelAssumption{"rigid-ground", "base and ground are rigid: the body rotates about an edge that stays in place",
                    Misjudged::unknown, "effects.include = [\"contact\"]",
                    "overturned of 600 (A): 92 rigid, 91 on corners of 98 Hz, 96 of 67 Hz",
                    "campaigns/vertical_mode.toml", where_rigid},
    ModelAssumption{
        "corner-contact",
        "the base stands on its corners alone; an impact conserves the angular momentum about the next corner",
        Misjudged::unsafe, "bodies.base.bedding",
        "a flat base lowers the median from 2400 to 1700 gal (A), from 1110 to 790 gal (B)",
        "Housner 1963; campaigns/base_shape.toml", on_corners},
    ModelAssumption{
        "constant-restitution", "restitution does not depend on the velocity of the impact", Misjudged::unknown, "none",
        not_measured,
        "Housner 1963; on concrete others measured 0.95 and 0.97 of his value at H/B 5 and 3, or consistently more",
        always},
    ModelAssumption{"one-mass-on-springs", "on points, body, pallet and pad are one mass on one bed of springs",
                    Misjudged::unknown, "bodies.pad",
                    "overturned of 600 (A): 91 at 98 Hz, 96 at 67 Hz; on a flat base 261 and 275; of 120 on a rim, two "
                    "components, friction 0.6 just below tan(alpha): 67 at 98 Hz, none at 392 Hz",
                    "campaigns/vertical_mode.toml; src/contact/README.md", on_springs},
    ModelAssumption{"elastic-pad", "the pad is not crushed", Misjudged::unsafe, "bodies.pad.strength",
                    "overturned of 400, flat base (A): 154 elastic, 160 on 10 MPa, 224 on 3 MPa",
                    "campaigns/pad_strength.toml", where_pads_are_elastic},
    ModelAssumption{
        "rim-of-points", "a round base on a pad that yields stands on a number of points along its rim",
        Misjudged::unknown, "bodies.base.points",
        "overturned of 300 (A, 3 MPa): 127 on 64 points, 119 and 126 with the points turned, 126 on 256; under a "
        "pulse turned in plan: tilt 0.704 to 0.707 alpha, path of slip 23 to 77 mm",
        "src/contact/README.md; campaigns/guide/supports.md", on_points_round_a_rim},
    ModelAssumption{
        "rolling-loss",
        "a body that rolls on its edge loses the energy that follows from its rebound in a flat drop; if it loses "
        "less, more bodies overturn than computed",
        Misjudged::unsafe, "none",
        "overturned of 400 (A, on its rim): 161, with twice the damping 116; of 180 on a flat square base, damped as a "
        "rim: 22 more and 4 fewer",
        "src/contact/README.md; campaigns/guide/supports.md", where_bodies_roll},
    ModelAssumption{"rolling-grip", "a round base grips as one patch that rolls with its contact and does not creep",
                    Misjudged::unsafe, "bodies.base.points",
                    "of 120 (A, two components, friction 0.6) 67 fall on the rim, 78 on 64 points, 79 on 256; slip of "
                    "those that stand on both, 95 %: 0.05 and 0.30 m; at friction 0.4 nothing rolls, and both agree",
                    "src/contact/README.md; campaigns/guide/supports.md", where_a_rim_grips},
    ModelAssumption{
        "constant-friction", "Coulomb friction: the coefficients do not depend on velocity, pressure or wear",
        Misjudged::unknown, "bodies.friction", "overturned of 100 at 1200 gal (B), friction 0.2, 0.55, 0.8: 0, 82, 82",
        "campaigns/friction.toml", with_friction},
    ModelAssumption{"no-slip", "a body does not slide if it states no friction, or if sliding is switched off",
                    Misjudged::safe, "bodies.friction and effects",
                    "type A at 1950 gal: 6 of 100 overturn at friction 0.8, none at 0.55", "campaigns/friction.toml",
                    without_friction},
    ModelAssumption{"alone", "bodies touch neither each other nor a wall", Misjudged::unknown, "site",
                    "a cask of 138 t slides 0.3 m in half of the waves of 230 kine", "campaigns/slip_limit.toml",
                    where_no_site},
    ModelAssumption{"starts-at-rest", "the body stands upright and at rest when the wave begins", Misjudged::unsafe,
                    "none", not_measured, "Housner 1963", always},
    ModelAssumption{
        "ends-with-the-wave",
        "after the last sample the ground is at rest; a body that still moves is followed until it overturns or rests",
        Misjudged::unsafe, "waves.duration", not_measured, "none", always},
    ModelAssumption{"scaled-waves", "a stronger motion is the same motion scaled: same duration, same frequencies",
                    Misjudged::unknown, "levels.measure", not_measured, "none", always},
    ModelAssumption{"random-phases", "phases of generated waves are uniform and independent: no near-fault pulses",
                    Misjudged::unsafe, "waves.source = \"records\"", not_measured, "Gasparini and Vanmarcke 1976",
                    of_drawn_waves},
    ModelAssumption{"one-spectrum", "all generated waves have one target spectrum and differ by their phases only",
                    Misjudged::unsafe, "waves.variability",
                    "type B: beta over PGA 0.13 instead of 0.49; overturned of 1000 at 600 gal: 0 instead of 89",
                    "campaigns/natural_variability.toml", of_one_spectrum},
    ModelAssumption{"independent-components",
                    "components of generated waves have the stated correlation; by default none", Misjudged::unknown,
                    "correlation in waves.vertical, waves.transverse", not_measured, "none", of_several_components},
};

}  // namespace

std::string_view name_of(Misjudged direction) {
    static constexpr std::array names{"safe", "unsafe", "unknown"};
    return names.at(static_cast<std::size_t>(direction));
}

std::span<ModelAssumption const> model_assumptions() { return assumptions; }

}  // namespace overturn
