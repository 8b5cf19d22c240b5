/// Standard normal scores of the points that are read off a lognormal fragility curve.
#pragma once

namespace overturn {

inline constexpr double hclpf_score = 1.645;                    ///< 5 %, as HCLPF is defined (EPRI TR-103959, 1994)
inline constexpr double one_percent_score = 2.326347874040841;  ///< 1 %

}  // namespace overturn
