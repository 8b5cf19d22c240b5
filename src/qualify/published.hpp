/// Comparison with published results: each row has a result, its source, its number, ours, and the cause of the
/// difference. A minute at most.
#pragma once

#include <vector>

#include "qualify/check.hpp"

namespace overturn::qualify {

/// Pulses that overturn, steady rocking and slip, initiation, impulses, landing, fitted examples, a round base (L-..),
/// the published numbers among the known answers of an installation, and printed numbers that are wrong (D-..). The
/// remark says what was derived again, and what the difference is of.
[[nodiscard]] Checks published();

/// Published results that are not among these checks: they could not be consulted, or need data that are not part of
/// this program.
[[nodiscard]] std::vector<LeftOut> left_out_of_published();

}  // namespace overturn::qualify
