#include "campaign/detail/footing_spec.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "contact/contact_model.hpp"
#include "spatial/spatial_block.hpp"

namespace overturn {
namespace {

using config::Kind;
using config::Range;
using config::Table;

constexpr std::array shapes{
    config::Entry<BaseShape>{"square", "as wide as base_width, both ways", BaseShape::square},
    config::Entry<BaseShape>{"round", "of the diameter base_width", BaseShape::round},
    config::Entry<BaseShape>{"polygon", "convex, with the corners that are stated", BaseShape::polygon}};

constexpr std::array beddings{config::Entry<bool>{"corners", "nothing but the corners bears, or the rim", true},
                              config::Entry<bool>{"flat", "all of the base bears evenly", false}};
constexpr config::Keys base_keys{
    config::word_key<shapes>("shape", "outline of the base").otherwise("square"),
    config::word_key<beddings>(
        "bedding", "bearing area of a square or round base, or the corners' share of a square base's stiffness")
        .or_as(config::number_key("bedding", Dimension::none, {.low = 0, .high = 1, .low_open = true}, ""))
        .otherwise(1),
    config::number_key("inner_diameter", Dimension::length, Range::positive(),
                       "inner diameter of a ring that bears evenly out to base_width")
        .otherwise_in_words("none: a disc")
        .only("shape = round and bedding = flat"),
    config::pairs_key("corners", Dimension::length, Dimension::length,
                      "coordinates [x, y] of the corners of a convex polygon")
        .only("shape = polygon"),
    config::integer_key("points", 2, BasePlan::most_points_around,
                        "number of points from corner to corner, 2 to 41; round base: 16 to 256 points on its rim (at "
                        "most 64 in a plane), whose directions then differ")
        .otherwise_in_words("15; round base: continuous rim, or 64 points on a pad with a strength")
        .only("shape = square or round")};
constexpr config::KeyTable base_table{.meaning = "the base that a body stands on", .keys = base_keys.all};
constexpr config::Keys pad_keys{
    // Above it a bed is rigid (it settles by 2.5 nm), and its match to a restitution alone takes seconds.
    config::number_key("vertical_frequency", Dimension::frequency, {.low = 0, .high = 1e4, .low_open = true},
                       "vertical frequency of the body on its whole base")
        .otherwise(Pad{}.vertical_frequency_hz),
    config::number_key("normal_restitution", Dimension::none, {.low = 0.05, .high = 1},
                       "restitution of one point in a flat drop, at any speed")
        .otherwise(Pad{}.normal_restitution),
    config::number_key("strength", Dimension::pressure, Range::positive(),
                       "compressive strength; not stated: the pad stays elastic")
        .optional(),
    config::number_key("tangential_ratio", Dimension::none, {.low = 0.01, .high = 100},
                       "ratio of tangential to normal stiffness")
        .otherwise(Pad{}.tangential_ratio),
    config::number_key("tangential_damping", Dimension::none, Range::between(0, 100),
                       "damping ratio of tangential motion")
        .otherwise(Pad{}.tangential_damping),
    config::boolean_key("match_restitution", "adjust bed and points until the body rocks with its restitution")
        .otherwise(Pad{}.match_restitution)};
constexpr config::KeyTable pad_table{.meaning = "the pad under the base", .keys = pad_keys.all};
constexpr config::Keys footing_keys{
    config::table_key<base_table>("base", "base; not stated: two rigid corners").optional(),
    config::table_key<pad_table>("pad", "pad under the base").optional(),
    config::number_key("inertia_y", Dimension::inertia, Range::positive(),
                       "moment of inertia about the horizontal axis in the rocking plane")
        .otherwise_in_words("equal to inertia"),
    config::number_key("inertia_z", Dimension::inertia, Range::positive(), "moment of inertia about the vertical axis")
        .otherwise_in_words("that of the base's uniform solid")};

std::optional<double> read_bedding(Table const& given) {
    if (given.kind("bedding") != Kind::text) {
        return given.number(base_keys["bedding"]);
    }
    return given.choice<bool>(base_keys["bedding"], beddings) ? std::optional(1.0) : std::nullopt;
}

int read_points(Table const& given, bool round) {
    auto const points = static_cast<int>(given.integer(base_keys["points"], {}));
    if (round && (points < BasePlan::fewest_points_around || points % 4 != 0)) {
        given.fail("points", fmt::format("{} (a round base takes {} to {}, a multiple of 4). Leave it out: its rim is "
                                         "then continuous",
                                         points, BasePlan::fewest_points_around, BasePlan::most_points_around));
    }
    if (!round && points > BasePlan::most_points_across) {
        given.fail("points", fmt::format("{} (a square base takes 2 to {} from corner to corner). Leave it out: {}",
                                         points, BasePlan::most_points_across, BasePlan::points_across));
    }
    return points;
}

// A table beside a file outranks the file's keys one by one; another shape is another base. Before format 5 it was
// another base whatever it stated.
BasePlan read_base(Table const& given, BasePlan const& of_file, bool anew, bool before_format_5) {
    auto base = of_file;
    auto const shape = anew || given.has("shape") ? given.choice<BaseShape>(base_keys["shape"], shapes) : base.shape;
    bool const keeps = !anew && shape == of_file.shape;
    bool const square = shape == BaseShape::square;
    bool const round = shape == BaseShape::round;
    if (!keeps) {
        base = {.shape = shape, .points = round ? 0 : usual_points_across(before_format_5)};
    }
    if (base.shape == BaseShape::polygon && (!keeps || given.has("corners"))) {
        base.corners_m.clear();
        for (auto const& [x, y] : given.pairs(base_keys["corners"])) {
            base.corners_m.push_back({x, y});
        }
    }
    if (given.has("bedding") || (square && !keeps)) {
        auto const share = read_bedding(given);
        if (round && share.has_value() != base.corner_share.has_value()) {  // points are a rim's, a hole is a disc's
            base = {.shape = base.shape, .points = 0};
        }
        base.corner_share = share;
    }
    if (!square && base.corner_share != 1 && (!round || base.corner_share)) {
        given.fail("bedding", round ? "a round base bears on its rim (corners) or evenly (flat). State one of these"
                                    : "a polygon bears on its corners. Leave it out");
    }
    if (round && !base.corner_share && given.has("points")) {
        given.fail("points",
                   "beside bedding = \"flat\" of a round base (it bears as a whole, without points). Leave "
                   "one of them out");
    }
    if (given.has("inner_diameter")) {
        if (!round || base.corner_share) {
            given.fail("inner_diameter", "only a round base that bears evenly is a ring. State bedding = \"flat\"");
        }
        base.inner_radius_m = 0.5 * given.number(base_keys["inner_diameter"]);
    }
    if (base.shape != BaseShape::polygon && given.has("points")) {
        base.points = read_points(given, round);
    }
    given.finish();
    return base;
}

Pad read_pad(Table const& given, Pad pad, bool anew) {
    auto const number = [&](config::Key const& key, double& value) {
        value = anew || given.has(key.name) ? given.number(key) : value;
    };
    number(pad_keys["vertical_frequency"], pad.vertical_frequency_hz);
    number(pad_keys["normal_restitution"], pad.normal_restitution);
    if (given.has("strength")) {
        pad.strength_pa = given.maybe_number(pad_keys["strength"]);
    }
    number(pad_keys["tangential_ratio"], pad.tangential_ratio);
    number(pad_keys["tangential_damping"], pad.tangential_damping);
    if (anew || given.has("match_restitution")) {
        pad.match_restitution = given.boolean(pad_keys["match_restitution"]);
        pad.match_is_stated = given.has("match_restitution");
    }
    given.finish();
    return pad;
}

// Lengths, times and inertias go with the law; strength, friction and shares do not.
Footing scaled(Footing footing, std::optional<Scaling> const& scaling) {
    if (!scaling) {
        return footing;
    }
    auto const& law = scaling->law;
    auto const by = [&](double& value, double ratio) { value *= scaling->to_model ? ratio : 1 / ratio; };
    for (auto& [x, y] : footing.base.corners_m) {
        by(x, law.length);
        by(y, law.length);
    }
    by(footing.base.inner_radius_m, law.length);
    by(footing.pad.vertical_frequency_hz, law.frequency());
    for (auto* const inertia : {&footing.inertia_across_kgm2, &footing.inertia_vertical_kgm2}) {
        if (*inertia) {
            by(**inertia, law.inertia());
        }
    }
    return footing;
}

// A stated restitution that base and pad cannot give: Housner's, which nobody measured, takes the nearest instead.
void validate_match(Table const& table, BodySpec const& spec) {
    constexpr double near_enough = 0.02;  // what the amplitude makes of a base's restitution
    double const wanted = spec.body.restitution();
    double const found = spec.footing.matched->restitution;
    if (std::abs(found - wanted) > near_enough) {
        table.fail(
            "restitution",
            fmt::format("{:.4f} (the nearest that this base and pad give is {:.4f}). State that, another bedding, "
                        "or pad.match_restitution = false",
                        wanted, found));
    }
}

// The critical angle is that of the nearest edge.
void validate_width(Table const& table, RigidBody const& body, SpatialBlock const& block) {
    constexpr double same = 1e-6;
    if (std::abs(block.edge_m - body.half_width_m()) > same * block.edge_m) {
        table.fail("base_width", fmt::format("{:.9g} m (the polygon's nearest edge passes the axis at {:.9g} m). "
                                             "State \"{:.9g} m\"",
                                             2 * body.half_width_m(), block.edge_m, 2 * block.edge_m));
    }
}

}  // namespace

constinit config::KeyTable const footing_table{.meaning = "what a body stands on", .keys = footing_keys.all};

int usual_points_across(bool before_format_5) {
    return before_format_5 ? BasePlan::points_across_before_format_5 : BasePlan::points_across;
}

void read_footing(Table const& table, Footing& footing, bool before_format_5) {
    if (std::exchange(footing.rim_as_points, false)) {
        footing.base.points = 0;  // as its file says, for whatever pad this states
    }
    bool const anew = !footing.stated || before_format_5;
    if (table.has("base")) {
        footing.base = read_base(table.child(footing_keys["base"]), footing.base, anew, before_format_5);
        footing.stated = true;
    }
    if (table.has("pad")) {
        footing.pad = read_pad(table.child(footing_keys["pad"]), anew ? Pad{} : footing.pad, anew);
        footing.stated = true;
    }
    if (footing.base.continuous() && !footing.base.is_disc() && footing.pad.strength_pa) {
        footing.base.points = BasePlan::points_around;  // what a pad remembers of its crushing, it remembers by place
        footing.rim_as_points = true;
    }
    if (auto const across = table.maybe_number(footing_keys["inertia_y"])) {
        footing.inertia_across_kgm2 = across;
    }
    if (auto const vertical = table.maybe_number(footing_keys["inertia_z"])) {
        footing.inertia_vertical_kgm2 = vertical;
    }
}

void settle_footing(Table const& table, BodySpec& spec) {
    auto& footing = spec.footing;
    footing = scaled(spec.stated_footing, spec.scaling);
    auto const& base = footing.base;
    bool const states_restitution = spec.stated.restitution.has_value();
    bool const of_its_own = base.shape == BaseShape::round || base.is_bed();
    if (of_its_own && !states_restitution) {
        footing.pad.match_restitution = false;  // a bed or a rim has a restitution of its own
    }
    if (!footing.stated && !footing.inertia_across_kgm2 && !footing.inertia_vertical_kgm2) {
        return;
    }
    char const* const key = table.has("base") || !table.has("pad") ? "base" : "pad";
    auto const block = table.located(key, [&] { return spatial_block(spec.body, footing, {}); });
    if (base.shape == BaseShape::polygon) {
        if (states_restitution) {
            table.fail("restitution",
                       "stated for a polygon (its restitution is that of its corners and points). Leave "
                       "it out, and state pad.normal_restitution");
        }
        validate_width(table, spec.body, block);
        return;
    }
    table.located(key, [&] { return contact_block(spec.body, base, footing.pad, {}); });
    if (base.shape == BaseShape::square && footing.pad.match_restitution) {
        auto flattest = base;  // what a match may end with: the softest bed against turning
        flattest.points = std::max(base.points, BasePlan::points_across);
        flattest.corner_share.reset();
        table.located("pad", [&] { return contact_block(spec.body, flattest, footing.pad, {}); });
    }
    auto const& scatter = spec.scatter;
    for (auto const* const drawn : {&scatter.mass, &scatter.centre_height, &scatter.restitution}) {
        if (*drawn && (*drawn)->scatters()) {
            return;  // every draw has a match of its own
        }
    }
    footing.matched = matched_footing(spec.body, footing);
    if (footing.pad.match_restitution && states_restitution) {
        validate_match(table, spec);
    }
}

}  // namespace overturn
