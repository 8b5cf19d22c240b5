#include "body/joints.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

namespace overturn {
namespace {

// A part as its faces; a point has none.
struct Solid {
    double bottom_m, top_m, half_width_m, mass_kg, centre_m;
    Standing standing;
    bool has_faces;
};

template <class Part> Solid solid(Part const& part, double half_width_m) {
    return {part.bottom_height_m,
            part.bottom_height_m + part.height_m,
            half_width_m,
            part.mass_kg,
            part.bottom_height_m + part.height_m / 2,
            part.standing,
            true};
}
Solid solid_of(Cylinder const& part) { return solid(part, part.radius_m); }
Solid solid_of(Box const& part) { return solid(part, part.width_m / 2); }
Solid solid_of(PointMass const& part) {
    return {part.height_m, part.height_m, 0, part.mass_kg, part.height_m, {}, false};
}

std::vector<Solid> solids_of(std::span<BodyPart const> parts) {
    std::vector<Solid> solids;
    for (auto const& part : parts) {
        solids.push_back(std::visit([](auto const& one) { return solid_of(one); }, part));
    }
    return solids;
}

double closeness_m(std::span<Solid const> solids) {
    constexpr double share = 1e-3;
    double top_m = 0;
    for (auto const& solid : solids) {
        top_m = std::max(top_m, solid.top_m);
    }
    return share * top_m;
}

std::optional<Joint> joint_at(double level_m, std::span<Solid const> solids, double close_m) {
    constexpr double unlimited = std::numeric_limits<double>::infinity();
    Joint joint{.height_m = level_m};
    double above_m = 0, below_m = 0, moment = 0, friction = unlimited;
    joint.fastened = true;
    for (std::size_t i = 0; i < solids.size(); ++i) {
        auto const& solid = solids[i];
        bool const above = solid.bottom_m >= level_m - close_m;
        if (!above && solid.top_m > level_m + close_m) {
            return std::nullopt;
        }
        if (above) {
            joint.mass_kg += solid.mass_kg;
            moment += solid.mass_kg * (solid.centre_m - level_m);
        } else if (solid.has_faces && solid.top_m >= level_m - close_m) {
            below_m = std::max(below_m, solid.half_width_m);
        }
        if (solid.has_faces && std::abs(solid.bottom_m - level_m) <= close_m) {
            above_m = std::max(above_m, solid.half_width_m);
            friction = std::min(friction, solid.standing.friction.value_or(unlimited));
            joint.fastened = joint.fastened && solid.standing.fastened;
            joint.parts.push_back(i);
        }
    }
    if (below_m == 0) {
        return std::nullopt;
    }
    joint.half_width_m = std::min(above_m, below_m);
    joint.centre_above_m = moment / joint.mass_kg;
    if (std::isfinite(friction)) {
        joint.friction = friction;
    }
    return joint;
}

}  // namespace

double Joint::parts_at() const { return std::min(tips_at(), friction.value_or(tips_at())); }

std::vector<Joint> joints_of(std::span<BodyPart const> parts) {
    auto const solids = solids_of(parts);
    double const close_m = closeness_m(solids);
    std::vector<double> levels_m;
    for (auto const& solid : solids) {
        if (solid.has_faces && solid.bottom_m > close_m) {
            levels_m.push_back(solid.bottom_m);
        }
    }
    std::ranges::sort(levels_m);
    std::vector<Joint> joints;
    double last_m = 0;
    for (double const level_m : levels_m) {
        if (level_m <= last_m + close_m) {
            continue;
        }
        last_m = level_m;
        if (auto joint = joint_at(level_m, solids, close_m)) {
            joints.push_back(std::move(*joint));
        }
    }
    return joints;
}

std::vector<std::size_t> without_joint(std::span<BodyPart const> parts) {
    auto const solids = solids_of(parts);
    double const close_m = closeness_m(solids);
    auto const joints = joints_of(parts);
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < solids.size(); ++i) {
        auto const& solid = solids[i];
        bool const joined = std::ranges::any_of(
            joints, [&](Joint const& joint) { return std::ranges::find(joint.parts, i) != joint.parts.end(); });
        bool const inside = std::ranges::any_of(solids, [&](Solid const& other) {
            bool const wider = other.half_width_m > solid.half_width_m;
            bool const taller = other.bottom_m < solid.bottom_m - close_m || other.top_m > solid.top_m + close_m;
            return other.has_faces && (wider || (taller && other.half_width_m == solid.half_width_m))
                   && other.bottom_m <= solid.bottom_m + close_m && other.top_m >= solid.top_m - close_m;
        });
        if (solid.has_faces && solid.bottom_m > close_m && !solid.standing.fastened && !joined && !inside) {
            places.push_back(i);
        }
    }
    return places;
}

bool any_loose(std::span<BodyPart const> parts) {
    auto const solids = solids_of(parts);
    double const close_m = closeness_m(solids);
    return std::ranges::any_of(solids, [&](Solid const& solid) {
        return solid.has_faces && solid.bottom_m > close_m && !solid.standing.fastened;
    });
}

}  // namespace overturn
