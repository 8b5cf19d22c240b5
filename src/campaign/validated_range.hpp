/// Range of the tests that validate the program, and the bodies of a campaign outside it.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "campaign/campaign_spec.hpp"

namespace overturn {

/// Whether what was tested stands behind each quantity: "alpha 33.1 deg (tested: 4.58 to 8.02 deg)".
enum class Tested { stated, left_out };

/// Bodies outside of the range of 245 tests of two granite blocks on a shaking table (doi 10.26443/seismica.v3i1.692;
/// tests/validation/experiments): one component, no base that was measured to be flat, friction unknown. "type-a,
/// type-b: alpha 33.1 deg (tested: 4.58 to 8.02 deg), ...": bodies that leave the range in the same way together.
/// Angles and velocities in the units that the campaign states. Empty: all are inside.
[[nodiscard]] std::vector<std::string> outside_validated_range(CampaignSpec const& spec,
                                                               Tested ranges = Tested::stated);

/// One line: what was tested, and which bodies lie outside in what.
/// \param most of such groups of bodies; further ones are counted
[[nodiscard]] std::string validated_range_text(CampaignSpec const& spec, std::size_t most = 4);

}  // namespace overturn
