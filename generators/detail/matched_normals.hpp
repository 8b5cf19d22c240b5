/// Spectrum-compatible waves as a map of standard normals.
#pragma once

#include <vector>

#include "generators/detail/spectrum_matcher.hpp"
#include "generators/normal_waves.hpp"

namespace overturn {

/// The components' normals are contiguous, the horizontal one's first; chance correlations between
/// components are left as they come. Linear where waves are neither iterated nor of fixed amplitudes.
class MatchedNormals : public NormalWaves {
  public:
    /// A component and its place in the motion. The matcher outlives this.
    struct Part {
        SpectrumMatcher const* matcher;
        std::vector<double> GroundMotion::*place;
    };
    MatchedNormals(std::vector<Part> parts, double time_step_s) : parts_(std::move(parts)), time_step_s_(time_step_s) {}

    [[nodiscard]] std::size_t normals() const override;
    [[nodiscard]] GroundMotion make(std::span<double const> normals) const override;
    [[nodiscard]] std::optional<LinearLines> linear() const override;

  private:
    std::vector<Part> parts_;
    double time_step_s_;
};

}  // namespace overturn
