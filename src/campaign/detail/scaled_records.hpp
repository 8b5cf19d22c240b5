/// Records that levels scale by more than guides allow.
#pragma once

#include <cstdint>
#include <string>

#include "campaign/campaign_spec.hpp"

namespace overturn {

inline constexpr double most_scaled = 5;  ///< what guides on the choice of records mostly allow

/// Scaling of records by the highest level, of the first thousand.
struct ScaledRecords {
    double most = 0;         ///< the largest factor
    std::int64_t which = 0;  ///< the record with it
    std::int64_t count = 0;  ///< records that are scaled by more than most_scaled
};
/// \throws InputError where a record is withheld
[[nodiscard]] ScaledRecords scaled_records(CampaignSpec const& spec);

/// "record 3 is scaled by up to 3500 ...", or "" if none of the first thousand is scaled by more than 5, or the levels
/// are by spectral ordinates, which are not looked at here.
[[nodiscard]] std::string warning_of_scaled_records(CampaignSpec const& spec);

}  // namespace overturn
