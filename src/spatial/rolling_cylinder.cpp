#include "spatial/rolling_cylinder.hpp"

#include <cmath>
#include <cstddef>

#include "core/units.hpp"

namespace overturn {

double RollingCylinder::spin_without_pivoting(double tilt_rad, double precession_radps) {
    return -precession_radps * std::pow(std::sin(tilt_rad), 2) / std::cos(tilt_rad);
}

double RollingCylinder::steady_precession_radps(double tilt_rad) const {
    double const s = std::sin(tilt_rad);
    double const c = std::cos(tilt_rad);
    double const spin = pivots ? 0 : spin_without_pivoting(tilt_rad, 1);
    return std::sqrt(gravity_mps2 * (radius_m * c - centre_height_m * s)
                     / (across_m2 * s * c - about_m2 * spin * s
                        + (centre_height_m * s - spin * radius_m) * (centre_height_m * c + radius_m * s)));
}

// About the vertical the ground bears a moment that only rolling without pivoting has: it is eliminated from the
// balances about the body's axis and across it, in the plane of tilt.
RollingCylinder::State RollingCylinder::rate(State const& state) const {
    auto const& [tilt, tilting, azimuth, precession, spin] = state;
    double const r = radius_m;
    double const h = centre_height_m;
    double const s = std::sin(tilt);
    double const c = std::cos(tilt);
    double const along = h * c + r * s;
    double const v = -spin * r + precession * h * s;
    double const righting = (across_m2 * precession * precession * s * c - about_m2 * spin * precession * s
                             + precession * v * along + gravity_mps2 * (h * s - r * c))
                            / (across_m2 + h * h + r * r);
    if (pivots) {
        double const spinning = tilting * (s * r * precession + h * (about_m2 / across_m2) * spin)
                                / (about_m2 / r + r + h * h * about_m2 / (r * across_m2));
        return {tilting, righting, precession,
                (about_m2 * spin * tilting - 2 * across_m2 * c * precession * tilting - (h * about_m2 / r) * spinning)
                    / (across_m2 * s),
                spinning};
    }
    // spinning = -quickening s^2 / c - turned; the acceleration across the plane of tilt likewise.
    double const turned = precession * tilting * (2 * s + s * s * s / (c * c));
    double const known = precession * tilting * (h * c + along) + r * turned;
    double const quickening = (c * (about_m2 * spin * tilting - 2 * across_m2 * precession * c * tilting)
                               - s * about_m2 * turned - along * known)
                              / (across_m2 * s * c + about_m2 * s * s * s / c + along * (h * s + r * s * s / c));
    return {tilting, righting, precession, quickening, -quickening * s * s / c - turned};
}

RollingCylinder::State RollingCylinder::after(State state, double seconds) const {
    constexpr double step = 1e-4;
    auto const steps = std::lround(seconds / step);
    double const d = seconds / static_cast<double>(steps);
    auto const moved = [](State at, State const& by, double time) {
        for (std::size_t i = 0; i < at.size(); ++i) {
            at[i] += time * by[i];
        }
        return at;
    };
    for (auto i = steps; i > 0; --i) {
        auto const first = rate(state);
        auto const second = rate(moved(state, first, d / 2));
        auto const third = rate(moved(state, second, d / 2));
        auto const fourth = rate(moved(state, third, d));
        for (std::size_t k = 0; k < state.size(); ++k) {
            state[k] += d / 6 * (first[k] + 2 * (second[k] + third[k]) + fourth[k]);
        }
    }
    return state;
}

RollingCylinder rolling_cylinder(SpatialBlock const& block, bool pivots) {
    auto const& inertia = block.inertia_over_mass_m2;
    return {block.edge_m, block.planar.centre_height_m, inertia[0], inertia[2], block.planar.gravity_mps2, pivots};
}

SpatialStart rolling_start(SpatialBlock const& block, double tilt_rad, double precession_radps, double spin_radps) {
    auto const rigid = rolling_cylinder(block);
    double const s = std::sin(tilt_rad);
    double const c = std::cos(tilt_rad);
    double const r = rigid.radius_m;
    double const h = rigid.centre_height_m;
    double const w = block.planar.vertical_radps();
    double const quickening = rigid.rate({tilt_rad, 0, 0, precession_radps, spin_radps})[1];
    double const press = rigid.gravity_mps2 + (precession_radps == 0 ? 0 : quickening * (r * c - h * s));
    double const arc = std::cbrt(3 * pi * press / (w * w * r * s));
    double const deep = r * s * (1 - std::cos(arc));
    std::array const arm{h * s - r * c, 0.0, h * c + r * s};  // from the lowest point to the centre of gravity
    return {.x_m = arm[0] + r,
            .rise_m = arm[2] - deep - h + block.planar.settlement_m(),
            .rotation_rad = {0, tilt_rad, 0},
            .velocity_mps = {0, precession_radps * h * s - spin_radps * r, 0},
            .angular_velocity_radps = {-precession_radps * s, 0, spin_radps}};
}

}  // namespace overturn
