#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/detail/contact_run.hpp"

namespace overturn::contact {

void ContactRun::fill_trial(ContactAccuracy const& accuracy) {
    fill_steps(accuracy, 1);
    fill_law();
    fill_waves();
    double const b = planar_.half_width_m;
    double const h = planar_.centre_height_m;
    double const inertia = planar_.inertia_over_mass_m2;
    double const alpha = std::atan2(b, h);
    double const radius = std::hypot(b, h);
    put(Pressing::half_width, b);
    put(Pressing::inertia, inertia);
    put(Pressing::mass_over_inertia, 1 / inertia);
    put(Pressing::inverse_p, std::sqrt((inertia + radius * radius) / (planar_.gravity_mps2 * radius)));
    put(Pressing::sine_alpha, std::sin(alpha));
    put(Pressing::cosine_alpha, std::cos(alpha));
    put(Pressing::impact_spin, planar_.approach_floor_mps() / b);
    put(Pressing::quiet_energy, accuracy.rest_gate ? quiet_energy() : -1);
    // Corners part at b / h, a flat bed at a third of it.
    double const parting = lane_.points == 2 ? 0.9 : 0.25;
    put(Pressing::rest_ratio, std::min(parting * b / h, 0.5 * planar_.friction));
    put(Pressing::force, planar_.gravity_mps2);
    put(Pressing::least_force, std::numeric_limits<double>::infinity());
    put(Pressing::uplift_time, -1);
    put(Pressing::loss_time, -1);
}

void ContactRun::fill_waves() {
    bool const lifted = !shaking_.vertical_mps2.empty();
    put(Pressing::horizontal_scale, shaking_.scale);
    put(Pressing::vertical_scale, lifted ? shaking_.scale : 0);
    lane_.body.at(PressWave::horizontal, 0) = shaking_.horizontal_mps2.data();
    lane_.body.at(PressWave::vertical, 0) = (lifted ? shaking_.vertical_mps2 : shaking_.horizontal_mps2).data();
}

void ContactRun::fill_points() {
    double const w = planar_.vertical_radps();
    for (int i = 0; i < lane_.points; ++i) {
        auto const& point = planar_.points[static_cast<std::size_t>(i)];
        double const stiffness = point.stiffness_share * w * w;
        lane_.at(Spot::offset, i, 0) = point.offset_m;
        lane_.at(Spot::stiffness, i, 0) = stiffness;
        lane_.at(Spot::lever, i, 0) = stiffness * point.offset_m;
        lane_.at(Spot::yield, i, 0) = planar_.yield_depth_m;
        lane_.at(Spot::gain, i, 0) = get(Pressing::damping) / planar_.approach_floor_mps();
        lane_.at(Spot::anchor, i, 0) = point.offset_m;
    }
}

void ContactRun::turn_to(double rotation_rad) {
    put(Pressing::rotation, rotation_rad);
    put(Pressing::sine, std::sin(rotation_rad));
    put(Pressing::cosine, std::cos(rotation_rad));
}

void ContactRun::place(ContactStart const& start) {
    turn_to(start.rotation_rad);
    put(Pressing::sway, start.sway_m);
    put(Pressing::rise, start.rise_m - planar_.settlement_m());
    put(Pressing::sway_speed, start.sway_mps);
    put(Pressing::rise_speed, start.rise_mps);
    put(Pressing::spin, start.velocity_radps);
    put(Pressing::crest, start.rotation_rad);
    put(Pressing::trough, start.rotation_rad);
    put(Pressing::most_rise, get(Pressing::rise));
    put(Pressing::side, start.rotation_rad < 0 ? -1 : 1);
}

ContactInstant ContactRun::instant() const {
    return {time_s(),
            get(Pressing::rotation),
            get(Pressing::spin),
            get(Pressing::sway),
            get(Pressing::sway_speed),
            get(Pressing::rise),
            get(Pressing::rise_speed),
            get(Pressing::force) / planar_.gravity_mps2,
            deepest_crush(),
            slip_m()};
}

// Of the corner that it leans on: rocking about a corner moves the middle of the base, not that corner.
double ContactRun::slip_m() const {
    double const sine = get(Pressing::sine);  // the cosine's last digits drift
    double const lifted = planar_.half_width_m * sine * sine / (1 + std::abs(get(Pressing::cosine)));
    return get(Pressing::sway) - planar_.centre_height_m * get(Pressing::sine)
           - std::copysign(lifted, get(Pressing::rotation));
}

// Kinetic, of position and of springs, over the mass; none in settled rest.
double ContactRun::mechanical_energy() const {
    double const base = get(Pressing::rise) + planar_.centre_height_m * (1 - get(Pressing::cosine));
    double const middle = get(Pressing::sway) - planar_.centre_height_m * get(Pressing::sine);
    double springs = 0;
    for (int i = 0; i < lane_.points; ++i) {
        double const x = lane_.at(Spot::offset, i, 0);
        double const depth = get(Pressing::sine) * x - base - lane_.at(Spot::crush, i, 0);
        if (depth > 0) {
            double const shift = middle + get(Pressing::cosine) * x - lane_.at(Spot::anchor, i, 0);
            springs +=
                0.5 * lane_.at(Spot::stiffness, i, 0) * (depth * depth + planar_.pad.tangential_ratio * shift * shift);
        }
    }
    double const moving = get(Pressing::sway_speed) * get(Pressing::sway_speed)
                          + get(Pressing::rise_speed) * get(Pressing::rise_speed)
                          + planar_.inertia_over_mass_m2 * get(Pressing::spin) * get(Pressing::spin);
    return 0.5 * moving + springs + planar_.gravity_mps2 * (get(Pressing::rise) + 0.5 * planar_.settlement_m());
}

// Farther than springs that hold give way.
bool ContactRun::slipped() const { return get(Pressing::most_slip) > elastic_way(); }

// Of the sums that lanes keep, what needs no thought.
void ContactRun::tell_peaks(ContactOutcome& out) const {
    double const g = planar_.gravity_mps2;
    out.crest_rad = get(Pressing::crest);
    out.trough_rad = get(Pressing::trough);
    out.impacts = static_cast<std::int64_t>(get(Pressing::impacts));
    out.peak_impact_velocity_mps = 2 * planar_.half_width_m * get(Pressing::most_spin);
    out.steps = static_cast<std::int64_t>(get(Pressing::steps));
    out.friction_demand = out.friction_work_jpkg = never;
    out.min_contact_force_ratio = out.steps > 0 ? get(Pressing::least_force) / g : 1;
    out.peak_slip_m = get(Pressing::most_slip);
    out.residual_slip_m = slip_m();
    out.end_sway_mps = get(Pressing::sway_speed);
    out.own.peak_crush_m = deepest_crush();
    out.own.peak_contact_force_ratio = std::max(1.0, get(Pressing::most_force) / g);
    out.own.peak_rise_m = get(Pressing::most_rise) + planar_.settlement_m();
}

ContactOutcome ContactRun::finish() const {
    ContactOutcome out;
    tell_peaks(out);
    double const alpha = std::atan2(planar_.half_width_m, planar_.centre_height_m);
    double const radius = std::hypot(planar_.half_width_m, planar_.centre_height_m);
    double const rotation = get(Pressing::rotation);
    bool const fell = std::abs(rotation) >= pi / 2;
    bool const forward = out.crest_rad >= -out.trough_rad;
    auto const since = [](double time) { return time < 0 ? never : time; };
    out.first_uplift_s = since(get(Pressing::uplift_time));
    out.contact_lost_s = since(get(Pressing::loss_time));
    out.peak_rotation_rad = fell ? pi / 2 : std::max(out.crest_rad, -out.trough_rad);
    out.peak_rotation_ratio = out.peak_rotation_rad / alpha;
    if (fell) {
        out.overturn_time_s = out.time_of_peak_s = instant().time_s;
    } else if (out.peak_rotation_rad > 0) {
        out.time_of_peak_s = get(forward ? Pressing::crest_time : Pressing::trough_time);
    }
    out.peak_energy_ratio = get(Pressing::most_energy) / (1 - std::cos(alpha));
    double const turned = std::min(alpha, out.peak_rotation_rad) / 2;
    out.response_velocity_mps =
        2 * std::sqrt(planar_.gravity_mps2 * radius * std::sin(alpha - turned) * std::sin(turned));
    out.verdict = fell                              ? Verdict::overturned
                  : !std::isnan(out.first_uplift_s) ? Verdict::rocked
                  : slipped()                       ? Verdict::slid
                                                    : Verdict::at_rest;
    if (!std::isfinite(rotation + get(Pressing::sway) + get(Pressing::rise) + get(Pressing::spin))) {
        out.verdict = Verdict::failed;
        out.failure = FailureReason::no_convergence;
    }
    return out;
}

}  // namespace overturn::contact
