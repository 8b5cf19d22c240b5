/// Waves that share what was drawn or recorded, and are no independent samples.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

namespace overturn {

struct SharedDraws {
    std::int64_t most = 1;              ///< so many waves at most share one; 1: all are independent
    std::vector<std::int64_t> of = {};  ///< number of the draw of each wave; empty: `most` in a row share one

    [[nodiscard]] std::int64_t operator()(std::int64_t wave) const {
        return of.empty() ? wave / most : of[static_cast<std::size_t>(wave)];
    }
    /// So many waves count as one in intervals: the design effect of clusters that end alike (Kish 1965).
    [[nodiscard]] double effect() const {
        std::map<std::int64_t, double> waves;
        for (auto const draw : of) {
            ++waves[draw];
        }
        double squares = 0;
        for (auto const& [draw, count] : waves) {
            squares += count * count;
        }
        return of.empty() ? static_cast<double>(most) : squares / static_cast<double>(of.size());
    }
    /// Whole ones of a number of independent waves.
    [[nodiscard]] static std::int64_t whole(double independent) {
        constexpr double rounding = 1e-9;
        return static_cast<std::int64_t>(independent + rounding);
    }
    /// Different ones of the first `waves`.
    [[nodiscard]] std::int64_t among(std::int64_t waves) const {
        return of.empty() ? (waves + most - 1) / most : std::ssize(std::set(of.begin(), of.begin() + waves));
    }
};

}  // namespace overturn
