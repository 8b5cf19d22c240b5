/// What a trial remembers while it runs: peaks, monitors, times; and the observer who watches it.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "rocking/planar_rocking.hpp"

namespace overturn::rocking {

class TrialLog {
  public:
    TrialLog(double energy_top, RockingObserver* observer) : top_(energy_top), observer_(observer) {}

    [[nodiscard]] RockingOutcome const& outcome() const { return out_; }
    [[nodiscard]] RockingOutcome& outcome() { return out_; }
    [[nodiscard]] bool observed() const { return observer_ != nullptr; }
    [[nodiscard]] bool done() const { return done_; }

    void raise_peak(double phi, double time_s) {
        if (phi > out_.peak_rotation_rad) {
            out_.peak_rotation_rad = phi;
            out_.time_of_peak_s = time_s;
        }
    }
    /// \param energy above rest over m g R
    void raise_energy(double energy) {
        energy_ = std::max(energy_, energy);
        out_.peak_energy_ratio = energy_ / top_;
    }
    [[nodiscard]] double energy() const { return energy_; }
    void raise_slip(double slip_m) { out_.peak_slip_m = std::max(out_.peak_slip_m, std::abs(slip_m)); }
    void raise_demand(double demand) { out_.friction_demand = std::max(out_.friction_demand, demand); }
    void lower_contact(double normal) { out_.min_contact_force_ratio = std::min(out_.min_contact_force_ratio, normal); }
    /// Contact forces over m g of a base that does not slip.
    void watch_forces(double friction, double normal) {
        lower_contact(normal);
        raise_demand(normal > 0 ? std::abs(friction) / normal : std::numeric_limits<double>::infinity());
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
    void overturn(double time_s) {
        out_.overturn_time_s = time_s;
        raise_peak(0.5 * pi, time_s);
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
    /// What another log has remembered up to an instant.
    void resume(RockingOutcome const& so_far, double energy) {
        out_ = so_far;
        energy_ = energy;
    }
    void call_slip() {
        out_.slip_called = true;
        done_ = true;
    }

  private:
    RockingOutcome out_;
    double top_;
    double energy_ = 0;  ///< its peak
    RockingObserver* observer_;
    bool done_ = false;
};

}  // namespace overturn::rocking
