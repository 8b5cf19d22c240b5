#include "campaign/detail/limit_range.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace overturn {
namespace {

using Bound = double (*)(BodySpec const& body);

constexpr double infinite_bound = std::numeric_limits<double>::infinity();
constexpr double above_nothing = std::numeric_limits<double>::denorm_min();

double none(BodySpec const& /*body*/) { return 0; }
double one(BodySpec const& /*body*/) { return 1; }
double below_all(BodySpec const& /*body*/) { return -infinite_bound; }
double unbounded(BodySpec const& /*body*/) { return infinite_bound; }

double alpha(BodySpec const& body) { return std::max(body.body.corner(1).alpha_rad, body.body.corner(-1).alpha_rad); }
// In space a body that stands on a corner tilts further than alpha: at most as if it were flat.
double flat(BodySpec const& /*body*/) { return pi / 2; }
double flat_ratio(BodySpec const& body) { return pi / 2 / alpha(body); }
double limit_velocity(BodySpec const& body) {
    return std::max(body.body.corner(1).limit_velocity_mps, body.body.corner(-1).limit_velocity_mps);
}
double largest_grip(BodySpec const& body) {
    return !body.friction          ? infinite_bound
           : body.scatter.friction ? body.scatter.friction->highest()
                                   : body.friction->static_coefficient;
}
double half_width(BodySpec const& body) { return body.body.half_width_m(); }

constexpr double far_m = 10;
double far(BodySpec const& /*body*/) { return far_m; }
double far_edge(BodySpec const& body) { return body.body.half_width_m() + far_m; }
double fast(BodySpec const& body) { return 3 * std::sqrt(2 * body.body.gravity_mps2() * body.body.radius_m()); }
double fast_spin(BodySpec const& body) { return 3 * std::sqrt(2.0) * body.body.p_radps(); }
double energetic(BodySpec const& body) { return body.body.gravity_mps2() * (body.body.radius_m() + far_m); }
double all_round(BodySpec const& /*body*/) { return 2 * pi; }
double many_weights(BodySpec const& /*body*/) { return 1000; }
double many(BodySpec const& /*body*/) { return 10000; }

struct Entry {
    std::string_view of;  ///< a quantity, or the unit of all that have no line of their own
    Bound at_rest, least, most;
    double usual_low;
    Bound usual_high;
    std::string_view low_known, high_known;
};

constexpr std::string_view falls_by_itself = "beyond its critical angle a body falls by itself";
constexpr std::string_view of_falls = "three times what a body has that falls from balance";
constexpr std::string_view any_shaking = "any shaking passes it";
constexpr std::string_view any_give = "a pad that gives way a little passes it";
constexpr std::string_view bodies_slide = "bodies slide by millimetres to metres";

constexpr std::array usual_limits{
    Entry{"peak_rotation", &none, &none, &flat, 1e-5, &alpha, any_give, falls_by_itself},
    Entry{"peak_rotation_ratio", &none, &none, &flat_ratio, 1e-5, &one, any_give, falls_by_itself},
    Entry{"peak_energy_ratio", &none, &none, &unbounded, 1e-8, &one, any_give,
          "with the energy of critical uplift a body falls by itself"},
    Entry{"v_resp", &none, &none, &unbounded, 1e-4, &limit_velocity, any_give, falls_by_itself},
    Entry{"friction_demand", &none, [](BodySpec const& /*body*/) { return above_nothing; }, &unbounded, 0.01,
          &largest_grip, any_shaking, "at its static coefficient a body slips, and no more is asked of the ground"},
    Entry{"min_contact_force_ratio", &one, &none, &one, 0, &one, {}, {}},
    Entry{"peak_contact_force_ratio", &one, &one, &unbounded, 1.01, &many_weights, any_shaking,
          "no pad presses with a thousand weights"},
    Entry{"impacts", &none, &none, &unbounded, 0, &many, {}, "an earthquake has time for some hundreds"},
    Entry{"edge_x_most", &half_width, &half_width, &unbounded, 0, &far_edge, {}, bodies_slide},
    Entry{"edge_x_least", &half_width, &half_width, &unbounded, 0, &far_edge, {}, bodies_slide},
    Entry{"edge_y_most", &half_width, &half_width, &unbounded, 0, &far_edge, {}, bodies_slide},
    Entry{"edge_y_least", &half_width, &half_width, &unbounded, 0, &far_edge, {}, bodies_slide},
    Entry{"least_clearance", &unbounded, &below_all, &unbounded, 0, &far, {}, bodies_slide},
    Entry{"edge_margin", &unbounded, &below_all, &unbounded, 0, &far, {}, bodies_slide},
    Entry{"m", &none, &none, &unbounded, 1e-5, &far, any_give, bodies_slide},
    Entry{"rad", &none, &none, &unbounded, 1e-5, &all_round, any_give, "2 pi is a whole turn"},
    Entry{"m/s", &none, &none, &unbounded, 1e-4, &fast, any_give, of_falls},
    Entry{"rad/s", &none, &none, &unbounded, 1e-4, &fast_spin, any_give, of_falls},
    Entry{"J/kg", &none, &none, &unbounded, 0, &energetic, {}, "a fall and 10 m of slip have less"},
    Entry{"1", &none, &none, &unbounded, 0, &unbounded, {}, {}}};

Entry const& entry_of(LimitQuantity const& quantity) {
    auto const* const named = std::ranges::find(usual_limits, quantity.name, &Entry::of);
    auto const* const found =
        named == usual_limits.end() ? std::ranges::find(usual_limits, quantity.units, &Entry::of) : named;
    return found == usual_limits.end() ? usual_limits.back() : *found;
}

}  // namespace

LimitRange range_of(LimitQuantity const& quantity, BodySpec const& body) {
    auto const& entry = entry_of(quantity);
    return {entry.at_rest(body),    entry.least(body), entry.most(body), entry.usual_low,
            entry.usual_high(body), entry.low_known,   entry.high_known};
}

Passable passable(LimitState const& limit, LimitRange const& range) {
    double const threshold = limit.threshold;
    bool const above = limit.rule == LimitState::Rule::above;
    bool const none_passes = above ? threshold >= range.most : threshold <= range.least;
    bool const all_pass = above ? threshold < range.least : threshold > range.most;
    return none_passes ? Passable::none : all_pass ? Passable::all : Passable::some;
}

bool passed_at_rest(LimitState const& limit, LimitRange const& range) {
    return limit.rule == LimitState::Rule::above ? limit.threshold < range.at_rest : limit.threshold > range.at_rest;
}

}  // namespace overturn
