#include "output/detail/body_table.hpp"

#include <span>

#include "campaign/rocking_band.hpp"
#include "spectra/band_rule.hpp"

namespace overturn::output {

Table body_table(CampaignSpec const& spec, std::size_t number) {
    auto const& stated = spec.bodies[number];
    auto const band = rocking_band(stated.body, spec.measures.radius_unit);
    TableOf<BodySpec> table({.name = "bodies", .group = "bodies/" + stated.name, .axis = "body"},
                            std::span(&stated, 1));
    auto const of_body = [](double (RigidBody::*value)() const) {
        return [value](BodySpec const& row) { return (row.body.*value)(); };
    };
    using B = RigidBody;
    table.add("body", "1", "number of the body, as in /trials/body", [number](BodySpec const&) { return number; })
        .add("name", "1", "its name", [](BodySpec const& row) { return row.name; })
        .add("mass", "kg", "mass", of_body(&B::mass_kg))
        .add("half_width", "m", "b, half of the base", of_body(&B::half_width_m))
        .add("centre_height", "m", "h, height of the centre of gravity", of_body(&B::centre_height_m))
        .add("inertia", "kg m2", "moment of inertia about the centre of gravity", of_body(&B::inertia_kgm2))
        .add("radius", "m", "R = sqrt(b^2 + h^2)", of_body(&B::radius_m))
        .add("alpha", "rad", "critical angle atan(b/h)", of_body(&B::alpha_rad))
        .add("p", "rad/s", "frequency parameter sqrt(m g R / I_O)", of_body(&B::p_radps))
        .add("restitution", "1", "median restitution", of_body(&B::restitution))
        .add("housner_restitution", "1", "1 - 2 m b^2 / I_O", of_body(&B::housner_restitution))
        .add("axes", "1", "components that shake it: 1 horizontal, 2 both horizontal, 3 the vertical one too",
             [](BodySpec const& row) { return row.axes; })
        .add("t0", "s", "shortest rocking period of the body", [=](BodySpec const&) { return band.t0_s; })
        .add("t1", "s", "longest rocking period of the body", [=](BodySpec const&) { return band.t1_s; })
        .add("v_ereq", "m/s", "limit velocity sqrt(2 g (R - h))", of_body(&B::limit_velocity_mps));
    return table.take();
}

}  // namespace overturn::output
