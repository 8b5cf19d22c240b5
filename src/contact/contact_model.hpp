/// The body on compliant points as a model: rocking, sliding, bouncing and crushing in one.
#pragma once

#include <memory>

#include "contact/matching.hpp"
#include "contact/planar_contact.hpp"
#include "model/model.hpp"

namespace overturn {

[[nodiscard]] ModelTraits const& contact_traits();

/// What bodies stand on, and whether their restitution decides how.
enum class Restitution { of_the_body, of_the_base };
struct ContactSetup {
    ContactBase base = {};
    ContactPad pad = {};
    Restitution restitution = Restitution::of_the_body;
    double base_depth_m = 0;  ///< across the rocking plane; 0: as wide as the base
    ContactAccuracy accuracy = {};
};

/// Called for where the base is not two corners, and by what a cheaper model said: a tilt of 0.3 alpha or a fall
/// (below, 0 of 341 verdicts differed), a loss of contact, an impact that may crush the pad.
[[nodiscard]] std::unique_ptr<Model> make_contact_model(ContactSetup const& setup);

}  // namespace overturn
