#include "campaign/site.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <variant>

namespace overturn {
namespace {

using config::Range;
using config::Table;

// In the order of Sides.
constexpr std::array<std::string_view, Sides::count> edge_columns{"edge_x_most", "edge_x_least", "edge_y_most",
                                                                  "edge_y_least"};

constexpr config::Keys side_keys{
    config::number_key("plus_x", Dimension::length, Range::positive(), "along the first horizontal component")
        .optional(),
    config::number_key("minus_x", Dimension::length, Range::positive(), "against it").optional(),
    config::number_key("plus_y", Dimension::length, Range::positive(), "along the other horizontal component")
        .optional(),
    config::number_key("minus_y", Dimension::length, Range::positive(), "against it").optional()};
constexpr config::KeyTable sides_table{.meaning =
                                           "distances from the edge of the base, by direction; one that is not "
                                           "stated: nothing is there",
                                       .keys = side_keys.all};

constexpr config::Key sides_key(std::string_view name, std::string_view meaning) {
    return config::number_key(name, Dimension::length, Range::positive(), meaning)
        .or_as(config::table_key<sides_table>(name, ""))
        .optional();
}

constexpr config::Keys site_keys{
    sides_key("cask",
              "to another cask of the kind, which moves too: from the edge of the base all round, or by direction"),
    sides_key("wall", "to what stands still, likewise"), sides_key("edge", "to the edge of the pad, likewise"),
    config::number_key("height", Dimension::length, Range::positive(), "of the highest point of a body above its base")
        .otherwise_said("that of its parts, or twice centre_height")};

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

// From the axis to the furthest point of the base, to either side.
std::array<double, Sides::count> at_rest_m(BodySpec const& body) {
    std::array<double, Sides::count> furthest{};
    for (auto const& [x, y] : body.footing.base.corners_m) {
        furthest = {std::max(furthest[0], x), std::max(furthest[1], -x), std::max(furthest[2], y),
                    std::max(furthest[3], -y)};
    }
    if (body.footing.base.corners_m.empty()) {
        furthest.fill(body.body.half_width_m());
    }
    return furthest;
}

}  // namespace

constinit config::KeyTable const site_table{.meaning = "what is round the bodies: other casks, walls, the pad's edges",
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

Site read_site(Table const& table) {
    Site site{.cask = read_sides(table, site_keys["cask"]),
              .wall = read_sides(table, site_keys["wall"]),
              .edge = read_sides(table, site_keys["edge"])};
    site.height_m = table.maybe_number(site_keys["height"]);
    if (!site.has_gaps() && !site.has_edges()) {
        table.fail("", "nothing round the bodies in [site]. State cask, wall or edge");
    }
    table.finish();
    return site;
}

SiteJudge::SiteJudge(Site const& site, std::span<BodySpec const> bodies, Ladder const& ladder)
    : site_(site), bodies_(bodies) {
    for (auto const& [traits, offset] : ladder.own_parts()) {
        OfModel model{traits->number, {}};
        bool all = true;
        for (std::size_t i = 0; i < Sides::count; ++i) {
            auto const found = std::ranges::find(traits->fields, edge_columns[i], &Field::name);
            all = all && found != traits->fields.end();
            if (all) {
                model.edges[i] = *found;
                model.edges[i].offset += offset;
            }
        }
        if (all) {
            models_.push_back(std::move(model));
        }
    }
}

// How far a body came to each side of its place at most: its base, and any of it.
SiteJudge::Ways SiteJudge::ways_of(TrialRow const& row, std::size_t body, std::span<std::byte const> own) const {
    auto const& spec = bodies_[body];
    double const lean_m = site_.top_m(spec, row.centre_height_m) * std::sin(std::min(row.peak_rotation_rad, pi / 2));
    auto const model = std::ranges::find(models_, row.rung, &OfModel::rung);
    if (model == models_.end() || own.empty()) {
        double const slip_m = row.peak_slip_m;
        return {{slip_m, slip_m, 0, 0}, {slip_m + lean_m, slip_m + lean_m, 0, 0}};
    }
    Ways ways{at_rest_m(spec), {}};
    for (std::size_t i = 0; i < Sides::count; ++i) {
        double const gone_m = std::abs(real_at(own, model->edges[i])) - ways.base_m[i];
        ways.base_m[i] = gone_m < 0 ? 0 : gone_m;
        ways.all_m[i] = ways.base_m[i] + lean_m;
    }
    return ways;
}

void SiteJudge::fill(TrialRow& row, std::size_t body, std::span<std::byte const> own) const {
    constexpr auto needed = mask_of(Effect::sliding) | mask_of(Effect::spatial);
    auto const missed = static_cast<EffectMask>(row.called) & ~static_cast<EffectMask>(row.effects);
    if (!asked() || (missed & needed) != 0) {
        return;
    }
    auto const ways = ways_of(row, body, own);
    double clearance_m = std::numeric_limits<double>::infinity();
    double margin_m = clearance_m;
    auto const lower = [](double& least, double distance_m, double way_m) {
        double const left_m = distance_m - way_m;
        if (std::isfinite(distance_m)) {
            least = std::isnan(least) || left_m >= least ? least : left_m;  // what is not known stays so
        }
    };
    for (std::size_t i = 0; i < Sides::count; ++i) {
        lower(clearance_m, site_.cask.m[i], 2 * ways.all_m[i]);
        lower(clearance_m, site_.wall.m[i], ways.all_m[i]);
        lower(margin_m, site_.edge.m[i], ways.base_m[i]);
    }
    bool const known = !std::isnan(row.peak_slip_m) && !std::isnan(row.peak_rotation_rad);
    row.least_clearance_m = known && site_.has_gaps() ? clearance_m : never;
    row.edge_margin_m = known && site_.has_edges() ? margin_m : never;
}

}  // namespace overturn
