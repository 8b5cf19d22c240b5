#include "campaign/site.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "config/suggestion.hpp"

namespace overturn {
namespace {

using config::Range;
using config::Table;

constexpr config::Keys side_keys{
    config::number_key("plus_x", Dimension::length, Range::positive(),
                       "in the direction of the first horizontal component")
        .optional(),
    config::number_key("minus_x", Dimension::length, Range::positive(), "against it").optional(),
    config::number_key("plus_y", Dimension::length, Range::positive(),
                       "in the direction of the second horizontal component")
        .optional(),
    config::number_key("minus_y", Dimension::length, Range::positive(), "against it").optional()};
constexpr config::KeyTable sides_table{
    .meaning = "distances from the edge of the base, by direction; not stated: no obstacle there",
    .keys = side_keys.all};

constexpr config::Key sides_key(std::string_view name, std::string_view meaning) {
    return config::number_key(name, Dimension::length, Range::positive(), meaning)
        .or_as(config::table_key<sides_table>(name, ""))
        .optional();
}

constexpr config::Keys site_keys{
    sides_key("cask",
              "distance from the edge of the base to another cask, which moves too; one value, or by direction"),
    sides_key("wall", "distance to a wall or fixed object; one value, or by direction"),
    sides_key("edge", "distance to the edge of the pad; one value, or by direction"),
    config::text_key("cask_body",
                     "name of the body used as the other cask; it moves as in its trial of the same wave and level")
        .otherwise_in_words("the body itself"),
    config::number_key("height", Dimension::length, Range::positive(), "height of the top of a body above its base")
        .otherwise_in_words("from its parts, or twice centre_height"),
    config::number_key("width", Dimension::length, Range::positive(), "largest width of a body")
        .otherwise_in_words("from its parts, or base_width")};

Sides read_sides(Table const& table, config::Key const& key) {
    Sides sides;
    if (table.kind(key.name) == config::Kind::table) {
        auto const inner = table.child(key);
        for (std::size_t i = 0; i < Sides::count; ++i) {
            sides.m[i] = inner.maybe_number(side_keys.all[i]).value_or(sides.m[i]);
        }
        inner.finish();
        if (!sides.any()) {
            table.fail(key.name, "empty (no direction). State plus_x, minus_x, plus_y or minus_y");
        }
    } else if (table.has(key.name)) {
        sides.m.fill(table.number(key));
    }
    return sides;
}

std::optional<std::string> stated_cask_body(Table const& table) {
    return table.has("cask_body") ? std::optional(table.text(site_keys["cask_body"])) : std::nullopt;
}

double top_of(BodyPart const& part) {
    return std::visit(
        [](auto const& one) {
            if constexpr (requires { one.bottom_height_m; }) {
                return one.bottom_height_m + one.height_m;
            } else {
                return one.height_m;
            }
        },
        part);
}

// From its axis; a lump has no width.
double half_width_of(BodyPart const& part) {
    return std::visit(
        [](auto const& one) {
            if constexpr (requires { one.radius_m; }) {
                return one.radius_m;
            } else if constexpr (requires { one.width_m; }) {
                return one.width_m / 2;
            } else {
                return 0.0;
            }
        },
        part);
}

}  // namespace

constinit config::KeyTable const site_table{.meaning = "surroundings: other casks, walls, edge of the pad",
                                            .keys = site_keys.all};

bool Sides::any() const {
    return std::ranges::any_of(m, [](double distance_m) { return std::isfinite(distance_m); });
}

double Site::top_m(BodySpec const& body, double centre_height_m) const {
    if (height_m || body.parts.empty()) {
        return height_m.value_or(2 * centre_height_m);
    }
    double top = 0;
    for (auto const& part : body.parts) {
        top = std::max(top, top_of(part));
    }
    return top;
}

double Site::widest_m(BodySpec const& body) const {
    if (width_m) {
        return *width_m / 2;
    }
    double widest = 0;
    for (auto const& part : body.parts) {
        widest = std::max(widest, half_width_of(part));
    }
    return widest;
}

Site read_site(Table const& table) {
    Site site{.cask = read_sides(table, site_keys["cask"]),
              .wall = read_sides(table, site_keys["wall"]),
              .edge = read_sides(table, site_keys["edge"])};
    site.height_m = table.maybe_number(site_keys["height"]);
    site.width_m = table.maybe_number(site_keys["width"]);
    if (table.has("cask_body") && !site.cask.any()) {
        table.fail("cask_body", "without cask (no other cask is there). State how far it is, or leave it out");
    }
    (void)stated_cask_body(table);  // read_cask_body finds it among the bodies
    if (!site.has_gaps() && !site.has_edges()) {
        table.fail("", "nothing round the bodies in [site]. State cask, wall or edge");
    }
    table.finish();
    return site;
}

std::optional<std::size_t> read_cask_body(Table const& table, std::span<BodySpec const> bodies) {
    for (auto const& body : bodies) {
        double const centre_m = body.body.centre_height_m();
        if (double const top_m = table.maybe_number(site_keys["height"]).value_or(centre_m); top_m < centre_m) {
            table.fail("height", fmt::format("{:g} m (below the centre of gravity of '{}', {:g} m: its top is higher). "
                                             "State the height of its highest point",
                                             top_m, body.name, centre_m));
        }
    }
    auto const name = stated_cask_body(table);
    if (!name) {
        return std::nullopt;
    }
    auto const found = std::ranges::find(bodies, *name, &BodySpec::name);
    if (found == bodies.end()) {
        table.fail("cask_body", fmt::format("'{}' (no body of this campaign). {}", *name,
                                            config::suggestion(*name, names_of(bodies))));
    }
    return static_cast<std::size_t>(found - bodies.begin());
}

}  // namespace overturn
