/// Log of a running trial: peaks, monitors, times; and the observer who watches it.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "rocking/detail/block_laws.hpp"
#include "rocking/planar_rocking.hpp"

namespace overturn::rocking {

class TrialLog {
  public:
    TrialLog(double energy_top, RockingObserver* observer) : top_(energy_top), observer_(observer) {}

    [[nodiscard]] RockingOutcome const& outcome() const { return out_; }
    [[nodiscard]] RockingOutcome& outcome() { return out_; }
    [[nodiscard]] bool observed() const { return observer_ != nullptr; }
    [[nodiscard]] bool done() const { return done_; }

    /// Sets which corner it stands on. \param reach the weaker corner's alpha over this one's
    /// \param weight this corner's m g R over the weaker one's
    void stand_on(double side, double reach, double weight) {
        side_ = side;
        reach_ = reach;
        weight_ = weight;
    }
    void raise_peak(double phi, double time_s) { raise_peak(phi, time_s, side_); }
    void raise_peak(double phi, double time_s, double side) {
        if (double const reached = phi * reach_; reached > out_.peak_reach_rad) {
            out_.peak_reach_rad = reached;
            out_.peak_rotation_rad = phi;
            out_.time_of_peak_s = time_s;
            out_.peak_side = side;
        }
    }
    /// The rotation about this corner that would be as near to falling as the peak was.
    [[nodiscard]] double peak() const { return out_.peak_reach_rad / reach_; }
    /// \param energy above rest over m g R, of this corner
    void raise_energy(double energy) {
        energy_ = std::max(energy_, energy * weight_);
        out_.peak_energy_ratio = energy_ / top_;
    }
    [[nodiscard]] double energy_at_weaker() const { return energy_; }
    /// Peak energy over m g R of this corner [-].
    [[nodiscard]] double energy() const { return energy_ / weight_; }
    void raise_slip(double slip_m) {
        out_.peak_slip_m = std::max(out_.peak_slip_m, std::abs(slip_m));
        out_.most_slip_m = std::max(out_.most_slip_m, slip_m);
        out_.least_slip_m = std::min(out_.least_slip_m, slip_m);
    }
    void raise_demand(double demand) { out_.friction_demand = std::max(out_.friction_demand, demand); }
    void lower_contact(double normal) { out_.min_contact_force_ratio = std::min(out_.min_contact_force_ratio, normal); }
    /// Monitors the forces on a base that does not slip.
    void watch_forces(ContactForces<double> const& at) {
        lower_contact(at.normal);
        raise_demand(at.normal > 0 ? std::abs(at.friction) / at.normal : std::numeric_limits<double>::infinity());
    }
    void show(RockingInstant const& instant) {
        if (observer_ != nullptr) {
            observer_->at(instant);
        }
    }
    void uplifted(double time_s) {
        if (std::isnan(out_.first_uplift_s)) {
            out_.first_uplift_s = time_s;
        }
    }
    /// \param omega with which it lies down
    void overturn(double time_s, double omega) {
        out_.overturn_time_s = time_s;
        out_.landing_spin_radps = omega;
        out_.peak_reach_rad = 0;  // the fall is the peak, however near to falling over the other corner it was
        raise_peak(overturned_rad, time_s);
        end(Verdict::overturned);
    }
    void end(Verdict verdict) {
        out_.verdict = verdict;
        done_ = true;
    }
    void fail(FailureReason reason) {
        out_.failure = reason;
        end(Verdict::failed);
    }
    /// Continues from another log up to an instant. \param energy its energy_at_weaker()
    void resume(RockingOutcome const& so_far, double energy) {
        out_ = so_far;
        energy_ = energy;
    }
    void end_at_slip() {
        out_.slip_onset = true;
        done_ = true;
    }

  private:
    RockingOutcome out_;
    double top_;
    double energy_ = 0;  ///< its peak, over m g R of the weaker corner
    double side_ = 1, reach_ = 1, weight_ = 1;
    RockingObserver* observer_;
    bool done_ = false;
};

}  // namespace overturn::rocking
