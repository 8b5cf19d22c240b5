/// Relations: what is done to a campaign, and what that does to its rows.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "relations/family.hpp"
#include "relations/study.hpp"

namespace overturn::testing {

/// What a column of the first campaign is in the changed one.
struct Image {
    std::string column;
    double factor = 1;
};

inline constexpr auto nowhere = static_cast<std::size_t>(-1);

struct Relation {
    std::string name;
    std::function<bool(Family const&)> holds;
    std::function<void(Study&)> change;
    /// Factors of length, time and mass: columns go by their units.
    double length = 1, time = 1, mass = 1;
    std::map<std::string, Image> images = {};  ///< of columns that are not themselves
    std::vector<std::string> untold = {};      ///< columns of which it says nothing
    std::vector<std::string> told = {};        ///< where not empty: it speaks of these columns alone
    /// Place in the changed campaign of (motion, solid, level) of the first.
    std::function<std::array<std::size_t, 3>(Study const&, std::array<std::size_t, 3>)> place =
        [](Study const&, std::array<std::size_t, 3> at) { return at; };
};

inline void each(std::vector<double>& values, double factor) {
    for (double& value : values) {
        value *= factor;
    }
}

/// (x, y) -> matrix (x, y) of both horizontal components.
inline void turn(Study& study, double xx, double xy, double yx, double yy) {
    for (auto& motion : study.motions) {
        auto const x = motion.gal[0];
        auto const y = motion.gal[1].empty() ? std::vector<double>(x.size(), 0.0) : motion.gal[1];
        for (std::size_t i = 0; i < x.size(); ++i) {
            motion.gal[0][i] = xx * x[i] + xy * y[i];
            if (!motion.gal[1].empty()) {
                motion.gal[1][i] = yx * x[i] + yy * y[i];
            }
        }
    }
}

/// Units of length, time and mass by other ones: the same campaign of larger or smaller bodies.
inline void scale(Study& study, double length, double time, double mass) {
    double const acceleration = length / (time * time);
    for (auto& motion : study.motions) {
        for (auto& wave : motion.gal) {
            each(wave, acceleration);
        }
    }
    study.step_s *= time;
    study.least_move_m *= length;
    for (auto& solid : study.solids) {
        solid.mass_kg *= mass;
        solid.width_m *= length;
        solid.centre_height_m *= length;
        solid.gravity_mps2 *= acceleration;
        solid.pad_hz /= time;
        solid.strength_pa *= mass / (length * time * time);
        for (auto& corner : solid.corners_m) {
            corner = {corner[0] * length, corner[1] * length};
        }
    }
}

/// The same polygon of a motion with a sample more amid every two.
inline void halve_step(Study& study) {
    for (auto& motion : study.motions) {
        for (auto& wave : motion.gal) {
            std::vector<double> fine;
            for (std::size_t i = 0; i < wave.size(); ++i) {
                fine.push_back(wave[i]);
                if (i + 1 < wave.size()) {
                    fine.push_back((wave[i] + wave[i + 1]) / 2);
                }
            }
            wave = fine;
        }
    }
    study.step_s /= 2;
}

inline void quiet_behind(Study& study) {
    for (auto& motion : study.motions) {
        for (auto& wave : motion.gal) {
            wave.resize(wave.empty() ? 0 : wave.size() + static_cast<std::size_t>(4 / study.step_s));
        }
    }
}

inline bool always(Family const&) { return true; }
inline bool in_the_plane(Family const& family) { return !family.space; }
inline bool spatial(Family const& family) { return family.space; }

// Columns that change sign, by what is mirrored.
inline std::map<std::string, Image> along(double x, double y) {
    std::map<std::string, Image> images{{"spatial.residual_x", {"spatial.residual_x", x}},
                                        {"spatial.residual_y", {"spatial.residual_y", y}},
                                        {"spatial.yaw", {"spatial.yaw", x * y}}};
    for (auto const& [axis, sign] : {std::pair{"x", x}, std::pair{"y", y}}) {
        for (auto const& [one, other] : {std::pair{"most", "least"}, std::pair{"least", "most"}}) {
            images[fmt::format("spatial.edge_{}_{}", axis, one)] = {
                fmt::format("spatial.edge_{}_{}", axis, sign < 0 ? other : one), sign};
        }
    }
    return images;
}

// The axes exchanged, with these signs: what was x is y times `x`.
inline std::map<std::string, Image> across(double x, double y) {
    std::map<std::string, Image> images{{"spatial.residual_x", {"spatial.residual_y", x}},
                                        {"spatial.residual_y", {"spatial.residual_x", y}},
                                        {"spatial.yaw", {"spatial.yaw", -x * y}}};
    for (auto const& [axis, image, sign] : {std::tuple{"x", "y", x}, std::tuple{"y", "x", y}}) {
        for (auto const& [one, other] : {std::pair{"most", "least"}, std::pair{"least", "most"}}) {
            images[fmt::format("spatial.edge_{}_{}", axis, one)] = {
                fmt::format("spatial.edge_{}_{}", image, sign < 0 ? other : one), sign};
        }
    }
    return images;
}

// In one plane, of every model that says where the base went.
inline std::map<std::string, Image> across_the_plane() {
    std::map<std::string, Image> images{{"residual_slip", {"residual_slip", -1}}};
    for (std::string const model : {"rocking", "sliding", "contact"}) {
        images[model + ".residual_x"] = {model + ".residual_x", -1};
        images[model + ".rotation_at_peak"] = {model + ".rotation_at_peak", -1};
        for (auto const& [one, other] : {std::pair{"most", "least"}, std::pair{"least", "most"}}) {
            for (std::string const what : {"edge_x_", "rotation_"}) {
                images[model + "." + what + one] = {model + "." + what + other, -1};
            }
        }
    }
    return images;
}

inline std::vector<Relation> relations() {
    std::vector<std::string> const azimuth{"spatial.landing_azimuth"};
    std::vector<std::string> const of_x{"spatial.landing_azimuth", "v_wes", "ou_v_e", "v_wes_safe", "ou_v_e_safe",
                                        "standardised_cav"};
    auto const scaled = [](double length, double time, double mass) {
        return [=](Study& study) { scale(study, length, time, mass); };
    };
    return {
        {.name = "mirror left-right",
         .holds = in_the_plane,
         .change = [](Study& study) { turn(study, -1, 0, 0, 1); },
         .images = across_the_plane()},
        {.name = "mirror x",
         .holds = spatial,
         .change = [](Study& study) { turn(study, -1, 0, 0, 1); },
         .images = along(-1, 1),
         .untold = azimuth},
        {.name = "mirror y",
         .holds = spatial,
         .change = [](Study& study) { turn(study, 1, 0, 0, -1); },
         .images = along(1, -1),
         .untold = azimuth},
        {.name = "mirror x and y",
         .holds = spatial,
         .change = [](Study& study) { turn(study, -1, 0, 0, -1); },
         .images = along(-1, -1),
         .untold = azimuth},
        {.name = "swap x and y",
         .holds = spatial,
         .change = [](Study& study) { turn(study, 0, 1, 1, 0); },
         .images = across(1, 1),
         .untold = of_x},
        {.name = "turn by 90 degrees",
         .holds = spatial,
         .change = [](Study& study) { turn(study, 0, -1, 1, 0); },
         .images = across(1, -1),
         .untold = of_x},
        {.name = "length x 4, time x 2", .holds = always, .change = scaled(4, 2, 1), .length = 4, .time = 2},
        {.name = "gravity x 4, time / 2", .holds = always, .change = scaled(1, 0.5, 1), .time = 0.5},
        {.name = "length x 16, time x 2, mass x 32",
         .holds = always,
         .change = scaled(16, 2, 32),
         .length = 16,
         .time = 2,
         .mass = 32},
        {.name = "mass x 8", .holds = always, .change = scaled(1, 1, 8), .mass = 8},
        {.name = "levels x 2, motions / 2",
         .holds = always,
         .change =
             [](Study& study) {
                 each(study.factors, 2);
                 for (auto& motion : study.motions) {
                     for (auto& wave : motion.gal) {
                         each(wave, 0.5);
                     }
                 }
             },
         .untold = {"amplitude", "scale"}},
        {.name = "motions in m/s2", .holds = always, .change = [](Study& study) { study.in_gal = false; }},
        {.name = "bodies the other way",
         .holds = always,
         .change = [](Study& study) { std::ranges::reverse(study.solids); },
         .untold = {"body"},
         .place =
             [](Study const& of, std::array<std::size_t, 3> at) {
                 return std::array{at[0], of.solids.size() - 1 - at[1], at[2]};
             }},
        {.name = "motions the other way",
         .holds = always,
         .change = [](Study& study) { std::ranges::reverse(study.motions); },
         .untold = {"wave"},
         .place =
             [](Study const& of, std::array<std::size_t, 3> at) {
                 return std::array{of.motions.size() - 1 - at[0], at[1], at[2]};
             }},
        {.name = "levels the other way",
         .holds = always,
         .change = [](Study& study) { std::ranges::reverse(study.factors); }},
        {.name = "every second level",
         .holds = always,
         .change =
             [](Study& study) {
                 std::vector<double> kept;
                 for (std::size_t i = 0; i < study.factors.size(); i += 2) {
                     kept.push_back(study.factors[i]);
                 }
                 study.factors = kept;
             },
         .untold = {"level"},
         .place =
             [](Study const&, std::array<std::size_t, 3> at) {
                 return std::array{at[0], at[1], at[2] % 2 == 0 ? at[2] / 2 : nowhere};
             }},
        {.name = "other names",
         .holds = always,
         .change =
             [](Study& study) {
                 study.wave_name = "motion ";
                 study.solids[0].name = "zulu";
                 study.solids[1].name = "alpha";
             }},
        {.name = "a body twice",
         .holds = always,
         .change =
             [](Study& study) {
                 study.solids.insert(study.solids.begin(), study.solids[1]);
                 study.solids[0].name = "twin";
             },
         .untold = {"body"},
         .place =
             [](Study const&, std::array<std::size_t, 3> at) {
                 return std::array<std::size_t, 3>{at[0], at[1] == 1 ? 0U : 1U, at[2]};
             }},
        // After the motion a rigid body is followed until energy decides that it cannot fall or lean further: counts
        // depend on where the motion is said to end. On points it is followed until it
        // rests, which is looked at every few samples from the end on: what is left of slip by then differs.
        {.name = "4 s of zeros behind",
         .holds = [](Family const& family) { return !family.points; },
         .change = quiet_behind,
         .told = {"verdict", "peak_rotation", "peak_rotation_ratio", "time_of_peak", "first_uplift", "overturn_time",
                  "peak_energy_ratio", "peak_impact_velocity", "friction_demand", "min_contact_force_ratio",
                  "peak_slip", "v_resp", "v_wes"}},
        {.name = "4 s of zeros behind",
         .holds = [](Family const& family) { return family.points; },
         .change = quiet_behind,
         .untold = {"ou_v_e", "residual_slip", "steps", "contact.residual_x", "spatial.residual_x",
                    "spatial.residual_y", "spatial.slip_path", "spatial.yaw"}},
        {.name = "midpoints inserted", .holds = always, .change = halve_step},
    };
}

}  // namespace overturn::testing
