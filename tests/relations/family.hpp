/// The models on their bases, and scenes of them drawn by seed, with levels at their thresholds.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <ostream>
#include <random>
#include <vector>

#include "motion/ground_motion.hpp"
#include "relations/study.hpp"

namespace overturn::testing {

/// A model on a base: on compliant points in the plane, unless it says otherwise.
struct Family {
    char const* name;
    char const* base = "";  ///< as Solid::base
    bool points = true;     ///< on compliant points: it steps, and its pad has a frequency
    bool space = false;     ///< shaken along y too
    /// Of `include`: auto would go on to points of the usual pad, which no scale changes.
    char const* effects = space ? "'vertical', 'sliding', 'contact', 'spatial'" : "'vertical', 'sliding', 'contact'";
    double least_friction = 0.8, most_friction = 1.6;  ///< over b/h; 0: it does not slip
    bool polygon = false;
    bool own_restitution = false;  ///< else what base and pad give
    bool matched = true;           ///< its bed and points are tuned to its restitution
    double strength_mpa = 0;
};

inline void PrintTo(Family const& family, std::ostream* out) { *out << family.name; }

/// Without points; of its own restitution.
constexpr Family rigid(char const* name, char const* effects, double least_friction, double most_friction) {
    return {.name = name,
            .points = false,
            .effects = effects,
            .least_friction = least_friction,
            .most_friction = most_friction,
            .own_restitution = true};
}
inline constexpr std::array families{
    rigid("rigid rocking", "'vertical'", 0, 0),
    rigid("sliding", "'vertical', 'sliding'", 0.3, 0.9),
    rigid("slide-rock", "'vertical', 'sliding'", 1.02, 1.4),
    Family{.name = "contact corners", .base = "bedding='corners'", .own_restitution = true},
    Family{.name = "contact 2 points", .base = "bedding='corners'", .matched = false},
    Family{.name = "contact flat", .base = "bedding='flat', points=5"},
    Family{.name = "contact crushed", .base = "bedding=0.5, points=5", .strength_mpa = 1},
    Family{.name = "space corners", .base = "bedding='corners', points=5", .space = true, .own_restitution = true},
    Family{.name = "space 4 points", .base = "bedding='corners'", .space = true, .matched = false},
    Family{.name = "space flat", .base = "bedding='flat', points=4", .space = true},
    Family{.name = "space rim", .base = "shape='round'", .space = true},
    Family{.name = "space polygon", .base = "shape='polygon'", .space = true, .polygon = true}};

/// Numbers drawn by a seed, the same on every machine.
class Draws {
  public:
    explicit Draws(std::uint64_t seed) : engine_(seed) {}
    [[nodiscard]] double between(double low, double high) {
        return low + (high - low) * (static_cast<double>(engine_() >> 11U) * 0x1p-53);
    }
    /// White noise through a filter of the ground, with a peak of 1000 gal and silent ends; a dyadic number of gal.
    [[nodiscard]] std::vector<double> wave(std::size_t samples, double step_s);

