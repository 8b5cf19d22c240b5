/// The block for a spectrum over pulses or sizes, stated by --alpha and --restitution or by --body.
#pragma once

#include <string>
#include <string_view>

#include "campaign/body_spec.hpp"

namespace overturn::cli {

/// "90 deg" [rad]. \param option named in messages \throws InputError
[[nodiscard]] double stated_angle(std::string_view text, char const* option);

/// Of --alpha, between 0 and 90 degrees [rad]. \throws InputError
[[nodiscard]] double stated_alpha(std::string_view text);

/// Checked value of --restitution, from 0 to 1. \throws InputError
[[nodiscard]] double stated_restitution(double value);

/// The body of a file, with its warnings on stderr. \param spectrum names the request in messages: "a rocking spectrum"
/// \throws InputError where it has slope, offset or initial tilt
[[nodiscard]] BodySpec symmetric_body(std::string const& file, char const* spectrum);

}  // namespace overturn::cli
