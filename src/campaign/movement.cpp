#include <cmath>

#include "campaign/campaign_spec.hpp"
#include "core/units.hpp"

namespace overturn {
namespace {

// Under its weight alone the base settles by g / w_v^2. A moment that just lifts one edge off sinks the other to twice
// that; rigid ground does not give way.
double tilt_of_pad_m(Response const& response, RigidBody const& body, Pad const& pad) {
    constexpr auto of_points = mask_of(Effect::contact) | mask_of(Effect::spatial);
    bool const on_points = (static_cast<EffectMask>(response.effects) & of_points) != 0;
    return on_points ? 2 * body.gravity_mps2() / std::pow(2 * pi * pad.vertical_frequency_hz, 2) : 0;
}

}  // namespace

Verdict MovementSpec::verdict(Response const& response, RigidBody const& body, bool may_slip, Pad const& pad) const {
    bool const stands = response.verdict == Verdict::at_rest || response.verdict == Verdict::slid
                        || response.verdict == Verdict::rocked;
    if (!stands || by_model) {
        return response.verdict;
    }
    bool const slid = may_slip && response.peak_slip_m > 0 && response.peak_slip_m >= slip_m;
    double const uplift_of_edge_m =
        2 * body.half_width_m() * std::sin(response.peak_rotation_rad) - tilt_of_pad_m(response, body, pad);
    bool const rocked = uplift_of_edge_m > 0 && uplift_of_edge_m >= uplift_m;
    return slid && rocked ? Verdict::slid_and_rocked
           : slid         ? Verdict::slid
           : rocked       ? Verdict::rocked
                          : Verdict::at_rest;
}

}  // namespace overturn
