/// Waves as a map of standard normals, for estimators that choose these themselves.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "motion/ground_motion.hpp"

namespace overturn {

/// Independent standard normals give waves that are distributed as the source's own. Pure.
class NormalWaves {
  public:
    /// A map whose horizontal acceleration is envelope(t) sum_k S_k Re[(x_{2k-2} + i x_{2k-1}) exp(i w_k t)] less a
    /// baseline, k = 1, 2, ..., w_k = k spacing.
    struct LinearLines {
        std::size_t count = 0;
        double spacing_radps = 0;
    };

    NormalWaves() = default;
    NormalWaves(NormalWaves const&) = delete;
    NormalWaves& operator=(NormalWaves const&) = delete;
    NormalWaves(NormalWaves&&) = delete;
    NormalWaves& operator=(NormalWaves&&) = delete;
    virtual ~NormalWaves() = default;

    [[nodiscard]] virtual std::size_t normals() const = 0;
    [[nodiscard]] virtual GroundMotion make(std::span<double const> normals) const = 0;
    /// Nothing: the map is not linear.
    [[nodiscard]] virtual std::optional<LinearLines> linear() const { return std::nullopt; }
};

}  // namespace overturn
