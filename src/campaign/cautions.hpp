/// Warnings that change how an answer may be read, short enough to stand with it.
#pragma once

#include <string>
#include <vector>

#include "campaign/campaign_spec.hpp"

namespace overturn {

/// A sentence each, without its full stop: parts of a body that would move on each other, a round base that may have
/// been meant, waves that are not controlled where a body rocks, records that drift or are scaled by more than is
/// usual. `warnings_of` says more, and what to do. Makes the records.
[[nodiscard]] std::vector<std::string> cautions_of(CampaignSpec const& spec);

}  // namespace overturn
