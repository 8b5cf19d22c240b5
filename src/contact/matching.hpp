/// A base that rocks with the restitution that its body states: compliance may not bring one of its own unasked.
#pragma once

#include "contact/planar_contact.hpp"

namespace overturn {

/// e of free rocking from 0.3 alpha without slip: the root of the energy left after the first impact, of the heights
/// to which the centre of gravity is lifted [-]. Other amplitudes change it by less than 0.02.
[[nodiscard]] double emergent_restitution(RigidBody const& body, ContactBase const& base, ContactPad const& pad,
                                          ContactAccuracy const& accuracy = {});

struct ContactMatch {
    ContactBase base;        ///< with the corner share that was found
    ContactPad pad;          ///< with the points' restitution that was found
    double restitution = 0;  ///< that they give
};

/// Finds the corner share that gives the body's restitution, between a flat bed and corners alone; where corners alone
/// give back too much, softer points on corners; where a flat bed gives back too little, harder points on a flat bed.
/// \param base its number of points is kept; 11 if it has two
/// \throws InputError with the range that can be had
[[nodiscard]] ContactMatch match_restitution(RigidBody const& body, ContactBase const& base, ContactPad const& pad,
                                             ContactAccuracy const& accuracy = {});

}  // namespace overturn
