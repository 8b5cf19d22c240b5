#include "body/similarity.hpp"

#include <utility>

#include "core/error.hpp"

namespace overturn {
namespace {

void check(SimilarityLaw const& law) {
    for (auto const& [value, name] : {std::pair{law.length, "length ratio"}, std::pair{law.mass_factor, "mass factor"},
                                      std::pair{law.stiffness_factor, "stiffness factor"}}) {
        validate(value > 0 && std::isfinite(value), "{} of {} (must be positive and finite). State model / prototype",
                 name, value);
    }
}

}  // namespace

BodyInput model_of(BodyInput const& prototype, SimilarityLaw const& law) {
    check(law);
    BodyInput model = prototype;
    model.mass_kg *= law.mass();
    model.half_width_m *= law.length;
    model.centre_height_m *= law.length;
    model.offset_m *= law.length;
    model.inertia_kgm2 *= law.inertia();
    return model;
}

BodyInput prototype_of(BodyInput const& model, SimilarityLaw const& law) {
    check(law);
    BodyInput prototype = model;
    prototype.mass_kg /= law.mass();
    prototype.half_width_m /= law.length;
    prototype.centre_height_m /= law.length;
    prototype.offset_m /= law.length;
    prototype.inertia_kgm2 /= law.inertia();
    return prototype;
}

}  // namespace overturn
