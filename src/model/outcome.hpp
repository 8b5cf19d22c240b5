/// Outcome of a trial that every model gives.
#pragma once

#include "core/field.hpp"
#include "model/effect.hpp"
#include "model/failure.hpp"
#include "model/verdict.hpp"

namespace overturn {

/// Times count from the first sample [s]. What a model has more to say stands in fields of its own (ModelTraits).
struct Outcome {
    Verdict verdict = Verdict::at_rest;
    FailureReason failure = FailureReason::none;
    double peak_rotation_rad = 0;  ///< largest tilt; pi/2 if overturned
    double peak_rotation_ratio = 0;
    double time_of_peak_s = never;
    double peak_energy_ratio = 0;
    double overturn_time_s = never, first_uplift_s = never;
    // Of a body that overturned, at a tilt of pi/2, where its side reaches the pad; 0: it does not.
    double landing_spin_radps = 0;    ///< angular velocity
    double landing_velocity_mps = 0;  ///< of the centre of gravity
    double landing_top_mps = 0;       ///< of the point of its axis at twice the height of the centre of gravity
    double landing_energy_jpkg = 0;   ///< kinetic
    std::int64_t impacts = 0;
    double peak_impact_velocity_mps = 0;  ///< 2 b |omega| before an impact: the speed at which the far edge lands
    double friction_demand = 0, min_contact_force_ratio = 1;
    double contact_lost_s = never;
    double peak_slip_m = 0, residual_slip_m = 0, friction_work_jpkg = 0;
    double response_velocity_mps = 0;
    std::int64_t required = 0;  ///< EffectMask of those that would act, whether they were simulated or not
    std::int64_t steps = 0;
};

template <> [[nodiscard]] Fields const& fields_of<Outcome>();

/// Outcome of a trial that no model ran, for this reason: every quantity is unknown.
[[nodiscard]] Outcome unknown_outcome(FailureReason reason);

}  // namespace overturn