  private:
    std::mt19937_64 engine_;
};

inline std::vector<double> Draws::wave(std::size_t samples, double step_s) {
    double const w = 2 * pi * between(0.6, 2.0);
    double const damping = between(0.2, 0.6);
    double u = 0;
    double v = 0;
    std::vector<double> wave(samples);
    for (std::size_t i = 0; i < samples; ++i) {
        double const noise = between(-1, 1) + between(-1, 1) + between(-1, 1);
        v += (noise - 2 * damping * w * v - w * w * u) * step_s;
        u += v * step_s;
        double const swell = std::sin(pi * static_cast<double>(i) / static_cast<double>(samples - 1));
        wave[i] = (w * w * u + 2 * damping * w * v) * (i + 1 == samples ? 0 : std::sqrt(std::abs(swell)));
    }
    double const peak = peak_of(wave);
    for (double& a : wave) {
        a = std::round(a / peak * 1000 * 1024) / 1024;
    }
    return wave;
}

inline Solid drawn_solid(Family const& family, Draws& draw, std::string const& name) {
    double const width = draw.between(0.5, 2.0);
    double const slenderness = draw.between(1.2, 3.0);
    double const housner = 1 - 1.5 / (1 + slenderness * slenderness);
    Solid solid{.name = name,
                .mass_kg = draw.between(500, 100e3),
                .width_m = width,
                .centre_height_m = width / 2 * slenderness,
                .restitution = housner + (1 - housner) * draw.between(0.03, 0.25),
                .base = family.base};
    if (!family.own_restitution) {
        solid.restitution.reset();
    }
    if (family.most_friction > 0) {
        double const kinetic = draw.between(family.least_friction, family.most_friction) / slenderness;
        solid.friction = {family.points ? kinetic : std::min(1.1 * kinetic, family.most_friction / slenderness),
                          kinetic};
    }
    if (family.polygon) {
        double const half = width / 2;
        double const cut = half * draw.between(0.45, 0.9);
        solid.corners_m = {{half, cut},   {cut, half},   {-cut, half}, {-half, cut},
                           {-half, -cut}, {-cut, -half}, {cut, -half}, {half, -cut}};
    }
    solid.matched = family.matched;
    solid.pad_hz = family.points ? draw.between(30, 60) : 0;
    solid.strength_pa =
        family.strength_mpa * 1e6 * draw.between(1, 2) * (solid.mass_kg * g0 / (solid.width_m * solid.width_m) / 1e5);
    return solid;
}

/// The highest of these levels below which nothing of a wave and a body falls, and the next one, which falls.
inline std::optional<std::array<double, 2>> falls_between(Study study, std::size_t motion, std::size_t solid) {
    study.motions = {study.motions[motion]};
    study.solids = {study.solids[solid]};
    double const lift =
        study.solids[0].width_m / 2 / study.solids[0].centre_height_m * g0 / (peak_of(study.motions[0].gal[0]) * 1e-2);
    std::array bracket{lift, 6 * lift};
    for (int round = 0; round < 3; ++round) {
        study.factors.clear();
        constexpr int steps = 8;
        for (int i = 0; i <= steps; ++i) {
            study.factors.push_back(bracket[0] + (bracket[1] - bracket[0]) * i / steps);
        }
        auto const rows = run(study);
        std::size_t first = 0;
        while (first < rows.rows.size() && rows.at(first, "peak_rotation") < 1.57) {
            ++first;
        }
        if (first == 0 || first == rows.rows.size()) {
            return {};
        }
        bracket = {study.factors[first - 1], study.factors[first]};
    }
    return bracket;
}

/// Two motions and two bodies, at three levels and, of each motion with one body, just below and above uplift, slip and
/// the first fall.
inline Study drawn_study(Family const& family, std::uint64_t seed, std::size_t samples = 768) {
    Draws draw(seed);
    Study study{.motions = {}, .solids = {}, .factors = {}, .effects = family.effects};
    for (std::size_t i = 0; i < 2; ++i) {
        Motion motion;
        motion.gal[0] = draw.wave(samples, study.step_s);
        if (family.space) {
            motion.gal[1] = draw.wave(samples, study.step_s);
            double const share = draw.between(0.5, 1);
            std::ranges::transform(motion.gal[1], motion.gal[1].begin(),
                                   [&](double a) { return std::round(a * share * 1024) / 1024; });
        }
        if (i == 1) {
            motion.gal[2] = draw.wave(samples, study.step_s);
            std::ranges::transform(motion.gal[2], motion.gal[2].begin(), [](double a) { return a / 4; });
        }
        study.motions.push_back(motion);
        study.solids.push_back(drawn_solid(family, draw, i == 0 ? "a" : "b"));
    }
    std::vector<double> factors;
    for (std::size_t i = 0; i < 2; ++i) {
        auto const& solid = study.solids[i];
        double const one_g = g0 / (peak_of(study.motions[i].gal[0]) * 1e-2);
        double const uplift = solid.width_m / 2 / solid.centre_height_m * one_g;
        constexpr double near = 0x1p-20;
        factors.insert(factors.end(), {uplift * (1 - near), uplift * (1 + near), uplift * draw.between(1.2, 3)});
        if (solid.friction) {
            double const slip = (*solid.friction)[0] * one_g;
            factors.insert(factors.end(), {slip * (1 - near), slip * (1 + near)});
        }
        if (auto const fall = falls_between(study, i, i)) {
            factors.insert(factors.end(), {(*fall)[0], (*fall)[1]});
        }
    }
    std::ranges::sort(factors);
    factors.erase(std::unique(factors.begin(), factors.end()), factors.end());
    study.factors = factors;
    return study;
}

}  // namespace overturn::testing
