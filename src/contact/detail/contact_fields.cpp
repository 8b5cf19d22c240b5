#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/detail/contact_run.hpp"
#include "contact/rest_gate.hpp"

namespace overturn::contact {

void ContactRun::fill_trial(ContactAccuracy const& accuracy) {
    fill_steps(accuracy, 1, planar_.inertia_over_mass_m2);
    fill_law();
    fill_waves();
    double const b = planar_.half_width_m;
    double const h = planar_.centre_height_m;
    double const inertia = planar_.inertia_over_mass_m2;
    double const alpha = std::atan2(b, h);
    double const radius = std::hypot(b, h);
    put(ContactField::half_width, b);
    put(ContactField::inertia, inertia);
    put(ContactField::mass_over_inertia, 1 / inertia);
    put(ContactField::inverse_p, std::sqrt((inertia + radius * radius) / (planar_.gravity_mps2 * radius)));
    put(ContactField::sine_alpha, std::sin(alpha));
    put(ContactField::cosine_alpha, std::cos(alpha));
    put(ContactField::impact_spin, planar_.approach_floor_mps() / b);
    put(ContactField::quiet_energy, accuracy.rest_gate ? quiet_energy() : -1);
    double const parting = lane_.points == 2 ? corner_parting_share : bed_parting_share;
    put(ContactField::rest_ratio, std::min(parting * b / h, friction_share * planar_.friction));
    put(ContactField::force, planar_.gravity_mps2);
    put(ContactField::least_force, std::numeric_limits<double>::infinity());
    put(ContactField::uplift_time, -1);
    put(ContactField::loss_time, -1);
}

void ContactRun::fill_waves() {
    bool const lifted = !shaking_.vertical_mps2.empty();
    put(ContactField::horizontal_scale, shaking_.scale);
    put(ContactField::vertical_scale, lifted ? shaking_.scale : 0);
    lane_.body.at(ContactWave::horizontal, 0) = shaking_.horizontal_mps2.data();
    lane_.body.at(ContactWave::vertical, 0) = (lifted ? shaking_.vertical_mps2 : shaking_.horizontal_mps2).data();
}

void ContactRun::fill_points() {
    double const w = planar_.vertical_radps();
    for (int i = 0; i < lane_.points; ++i) {
        auto const& point = planar_.points[i];
        double const stiffness = point.stiffness_share * w * w;
        lane_.at(Spot::offset, i, 0) = point.offset_m;
        lane_.at(Spot::stiffness, i, 0) = stiffness;
        lane_.at(Spot::lever, i, 0) = stiffness * point.offset_m;
        lane_.at(Spot::yield, i, 0) = planar_.yield_depth_m;
        lane_.at(Spot::gain, i, 0) = get(ContactField::damping) / planar_.approach_floor_mps();
        lane_.at(Spot::anchor, i, 0) = point.offset_m;
    }
}

void ContactRun::turn_to(double rotation_rad) {
    put(ContactField::rotation, rotation_rad);
    put(ContactField::sine, std::sin(rotation_rad));
    put(ContactField::cosine, std::cos(rotation_rad));
}

void ContactRun::place(ContactStart const& start) {
    turn_to(start.rotation_rad);
    put(ContactField::sway, start.sway_m);
    put(ContactField::rise, start.rise_m - planar_.settlement_m());
    put(ContactField::sway_speed, start.sway_mps);
    put(ContactField::rise_speed, start.rise_mps);
    put(ContactField::spin, start.velocity_radps);
    put(ContactField::crest, start.rotation_rad);
    put(ContactField::trough, start.rotation_rad);
    put(ContactField::most_rise, get(ContactField::rise));
    double const middle = start.sway_m - planar_.centre_height_m * get(ContactField::sine);
    double const reach = planar_.half_width_m * get(ContactField::cosine);
    put(ContactField::most_x, middle + reach);
    put(ContactField::least_x, middle - reach);
    put(ContactField::side, start.rotation_rad < 0 ? -1 : 1);
}

ContactInstant ContactRun::instant() const {
    return {time_s(),
            get(ContactField::rotation),
            get(ContactField::spin),
            get(ContactField::sway),
            get(ContactField::sway_speed),
            get(ContactField::rise),
            get(ContactField::rise_speed),
            get(ContactField::force) / planar_.gravity_mps2,
            deepest_crush(),
            slip_m()};
}

// Of the corner that it leans on: rocking about a corner moves the middle of the base, not that corner.
double ContactRun::slip_m() const {
    double const sine = get(ContactField::sine);  // the cosine's last digits drift
    double const lifted = planar_.half_width_m * sine * sine / (1 + std::abs(get(ContactField::cosine)));
    return get(ContactField::sway) - planar_.centre_height_m * get(ContactField::sine)
           - std::copysign(lifted, get(ContactField::rotation));
}

// Whether the base has moved farther than springs stretch whose points hold.
bool ContactRun::slipped() const { return get(ContactField::most_slip) > elastic_way(); }

// What can be read off the lane as it is: extremes, counts, and where the body ended.
void ContactRun::fill_peaks(ContactOutcome& out) const {
    double const g = planar_.gravity_mps2;
    out.crest_rad = get(ContactField::crest);
    out.trough_rad = get(ContactField::trough);
    out.impacts = static_cast<std::int64_t>(get(ContactField::impacts));
    out.peak_impact_velocity_mps = 2 * planar_.half_width_m * get(ContactField::most_spin);
    out.steps = static_cast<std::int64_t>(get(ContactField::steps));
    out.friction_demand = out.friction_work_jpkg = never;
    out.min_contact_force_ratio = out.steps > 0 ? get(ContactField::least_force) / g : 1;
    out.peak_slip_m = get(ContactField::most_slip);
    out.residual_slip_m = slip_m();
    out.end_sway_mps = get(ContactField::sway_speed);
    out.extra.peak_crush_m = deepest_crush();
    out.extra.peak_contact_force_ratio = std::max(1.0, get(ContactField::most_force) / g);
    out.extra.peak_rise_m = get(ContactField::most_rise) + planar_.settlement_m();
    fill_reach(out);
}

// With where it ended, after the last step that was looked at.
void ContactRun::fill_reach(ContactOutcome& out) const {
    double const h = planar_.centre_height_m;
    double const middle = get(ContactField::sway) - h * get(ContactField::sine);
    double const reach = planar_.half_width_m * std::abs(get(ContactField::cosine));
    double const top = std::abs(get(ContactField::sway) + h * get(ContactField::sine));
    double const rotation = std::clamp(get(ContactField::rotation), -pi / 2, pi / 2);
    out.extra.residual_x_m = middle;
    out.extra.edge_x_most_m = std::max(get(ContactField::most_x), middle + reach);
    out.extra.edge_x_least_m = std::min(get(ContactField::least_x), middle - reach);
    out.extra.peak_top_m = std::max(get(ContactField::most_top), top);
    out.extra.rotation_most_rad = std::max({0.0, out.crest_rad, rotation});
    out.extra.rotation_least_rad = std::min({0.0, out.trough_rad, rotation});
}

// As it is at the end of the first step beyond pi/2.
void ContactRun::fill_landing(ContactOutcome& out) const {
    double const h = planar_.centre_height_m;
    double const spin = get(ContactField::spin);
    double const x = get(ContactField::sway_speed);
    double const z = get(ContactField::rise_speed);
    out.landing_spin_radps = std::abs(spin);
    out.landing_velocity_mps = std::hypot(x, z);
    out.landing_top_mps = std::hypot(x + spin * h * get(ContactField::cosine), z - spin * h * get(ContactField::sine));
    out.landing_energy_jpkg = 0.5 * (x * x + z * z + planar_.inertia_over_mass_m2 * spin * spin);
}

ContactOutcome ContactRun::finish() const {
    ContactOutcome out;
    fill_peaks(out);
    double const alpha = std::atan2(planar_.half_width_m, planar_.centre_height_m);
    double const radius = std::hypot(planar_.half_width_m, planar_.centre_height_m);
    double const rotation = get(ContactField::rotation);
    bool const fell = std::abs(rotation) >= pi / 2;
    bool const forward = out.crest_rad >= -out.trough_rad;
    auto const since = [](double time) { return time < 0 ? never : time; };
    out.first_uplift_s = since(get(ContactField::uplift_time));
    out.contact_lost_s = since(get(ContactField::loss_time));
    out.peak_rotation_rad = fell ? pi / 2 : std::max(out.crest_rad, -out.trough_rad);
    out.peak_rotation_ratio = out.peak_rotation_rad / alpha;
    if (fell) {
        out.overturn_time_s = out.time_of_peak_s = instant().time_s;
        fill_landing(out);
    } else if (out.peak_rotation_rad > 0) {
        out.time_of_peak_s = get(forward ? ContactField::crest_time : ContactField::trough_time);
    }
    out.peak_energy_ratio = get(ContactField::most_energy) / (1 - std::cos(alpha));
    double const turned = std::min(alpha, out.peak_rotation_rad) / 2;
    out.response_velocity_mps =
        2 * std::sqrt(planar_.gravity_mps2 * radius * std::sin(alpha - turned) * std::sin(turned));
    out.verdict = fell                              ? Verdict::overturned
                  : !std::isnan(out.first_uplift_s) ? Verdict::rocked
                  : slipped()                       ? Verdict::slid
                                                    : Verdict::at_rest;
    if (!std::isfinite(rotation + get(ContactField::sway) + get(ContactField::rise) + get(ContactField::spin))) {
        out.verdict = Verdict::failed;
        out.failure = FailureReason::no_convergence;
    }
    return out;
}

}  // namespace overturn::contact
