/// Accuracy settings of the integration on compliant points.
#pragma once

#include "model/run_out.hpp"

namespace overturn {

struct ContactAccuracy {
    double step_ratio = 0.3;  ///< longest step times w_v: 0.49 ms at 98 Hz; shorter where damping requires it
    /// Longest time that a body is followed after the wave until it rests [s]
    double longest_after_s = overturn::longest_after_s;
    bool rest_gate = true;  ///< a quiet body is held at rest while the shaking is too weak to part its base
};

}  // namespace overturn
