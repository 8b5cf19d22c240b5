#include "cli/plan_bodies.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "campaign/typed_units.hpp"
#include "contact/matching.hpp"
#include "core/text_width.hpp"
#include "core/texts_of.hpp"
#include "core/wrapped.hpp"

namespace overturn::cli {
namespace {

std::string base_text(BasePlan const& base, IntensityUnit const& length) {
    switch (base.shape) {
        case BaseShape::round:
            return base.is_disc() && base.inner_radius_m > 0
                       ? fmt::format("round base, evenly bedded from {} of radius on", length.text(base.inner_radius_m))
                   : base.is_disc()    ? std::string("round base, evenly bedded")
                   : base.continuous() ? std::string("round base on its continuous rim")
                                       : fmt::format("round base, {} points on its rim", base.points);
        case BaseShape::polygon:
            return fmt::format("polygon of {} corners", base.corners_m.size());
        case BaseShape::square:
            break;
    }
    return base.corner_share == 1 ? std::string("square base on its corners")
           : base.corner_share ? fmt::format("square base, {:.4g} of its stiffness on the corners", *base.corner_share)
                               : fmt::format("square base, flat on {} points", base.points);
}

// What base and pad make of the body's restitution.
std::string footing_text(BodySpec const& body, TypedUnits const& units) {
    auto const& base = body.footing.base;
    auto const& pad = body.footing.pad;
    auto text = fmt::format("{}; pad {:g} Hz, {}", base_text(base, units.length), pad.vertical_frequency_hz,
                            pad.strength_pa ? "strength " + units.pressure.text(*pad.strength_pa) : "elastic");
    if (base.shape == BaseShape::polygon) {
        return text;
    }
    auto const match = matched_footing(body.body, body.footing);
    constexpr double close = 1e-3;
    return text
           + fmt::format("; rocks with restitution {:.4f}{}", match.restitution,
                         !pad.match_restitution ? " (from base and pad; e is not used)"
                         : std::abs(match.restitution - body.body.restitution()) > close
                             ? fmt::format(", the nearest to {:.4f} that this base can have", body.body.restitution())
                             : "");
}

// Does it slide or rock first? Friction against the slope at which it tips: on points the kinetic one.
std::string friction_text(BodySpec const& body) {
    if (!body.friction) {
        return "no friction stated: it does not slide";
    }
    bool const on_points = body.footing.stated;
    double const held = body.friction->static_coefficient;
    double const mu = on_points ? body.friction->kinetic_coefficient : held;
    auto const& weaker = body.body.corner(body.body.weaker_side());
    double const slope =
        body.body.lopsided() ? std::tan(weaker.base_angle_rad) : body.body.half_width_m() / body.body.centre_height_m();
    auto const& drawn = body.scatter.friction;
    double const static_slope = slope * held / mu;
    if (drawn && drawn->scatters() && drawn->lowest() < static_slope && static_slope < drawn->highest()) {
        double const below = 0.5 * std::erfc(-drawn->score(static_slope) / std::sqrt(2.0));
        return fmt::format("friction about {:.4g}, tan(alpha) {:.4g}: slides before it rocks in {:.0f} % of draws", mu,
                           slope, 100 * below);
    }
    auto const compared = fmt::format("{}friction {:.4g} {} tan(alpha) {:.4g}", mu < held ? "kinetic " : "", mu,
                                      mu < slope ? "<" : ">=", slope);
    auto const& base = body.footing.base;
    bool const bears_further_in = base.is_bed() || base.shape == BaseShape::round;
    if (mu < slope) {
        return compared
               + (bears_further_in ? ": slides first, and may rock too"
                                   : ": slides before it rocks, not expected to overturn");
    }
    constexpr double near = 1.15;  // up to here slip changes peak rotations by orders of magnitude
    return compared + (mu < near * slope ? ": rocks and slides at once" : ": rocks before it slides");
}

// Which side is the weaker one, whose figures V_Ereq and all others are; empty where both are equal.
std::string placement_text(RigidBody const& body, IntensityUnit const& acceleration,
                           output::ShownVelocity const& unit) {
    std::string text;
    if (body.lopsided()) {
        auto const tips = [&](double side) {
            auto const& c = body.corner(side);
            return fmt::format("alpha {:.2f} deg, uplift {}, V_Ereq {}", c.alpha_rad * 180 / pi,
                               acceleration.text(body.gravity_mps2() * std::tan(c.alpha_rad)),
                               unit.text(c.limit_velocity_mps));
        };
        text = fmt::format("towards +x {}; towards -x {}; V_Ereq, alpha, p and e are those of the weaker side, {}x",
                           tips(1), tips(-1), body.weaker_side() > 0 ? '+' : '-');
    }
    if (double const tilt = body.initial_tilt_rad(); tilt != 0) {
        text += fmt::format("{}let go at a tilt of {:.4g} deg, {:.3f} of alpha", text.empty() ? "" : "; ",
                            tilt * 180 / pi, std::abs(tilt) / body.corner(tilt).alpha_rad);
    }
    return text;
}

// A name keeps to its column.
std::string short_name(std::string const& name) {
    constexpr std::size_t most = 22;
    return text_width(name) <= most ? name : std::string(text_head(name, most - 2)) + "..";
}

}  // namespace

std::string bodies_text(CampaignSpec const& spec, output::ShownVelocity const& unit, std::size_t most) {
    auto const& bodies = spec.bodies;
    std::size_t width = std::string("bodies").size();
    for (auto const& body : bodies) {
        width = std::max(width, text_width(short_name(body.name)));
    }
    constexpr std::array columns{9, 11, 9, 7, 8, 13, 12};
    auto const line = [&](std::string const& name, std::array<std::string, columns.size()> const& cells) {
        auto text = fmt::format("{:<{}}", name, width);
        for (std::size_t c = 0; c < columns.size(); ++c) {
            text += fmt::format(" {:>{}}", cells[c], columns[c]);
        }
        return text + '\n';
    };
    auto const units = typed_units(spec);
    auto text = line("bodies",
                     {fmt::format("mass [{}]", units.mass.symbol), "alpha [deg]", "p [rad/s]", "e", "Housner",
                      fmt::format("uplift [{}]", units.acceleration.symbol), fmt::format("V_Ereq [{}]", unit.symbol)});
    TextsOf sayings;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        auto const& [name, body] = std::pair(bodies[b].name, bodies[b].body);
        if (b < most) {
            text += line(short_name(name),
                         {fmt::format("{:.4g}", units.mass.of(body.mass_kg())),
                          fmt::format("{:.2f}", body.alpha_rad() * 180 / pi), fmt::format("{:.4f}", body.p_radps()),
                          fmt::format("{:.4f}", body.restitution()), fmt::format("{:.4f}", body.housner_restitution()),
                          fmt::format("{:.4g}", units.acceleration.of(body.uplift_acceleration_mps2())),
                          unit.number(body.limit_velocity_mps())});
        }
        sayings.add(placement_text(body, units.acceleration, unit), name);
        sayings.add(friction_text(bodies[b]), name);
        sayings.add(bodies[b].footing.stated ? footing_text(bodies[b], units) : "", name);
    }
    if (bodies.size() > most) {
        text += fmt::format("  and {} more (--full)\n", bodies.size() - most);
    }
    auto const most_texts = std::max(most / 2, std::size_t{4});
    std::size_t shown = 0;
    for (auto const& [saying, names] : sayings.entries()) {
        if (most < bodies.size() && shown++ == most_texts) {
            text += fmt::format("  and {} more (--full)\n", sayings.entries().size() - most_texts);
            break;
        }
        bool const all = names.size() == bodies.size();
        text += wrapped(all ? (names.size() > 1 ? "all bodies: " : "") + saying
                            : fmt::format("{}: {}", names_text(names, 2), saying),
                        4, line_width, "  ");
    }
    return text;
}

