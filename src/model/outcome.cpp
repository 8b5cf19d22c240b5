#include "model/outcome.hpp"

#include <string>

namespace overturn {
namespace {

std::vector<Category> reasons() {
    std::vector<Category> categories;
    for (auto const& entry : failures()) {
        categories.push_back({static_cast<std::int64_t>(entry.value), std::string(entry.name)});
    }
    return categories;
}

std::vector<Category> verdicts_of_all() {
    std::vector<Category> categories;
    for (auto const& entry : common_verdicts()) {
        categories.push_back({static_cast<std::int64_t>(entry.value), std::string(entry.name)});
    }
    return categories;
}

}  // namespace

template <> Fields const& fields_of<Outcome>() {
    using O = Outcome;
    static Fields const fields{
        category<&O::verdict>("verdict", "how the trial ended", verdicts_of_all()).always(),
        category<&O::failure>("failure", "why a failed trial has no verdict", reasons()),
        field<&O::peak_rotation_rad>("peak_rotation", "rad", "max |theta|; pi/2 if overturned"),
        field<&O::peak_rotation_ratio>("peak_rotation_ratio", "1", "max |theta| / alpha"),
        field<&O::time_of_peak_s>("time_of_peak", "s", "time of max |theta|; NaN: never moved"),
        field<&O::peak_energy_ratio>("peak_energy_ratio", "1",
                                     "max of rocking energy over the energy of critical uplift m g (R - h)"),
        field<&O::overturn_time_s>("overturn_time", "s", "time of |theta| = pi/2; NaN: not overturned"),
        field<&O::landing_spin_radps>(
            "landing_spin", "rad/s", "angular velocity when an overturning body lies, at |theta| = pi/2; 0: it stands"),
        field<&O::landing_velocity_mps>("landing_velocity", "m/s",
                                        "velocity of the centre of gravity when it lies, flights included; NaN: of a "
                                        "flight, by an earlier program"),
        field<&O::landing_top_mps>(
            "landing_top_velocity", "m/s",
            "velocity of the top when it lies: on the axis, at twice the height of the centre of "
            "gravity; NaN as landing_velocity"),
        field<&O::landing_energy_jpkg>("landing_energy", "J/kg",
                                       "kinetic energy when it lies, over the mass; NaN as landing_velocity"),
        field<&O::first_uplift_s>("first_uplift", "s", "time of the first uplift; NaN: never"),
        field<&O::impacts>("impacts", "1", "number of base impacts, without the final bouncing"),
        field<&O::peak_impact_velocity_mps>(
            "peak_impact_velocity", "m/s",
            "largest speed at which the far edge of the base lands, 2 b |omega| before an impact; 0: no impact"),
        field<&O::friction_demand>(
            "friction_demand", "1",
            "friction coefficient that prevents slip, max |F| / N; the static coefficient once the body has slipped; "
            "infinite where a body that does not slip loses contact"),
        field<&O::min_contact_force_ratio>("min_contact_force_ratio", "1", "min N / (m g)"),
        field<&O::contact_lost_s>(
            "contact_lost_time", "s",
            "time at which a rigid base first left the ground, which its model does not follow; NaN: never"),
        field<&O::peak_slip_m>("peak_slip", "m", "max |slip| of the base"),
        field<&O::residual_slip_m>("residual_slip", "m", "slip at the end"),
        field<&O::friction_work_jpkg>("friction_work", "J/kg", "work lost in slip, over the mass"),
        field<&O::response_velocity_mps>(
            "v_resp", "m/s",
            "response velocity of the peak rotation: at most V_Ereq in the plane, more over a corner in space"),
        field<&O::required>("effects_called", "1", "bit mask of the required effects, as found by the monitors")
            .always(),
        field<&O::steps>("steps", "1", "number of evaluated Taylor series")};
    return fields;
}

Outcome unknown_outcome(FailureReason reason) {
    Outcome outcome;
    outcome.verdict = Verdict::failed;
    outcome.failure = reason;
    for (auto const& field : fields_of<Outcome>()) {
        if (field.type == FieldType::real) {
            set_real(std::as_writable_bytes(std::span(&outcome, 1)), field, never);
        }
    }
    return outcome;
}

}  // namespace overturn
