/// Reach of a body's base to each side, turned and tilted.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "campaign/body_spec.hpp"
#include "campaign/site.hpp"

namespace overturn {

/// Attitude of a body: turn about its axis, tilt of that axis, and direction of the tilt (from x towards y).
struct Pose {
    double yaw_rad = 0, tilt_rad = 0, azimuth_rad = 0;
};

/// A base as its edges reach in plan from its own middle, where the body's axis meets it. A round one is a circle.
class BaseReach {
  public:
    explicit BaseReach(BodySpec const& body);

    /// Towards a side, upright, as far as any turn up to this angle takes the edge [m]
    [[nodiscard]] double within_m(std::size_t side, double turn_rad) const;
    /// Towards a side, as it stands [m]
    [[nodiscard]] double posed_m(std::size_t side, Pose const& pose) const;
    [[nodiscard]] double farthest_m() const { return farthest_m_; }  ///< to its farthest corner

  private:
    struct Corner {
        double far_m, angle_rad;
    };
    std::vector<Corner> corners_;  ///< none of a round base
    double farthest_m_ = 0;
};

}  // namespace overturn
