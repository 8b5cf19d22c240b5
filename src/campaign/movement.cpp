#include <algorithm>
#include <cmath>

#include "campaign/campaign_spec.hpp"
#include "core/units.hpp"

namespace overturn {
namespace {

// Under its weight alone the base settles by g / w_v^2; rigid ground does not give way.
double settlement_m(Response const& response, RigidBody const& body, Pad const& pad) {
    constexpr auto of_points = mask_of(Effect::contact) | mask_of(Effect::spatial);
    bool const on_points = (static_cast<EffectMask>(response.effects) & of_points) != 0;
    return on_points ? body.gravity_mps2() / std::pow(2 * pi * pad.vertical_frequency_hz, 2) : 0;
}

// Of the centre of gravity about an edge.
double rise_by_rotation_m(double rotation_rad, RigidBody const& body) {
    double const angle = std::min(rotation_rad, body.alpha_rad());
    return body.half_width_m() * std::sin(angle) - body.centre_height_m() * (1 - std::cos(angle));
}

}  // namespace

Verdict MovementSpec::verdict(Response const& response, RigidBody const& body, bool may_slip, Pad const& pad,
                              double peak_rise_m) const {
    bool const stands = response.verdict == Verdict::at_rest || response.verdict == Verdict::slid
                        || response.verdict == Verdict::rocked;
    if (!stands || by_model) {
        return response.verdict;
    }
    bool const slid = may_slip && response.peak_slip_m > 0 && response.peak_slip_m >= slip_m;
    double const settled_m = settlement_m(response, body, pad);
    // A moment that just lifts one edge off sinks the other to twice the settlement.
    double const of_edge_m = 2 * body.half_width_m() * std::sin(response.peak_rotation_rad) - 2 * settled_m;
    double const of_flight_m = peak_rise_m - rise_by_rotation_m(response.peak_rotation_rad, body) - settled_m;
    double const most_m = std::fmax(of_edge_m, of_flight_m);
    bool const rocked = most_m > 0 && most_m >= uplift_m;
    return slid && rocked ? Verdict::slid_and_rocked
           : slid         ? Verdict::slid
           : rocked       ? Verdict::rocked
                          : Verdict::at_rest;
}

}  // namespace overturn