Json supports_of(CampaignSpec const& spec) {
    constexpr std::size_t most = 12;
    auto const units = typed_units(spec);
    TextsOf texts;
    for (auto const& body : spec.bodies) {
        texts.add(friction_text(body), body.name);
        texts.add(body.footing.stated ? footing_text(body, units) : "", body.name);
    }
    auto lines = Json::array();
    for (auto const& [text, names] : texts.entries()) {
        if (lines.size() == most) {
            lines.push_back(fmt::format("{} more: overturn plan --full", texts.entries().size() - most));
            break;
        }
        lines.push_back(fmt::format("{}: {}.", names_text(names, 2), text));
    }
    return lines;
}

Json bodies_json(CampaignSpec const& spec) {
    auto const units = typed_units(spec);
    Json list = Json::array();
    for (auto const& each : spec.bodies) {
        auto const& body = each.body;
        Json remarks = Json::array();
        auto const footing = each.footing.stated ? footing_text(each, units) : std::string();
        for (auto const& remark : {placement_text(body, units.acceleration, VelocityUnit{}.of_campaign(spec)),
                                   friction_text(each), footing}) {
            if (!remark.empty()) {
                remarks.push_back(remark);
            }
        }
        list.push_back({{"name", each.name},
                        {"mass_kg", body.mass_kg()},
                        {"alpha_rad", body.alpha_rad()},
                        {"p_radps", body.p_radps()},
                        {"restitution", body.restitution()},
                        {"housner_restitution", body.housner_restitution()},
                        {"uplift_mps2", body.uplift_acceleration_mps2()},
                        {"v_ereq_mps", body.limit_velocity_mps()},
                        {"stated",
                         {{"mass", output::stated_json(body.mass_kg(), units.mass)},
                          {"half_width", output::stated_json(body.half_width_m(), units.length)},
                          {"centre_height", output::stated_json(body.centre_height_m(), units.length)},
                          {"uplift", output::stated_json(body.uplift_acceleration_mps2(), units.acceleration)},
                          {"v_ereq", output::stated_json(body.limit_velocity_mps(), units.velocity)}}},
                        {"remarks", remarks}});
    }
    return list;
}

}  // namespace overturn::cli
