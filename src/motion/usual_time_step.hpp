/// Is a record's time step one that records have, or was its unit mistaken?
#pragma once

#include <string>

namespace overturn {

/// "time step of 10 s (nothing above 0.05 Hz is in it)", above 0.1 s and below 5e-5 s; empty of all others. Seconds
/// that are taken for milliseconds make 2e-5 s of 0.02 s and less of less, milliseconds that are taken for seconds 5 s
/// of 5 ms.
[[nodiscard]] std::string unusual_time_step(double step_s);

}  // namespace overturn
