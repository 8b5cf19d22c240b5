#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>
#include <variant>

#include "campaign/detail/gyration.hpp"
#include "campaign/detail/loose_parts.hpp"
#include "campaign/warnings.hpp"
#include "core/units.hpp"
#include "core/usual_range.hpp"

namespace overturn {
namespace {

constexpr double does_not_apply = std::numeric_limits<double>::quiet_NaN();
constexpr double heavy_kg = 20e3;  // casks are, models and test blocks are not

bool is_heavy(BodySpec const& body) { return body.body.mass_kg() >= heavy_kg; }

double box_density(BodySpec const& body) {
    auto const& b = body.body;
    return b.mass_kg() / (8 * b.half_width_m() * b.half_width_m() * b.centre_height_m());
}
double density_of_casks(BodySpec const& body) { return is_heavy(body) ? box_density(body) : does_not_apply; }
double density_of_models(BodySpec const& body) { return is_heavy(body) ? does_not_apply : box_density(body); }
double ratio(BodySpec const& body) { return body.body.centre_height_m() / body.body.half_width_m(); }
double ratio_of_casks(BodySpec const& body) { return is_heavy(body) ? ratio(body) : does_not_apply; }
double ratio_of_models(BodySpec const& body) { return is_heavy(body) ? does_not_apply : ratio(body); }
double gyration(BodySpec const& body) { return gyration_share(body.body); }
double of_housner(BodySpec const& body) {
    double const housner = body.body.housner_restitution();
    return housner > 0 ? body.body.restitution() / housner : does_not_apply;
}
double friction(BodySpec const& body) { return body.friction ? body.friction->static_coefficient : does_not_apply; }
double kinetic_share(BodySpec const& body) {
    return body.friction && body.friction->static_coefficient > 0
               ? body.friction->kinetic_coefficient / body.friction->static_coefficient
               : does_not_apply;
}
double gravity(BodySpec const& body) { return body.stated.gravity_mps2; }
double model_length(BodySpec const& body) { return body.scaling ? body.scaling->law.length : does_not_apply; }
double slope_deg(BodySpec const& body) { return std::abs(body.stated.slope_rad) * 180 / pi; }
double tilt_deg(BodySpec const& body) { return std::abs(body.stated.initial_tilt_rad) * 180 / pi; }
double offset_share(BodySpec const& body) { return std::abs(body.body.offset_m()) / body.body.half_width_m(); }
double pad_frequency(BodySpec const& body) {
    return body.footing.stated ? body.footing.pad.vertical_frequency_hz : does_not_apply;
}
double pad_bounce(BodySpec const& body) {
    return body.footing.stated ? body.footing.pad.normal_restitution : does_not_apply;
}
double pad_shear(BodySpec const& body) {
    return body.footing.stated ? body.footing.pad.tangential_ratio : does_not_apply;
}
double pad_damping(BodySpec const& body) {
    return body.footing.stated ? body.footing.pad.tangential_damping : does_not_apply;
}
double bed_points(BodySpec const& body) {
    return body.footing.stated && body.footing.base.is_bed() ? body.footing.base.points : does_not_apply;
}
double rim_points(BodySpec const& body) {
    auto const& base = body.footing.base;
    return base.is_rim_of_points() && !body.footing.pad.strength_pa ? base.points : does_not_apply;
}
double crushing_rim_points(BodySpec const& body) {
    auto const& base = body.footing.base;
    return base.is_rim_of_points() && body.footing.pad.strength_pa ? base.points : does_not_apply;
}
double inertia_across(BodySpec const& body) {
    return body.footing.inertia_across_kgm2.value_or(does_not_apply) / body.body.inertia_kgm2();
}
double inertia_vertical(BodySpec const& body) {
    return body.footing.inertia_vertical_kgm2.value_or(does_not_apply) / body.body.inertia_kgm2();
}
// Of a solid cylinder; a box may be of any depth.
double densest_part(BodySpec const& body) {
    double densest = does_not_apply;
    for (auto const& part : body.parts) {
        if (auto const* const c = std::get_if<Cylinder>(&part); c != nullptr && c->height_m > 0) {
            densest = std::fmax(densest, c->mass_kg / (pi * c->radius_m * c->radius_m * c->height_m));
        }
    }
    return densest;
}
double pad_strength_mpa(BodySpec const& body) { return body.footing.pad.strength_pa.value_or(does_not_apply) / 1e6; }

// Half of what lies between the 16 % and the 84 % draw, over the middle.
template <std::optional<Distribution> BodyScatter::*quantity> double scatter(BodySpec const& body) {
    auto const& drawn = body.scatter.*quantity;
    constexpr double below = 0.1586552539;  // of a normal one: a standard deviation from the mean
    return drawn && drawn->scatters() && drawn->centre() > 0
               ? (drawn->quantile(1 - below) - drawn->quantile(below)) / 2 / drawn->centre()
               : does_not_apply;
}
std::string scatter_text(std::string_view quantity, double share) {
    return fmt::format("{} scatters by {:.2g} % either way", quantity, 100 * share);
}
std::string mass_text(BodySpec const& /*body*/, double share) { return scatter_text("mass", share); }
std::string height_text(BodySpec const& /*body*/, double share) { return scatter_text("centre_height", share); }
std::string bounce_text(BodySpec const& /*body*/, double share) { return scatter_text("restitution", share); }
std::string grip_text(BodySpec const& /*body*/, double share) { return scatter_text("friction", share); }

std::string length_text(BodySpec const& body, double value_m, int digits = 4) {
    return fmt::format("{:.{}g} {}", value_m / body.units.length.si, digits, body.units.length.symbol);
}

std::string density_text(BodySpec const& body, double value) {
    return fmt::format("mass {:.4g} kg in the box of base and centre height is {:.3g} kg/m3", body.body.mass_kg(),
                       value);
}
std::string gyration_text(BodySpec const& body, double value) {
    return fmt::format("inertia {:.4g} kg m2 is a radius of gyration of {}, {:.2g} of R", body.body.inertia_kgm2(),
                       length_text(body, value * body.body.radius_m(), 3), value);
}
std::string ratio_text(BodySpec const& body, double value) {
    return fmt::format("centre height {} over half the width is {:.3g}", length_text(body, body.body.centre_height_m()),
                       value);
}
std::string restitution_text(BodySpec const& body, double value) {
    return fmt::format("restitution {:.4g} is {:.2g} of Housner's for its shape, {:.4g}", body.body.restitution(),
                       value, body.body.housner_restitution());
}
std::string friction_text(BodySpec const& /*body*/, double value) {
    return fmt::format("static friction {:.4g}", value);
}
std::string kinetic_text(BodySpec const& /*body*/, double value) {
    return fmt::format("kinetic friction is {:.2g} of the static one", value);
}
std::string gravity_text(BodySpec const& /*body*/, double value) { return fmt::format("gravity {:.4g} m/s2", value); }
std::string model_length_text(BodySpec const& /*body*/, double value) {
    return fmt::format("similarity.length {:.4g}", value);
}
std::string tilt_text(BodySpec const& /*body*/, double value) { return fmt::format("initial_tilt {:.3g} deg", value); }
std::string slope_text(BodySpec const& /*body*/, double value) { return fmt::format("slope {:.3g} deg", value); }
std::string offset_text(BodySpec const& body, double value) {
    return fmt::format("offset {} is {:.2g} of half the width", length_text(body, body.body.offset_m()), value);
}
std::string frequency_text(BodySpec const& /*body*/, double value) {
    return fmt::format("pad.vertical_frequency {:g} Hz", value);
}
std::string bouncing_text(BodySpec const& /*body*/, double value) {
    return fmt::format("pad.normal_restitution {:g}", value);
}
std::string shear_text(BodySpec const& /*body*/, double value) {
    return fmt::format("pad.tangential_ratio {:g}", value);
}
std::string damping_text(BodySpec const& /*body*/, double value) {
    return fmt::format("pad.tangential_damping {:g}", value);
}
std::string bed_text(BodySpec const& /*body*/, double value) {
    return fmt::format("a bed of {:g} points from corner to corner", value);
}
std::string rim_text(BodySpec const& /*body*/, double value) { return fmt::format("a rim of {:g} points", value); }
std::string across_text(BodySpec const& /*body*/, double value) {
    return fmt::format("inertia_y is {:.3g} of the inertia in the rocking plane", value);
}
std::string vertical_text(BodySpec const& /*body*/, double value) {
    return fmt::format("inertia_z is {:.3g} of the inertia in the rocking plane", value);
}
std::string part_text(BodySpec const& /*body*/, double value) {
    return fmt::format("a cylinder of {:.4g} kg/m3", value);
}
std::string strength_text(BodySpec const& /*body*/, double value) {
    return fmt::format("pad.strength {:g} MPa", value);
}

constexpr std::string_view sizes =
    "Check its unit (kg, t or lb?), base_width (the whole width) and centre_height (of the centre of gravity, not the "
    "top)";
constexpr std::string_view swapped = "Check that base_width and centre_height are not swapped, and their units";
constexpr std::string_view its_unit = "Check it and its unit";
constexpr std::string_view check_deviation = "Check its deviation: 0.05 of the mean for 5 %";

constexpr double least_scatter = 1e-4;  // less is none
using OfBody = UsualRange<BodySpec>;
constexpr std::array body_ranges{
    OfBody{&density_of_casks, 1200, 4500, &density_text, "casks 1500 to 4500 kg/m3", sizes},
    OfBody{&density_of_models, 1200, 8000, &density_text, "concrete 2400, granite 2700, steel 7850 kg/m3", sizes},
    OfBody{&gyration, least_gyration_share, 1, &gyration_text,
           "0.58 of a uniform block about its centre of gravity, 1.15 about its corner",
           "Check its axis and unit, or write \"uniform-block\""},
    OfBody{&ratio_of_casks, 1, 3, &ratio_text, "casks 1.5 to 3",
           "Check that centre_height is that of the centre of gravity, base_width the whole width, and that they are "
           "not swapped"},
    OfBody{&ratio_of_models, 0.8, 15, &ratio_text, "models of casks 1.5 to 3, slender test blocks 7 to 13", swapped},
    OfBody{&of_housner, 0.7, 1.6, &restitution_text, "measured: 0.9 to 1.3 of it",
           "State another, or \"housner\": one too low takes energy that a real body keeps"},
    OfBody{&friction, 0.15, 1.2, &friction_text, "steel on concrete 0.2 to 0.8", "Check it"},
    OfBody{&kinetic_share, 0.5, 1, &kinetic_text, "0.7 to 1", "Check it"},
    OfBody{&gravity, 9.7, 9.9, &gravity_text, "9.78 to 9.83 m/s2 on Earth", its_unit},
    OfBody{&model_length, 0.02, 1, &model_length_text, "a model over its prototype, 1/10 to 1/2",
           "Check direction, and it"},
    OfBody{&slope_deg, 0, 5, &slope_text, "floors 0 to 2 deg", "Write its unit, \"1 deg\": a bare number is rad"},
    OfBody{&tilt_deg, 0, 5, &tilt_text, "a body that is let go before it is shaken 0 to 5 deg",
           "Write its unit, \"1 deg\": a bare number is rad"},
    OfBody{&offset_share, 0, 0.3, &offset_text, "casks less than 0.05", its_unit},
    OfBody{&pad_frequency, 5, 500, &frequency_text, "of casks and models 20 to 100 Hz", its_unit},
    OfBody{&pad_strength_mpa, 0.1, 300, &strength_text, "wood 5, concrete 20 to 60 MPa", its_unit},
    OfBody{&pad_bounce, 0, 0.8, &bouncing_text, "0.1 to 0.5 in a flat drop", "Check it"},
    OfBody{&pad_shear, 0.3, 3, &shear_text, "0.7 to 1 by the theory of contact", "Check it"},
    OfBody{&pad_damping, 0, 1, &damping_text, "a fraction of critical: 0.3 for 30 %", "Check it"},
    OfBody{&bed_points, 15, 1000, &bed_text,
           "15 or more: fewer points overturn too seldom, 5 miss a quarter of the falls", "Leave base.points out"},
    OfBody{&rim_points, BasePlan::most_points_around + 1, 1000, &rim_text,
           "none: the rim is continuous; one pulse along a line turned a cask by up to 4.3 rad on 32 points, by 2 rad "
           "on 64",
           "Leave base.points out, unless to compare slip"},
    OfBody{&crushing_rim_points, BasePlan::points_around, 1000, &rim_text,
           "64 or more on a pad that yields: on 32 a pulse tilts a body by 0.70 to 0.88 alpha, as it is turned in plan",
           "Leave base.points out, or see them in overturn cost"},
    OfBody{&inertia_across, 0.2, 5, &across_text, "1 of a round or square body", its_unit},
    OfBody{&inertia_vertical, 0.05, 5, &vertical_text, "0.2 to 0.6 of a cask", its_unit},
    OfBody{&densest_part, 0, 9000, &part_text, "steel 7850 kg/m3, solid",
           "Check its unit, and diameter (not the radius)"},
    OfBody{&scatter<&BodyScatter::mass>, least_scatter, 0.2, &mass_text, "of a cask 1 to 5 %", check_deviation},
    OfBody{&scatter<&BodyScatter::centre_height>, least_scatter, 0.15, &height_text, "of a cask 1 to 5 %",
           check_deviation},
    OfBody{&scatter<&BodyScatter::restitution>, least_scatter, 0.3, &bounce_text, "5 to 15 %", check_deviation},
    OfBody{&scatter<&BodyScatter::friction>, least_scatter, 0.5, &grip_text, "10 to 30 %", check_deviation}};

}  // namespace

std::vector<std::string> warnings_of(BodySpec const& body) {
    auto lines = unusual(body, std::span<OfBody const>(body_ranges));
    std::ranges::move(loose_parts(body), std::back_inserter(lines));
    auto const& asked = body.stated_footing.pad;
    if (asked.match_is_stated && asked.match_restitution && !body.footing.pad.match_restitution) {
        lines.emplace_back(
            "pad.match_restitution = true changes nothing: no restitution is stated, and this base has one that "
            "follows from its shape and pad. State restitution, or leave the key out");
    }
    for (auto& line : lines) {
        line.insert(0, body.name + ": ");
    }
    return lines;
}

}  // namespace overturn
