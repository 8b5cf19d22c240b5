/// A base that rocks with the restitution that its body states: compliance may not bring one of its own unasked.
#pragma once

#include "contact/base_layout.hpp"
#include "contact/planar_contact.hpp"

namespace overturn {

/// e of free rocking from 0.3 alpha without slip: the root of the energy left after the first impact, of the heights
/// to which the centre of gravity is lifted [-]. Other amplitudes change it by less than 0.02.
[[nodiscard]] double emergent_restitution(RigidBody const& body, BasePlan const& base, Pad const& pad,
                                          ContactAccuracy const& accuracy = {});

/// Finds a base that gives the body's restitution. A square base that stands on its corners: the corner share, between
/// corners alone and a flat bed; where corners alone give back too much, softer points on corners; where a flat bed
/// gives back too little, harder points on a flat bed. Any other base is what it is: softer or harder points on it.
/// Where none gives it, the nearest: Housner's value, which is that of corners that give nothing back, may lie below
/// what points of 0.05 do. A pad that is not to be matched is taken as it is.
[[nodiscard]] MatchedFooting match_restitution(RigidBody const& body, BasePlan const& base, Pad const& pad,
                                               ContactAccuracy const& accuracy = {});

/// Footing of the body: the one known beforehand, or one matched at the usual step. A polygon stays as stated, and its
/// restitution is not known.
[[nodiscard]] MatchedFooting matched_footing(RigidBody const& body, Footing const& footing);

/// Fills the fields of a trial that describe its base.
template <class Quantities> void fill_match(MatchedFooting const& match, Quantities& own) {
    own.restitution = match.restitution;
    own.normal_restitution = match.pad.normal_restitution;
    if (match.base.shape == BaseShape::square) {
        own.corner_share = match.base.corner_share.value_or(flat_share(match.base.points));
    }
}

}  // namespace overturn
