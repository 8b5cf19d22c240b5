/// The block for a spectrum over pulses or sizes, stated by --alpha and --restitution or by --body.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "campaign/body_spec.hpp"
#include "rocking/planar_rocking.hpp"

namespace overturn::cli {

/// "90 deg" [rad]. \param option named in messages \throws InputError
[[nodiscard]] double stated_angle(std::string_view text, char const* option);

/// Of --alpha, between 0 and 90 degrees [rad]. \throws InputError
[[nodiscard]] double stated_alpha(std::string_view text);

/// Checked value of --restitution, from 0 to 1. \throws InputError
[[nodiscard]] double stated_restitution(double value);

/// A body as a rigid block on two corners in one plane.
struct PlaneBody {
    BodySpec spec;
    RockingBlock block;                 ///< where its base has a restitution of its own, with that
    std::vector<std::string> left_out;  ///< what the file states and the block has not
};

/// The body of a file, with its warnings on stderr. \param spectrum names the request in messages: "a rocking spectrum"
/// \throws InputError where it has slope, offset or initial tilt
[[nodiscard]] PlaneBody plane_body(std::string const& file, char const* spectrum);

}  // namespace overturn::cli
