#include "campaign/site_judge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "response/registry.hpp"

namespace overturn {
namespace {

// In the order of Sides.
constexpr std::array<std::string_view, Sides::count> edge_columns{"edge_x_most", "edge_x_least", "edge_y_most",
                                                                  "edge_y_least"};
constexpr std::array<std::string_view, 2> rotation_columns{"rotation_most", "rotation_least"};

// Towards a side, of what is stored with its sign.
double towards(std::size_t side, double value) { return side % 2 == 0 ? value : -value; }

// Where a column lies in the record of all models' own; empty: this model has none of that name.
std::optional<Field> own_field(ModelTraits const& traits, std::size_t offset, std::string_view name) {
    auto const found = std::ranges::find(traits.fields, name, &Field::name);
    if (found == traits.fields.end()) {
        return std::nullopt;
    }
    auto field = *found;
    field.offset += offset;
    return field;
}

// A rigid body that left the ground: until it lies nobody follows where it flies.
bool flew(TrialRow const& row) {
    constexpr auto on_points = mask_of(Effect::contact) | mask_of(Effect::spatial);
    return !std::isnan(row.contact_lost_s) && (static_cast<EffectMask>(row.effects) & on_points) == 0;
}

bool is_known(TrialRow const& row) {
    return followed_until_s(row) == std::numeric_limits<double>::infinity() && entry_of(row.verdict).decided
           && !std::isnan(row.peak_slip_m) && !std::isnan(row.peak_rotation_rad);
}

double sine_of_lean(double angle_rad) { return std::sin(std::min(angle_rad, pi / 2)); }

// Towards +x (side 1) or -x. Of two corners that differ the row has the rotation that came nearest to its own corner's
// alpha: over the other one it may have been larger, by as much as that one's alpha is.
double largest_tilt(double side, TrialRow const& row, RigidBody const& body) {
    if (!body.lopsided() || entry_of(row.verdict).fell) {
        return row.peak_rotation_rad;
    }
    auto const& corner = body.corner(side);
    double const base_angle = std::atan(corner.half_width_m / row.centre_height_m);  // of the drawn height
    return row.peak_rotation_ratio * (base_angle + corner.alpha_rad - corner.base_angle_rad);
}

}  // namespace

double followed_until_s(TrialRow const& row) {
    constexpr double always = std::numeric_limits<double>::infinity();
    constexpr auto needed = mask_of(Effect::sliding) | mask_of(Effect::spatial);
    auto const missed = static_cast<EffectMask>(row.required) & ~static_cast<EffectMask>(row.effects);
    if ((missed & needed) != 0) {
        return -always;
    }
    if (flew(row)) {
        return row.contact_lost_s;
    }
    return always;
}

SiteJudge::SiteJudge(Site const& site, std::span<BodySpec const> bodies, ModelSelector const& selector)
    : site_(site), bodies_(bodies), bases_(bodies.begin(), bodies.end()) {
    for (auto const& [traits, offset] : selector.extra_parts()) {
        OfModel model{traits->number, {}, own_field(*traits, offset, "peak_yaw"), {}};
        for (std::size_t i = 0; i < Sides::count; ++i) {
            model.edges[i] = own_field(*traits, offset, edge_columns[i]);
        }
        for (std::size_t i = 0; i < rotation_columns.size(); ++i) {
            model.rotations[i] = own_field(*traits, offset, rotation_columns[i]);
        }
        if (model.edges[0] && model.edges[1]) {
            models_.push_back(std::move(model));
        }
    }
}

std::optional<std::size_t> SiteJudge::neighbour_of(std::int64_t body) const {
    auto const& other = site_.cask_body;
    return other && *other != static_cast<std::size_t>(body) ? other : std::nullopt;
}

// The model has the circle round the base. Its middle went no farther than that less the circle as the largest tilt
// leaves it; from there the base's own corners reach as far as turn and tilt take them. Of both bounds the nearer one.
SiteJudge::PerSide SiteJudge::spatial_ways(Trial const& trial, OfModel const& model) const {
    auto const& base = bases_[trial.row.body];
    double const tilted_m = base.farthest_m() * (1 - std::cos(std::min(trial.row.peak_rotation_rad, pi / 2)));
    double const turn_rad = std::abs(real_at(trial.extra, *model.yaw));
    PerSide ways{};
    for (std::size_t i = 0; i < Sides::count; ++i) {
        double const rest_m = base.within_m(i, 0);
        double const far_m = towards(i, real_at(trial.extra, *model.edges[i]));
        double const middle_m = far_m - base.farthest_m() + tilted_m;
        double const turned_m = middle_m + base.within_m(i, turn_rad) + tilted_m;
        ways[i] = std::min(far_m, turned_m) - rest_m;
    }
    return ways;
}

SiteJudge::PerSide SiteJudge::planar_ways(Trial const& trial, OfModel const& model) const {
    double const rest_m = bodies_[trial.row.body].body.half_width_m();
    auto const way_m = [&](std::size_t side) {
        return towards(side, real_at(trial.extra, *model.edges.at(side))) - rest_m;
    };
    return {way_m(0), way_m(1), 0, 0};
}

SiteJudge::OfModel const* SiteJudge::model_of(Trial const& trial) const {
    auto const model = std::ranges::find(models_, trial.row.model, &OfModel::model);
    return model == models_.end() || trial.extra.empty() ? nullptr : &*model;
}

// A file made before planar models stored the path of the edge has the slip alone.
SiteJudge::PerSide SiteJudge::base_ways(Trial const& trial) const {
    double const slip_m = trial.row.peak_slip_m;
    auto const* const model = model_of(trial);
    if (model == nullptr) {
        return {slip_m, slip_m, 0, 0};
    }
    auto ways = model->is_spatial() ? spatial_ways(trial, *model) : planar_ways(trial, *model);
    for (auto& way : ways) {
        bool const unknown = std::isnan(way) && !model->is_spatial();
        way = unknown ? slip_m : way < 0 ? 0 : way;  // what space does not know stays so
    }
    return ways;
}

double SiteJudge::tilt_towards(std::size_t side, Trial const& trial) const {
    auto const* const model = model_of(trial);
    if (model != nullptr && model->rotations.at(side)) {
        double const reach = towards(side, real_at(trial.extra, *model->rotations.at(side)));
        if (!std::isnan(reach)) {
            return reach;
        }
    }
    return largest_tilt(side == 0 ? 1 : -1, trial.row, bodies_[trial.row.body].body);
}

SiteJudge::PerSide SiteJudge::leans(Trial const& trial) const {
    auto const& row = trial.row;
    auto const& spec = bodies_[row.body];
    double const top_m = site_.top_m(spec, row.centre_height_m);
    auto const& body = spec.body;
    double const slope_rad = body.slope_rad();
    bool const in_space = has(static_cast<EffectMask>(row.effects), Effect::spatial);
    double const across_m = in_space ? top_m * sine_of_lean(row.peak_rotation_rad) : 0;
    return {top_m * sine_of_lean(tilt_towards(0, trial) + std::max(0.0, slope_rad)),
            top_m * sine_of_lean(tilt_towards(1, trial) + std::max(0.0, -slope_rad)), across_m, across_m};
}

std::optional<SiteJudge::Ways> SiteJudge::ways_of(Trial const& trial) const {
    if (!is_known(trial.row)) {
        return std::nullopt;
    }
    std::size_t const number = trial.row.body;
    double const widest_m = site_.widest_m(bodies_[number]);
    auto const lean_m = leans(trial);
    Ways ways{base_ways(trial), {}};
    for (std::size_t i = 0; i < Sides::count; ++i) {
        double const beyond_m = std::max(0.0, widest_m - bases_[number].within_m(i, 0));
        ways.all_m[i] = ways.base_m[i] + beyond_m + lean_m[i];
    }
    return ways;
}

void SiteJudge::fill(TrialRow& row, Trial const& trial, std::optional<Trial> const& neighbour) const {
    auto const ways = asked() ? ways_of(trial) : std::nullopt;
    auto const other = neighbour ? ways_of(*neighbour) : ways;
    if (!ways) {
        return;
    }
    constexpr double endless = std::numeric_limits<double>::infinity();
    double clearance_m = endless;
    double margin_m = endless;
    auto const lower = [](double& least, double distance_m, double way_m) {
        double const left_m = distance_m - way_m;
        if (std::isfinite(distance_m)) {
            least = std::isnan(least) || left_m >= least ? least : left_m;  // what is not known stays so
        }
    };
    for (std::size_t i = 0; i < Sides::count; ++i) {
        double const towards_m = other ? other->all_m[Sides::opposite(i)] : never;
        double const comes_m = neighbour ? towards_m : std::max(towards_m, ways->all_m[i]);
        lower(clearance_m, site_.cask.m[i], ways->all_m[i] + comes_m);
        lower(clearance_m, site_.wall.m[i], ways->all_m[i]);
        lower(margin_m, site_.edge.m[i], ways->base_m[i]);
    }
    row.least_clearance_m = site_.has_gaps() ? clearance_m : never;
    row.edge_margin_m = site_.has_edges() ? margin_m : never;
}

}  // namespace overturn
