/// This program held against results of others: each row a result, its source, its number, ours, and what decides the
/// difference. A minute at most.
#pragma once

#include "qualify/check.hpp"

namespace overturn::qualify {

/// Pulses that overturn, steady rocking and slip, initiation, impulses, landing, fitted examples, a round base (L-..),
/// and the published numbers among the known answers of an installation. The remark says what was derived again, and
/// what the difference is of.
[[nodiscard]] Checks published();

}  // namespace overturn::qualify
