/// Warnings about a fragility curve, in sentences.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "stats/fragility.hpp"
#include "stats/intensity_unit.hpp"

namespace overturn::output {

/// "a grid of 15 frequencies is no sample: no curve"
[[nodiscard]] std::string grid_text(std::int64_t waves);
/// "1 record: no probability, which needs 5 or more"
[[nodiscard]] std::string few_records_text(std::int64_t records, std::int64_t recordings);
/// "3 of 200"; "3 of 200, counting 10 as one"
[[nodiscard]] std::string counts_text(SeenBound const& seen);
/// What trials do that pass the curve's limit state: "overturn", "exceed the limit".
[[nodiscard]] char const* pass_text(FragilityFit const& fit);
/// One sentence for everything a reader must know.
[[nodiscard]] std::vector<std::string> warnings_of(FragilityFit const& fit, IntensityUnit const& unit,
                                                   double confidence);

}  // namespace overturn::output
