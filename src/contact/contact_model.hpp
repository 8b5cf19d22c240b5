/// The body on compliant points as a model: rocking, sliding, bouncing and crushing in one.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string_view>

#include "contact/matching.hpp"
#include "contact/planar_contact.hpp"
#include "model/model.hpp"

namespace overturn {

[[nodiscard]] ModelTraits const& contact_traits();

/// Points grip one by one: no one ratio of forces, and no one work of friction, is known of them.
inline constexpr std::array<std::string_view, 2> lacks_on_points{"friction_demand", "friction_work"};

/// Required where the base is not two corners, and by the outcome of a cheaper model: a loss of contact, or, where base
/// or pad are stated, a tilt of 0.3 alpha or a fall (below, 0 of 341 verdicts differed), or an impact that may crush
/// the pad. A body of whose base and pad nothing is known gains nothing from a guess at them: on corners with the same
/// restitution 4 of 640 verdicts differed, two each way.
[[nodiscard]] std::unique_ptr<Model> make_contact_model(ContactAccuracy const& accuracy);

/// The body on its points, as the model has it: friction is its own, where the trial simulates sliding.
struct MatchedBlock {
    ContactBlock block;
    MatchedFooting match;
};
/// \throws InputError as contact_block
[[nodiscard]] MatchedBlock matched_block(RigidBody const& body, Footing const& footing,
                                         std::optional<Friction> const& friction);

}  // namespace overturn
