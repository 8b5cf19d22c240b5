/// Waves that share what was drawn or recorded, and are no independent samples.
#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

namespace overturn {

struct SharedDraws {
    std::int64_t most = 1;              ///< so many waves at most share one; 1: all are independent
    std::vector<std::int64_t> of = {};  ///< number of the draw of each wave; empty: `most` in a row share one

    [[nodiscard]] std::int64_t operator()(std::int64_t wave) const {
        return of.empty() ? wave / most : of[static_cast<std::size_t>(wave)];
    }
    /// Different ones of the first `waves`.
    [[nodiscard]] std::int64_t among(std::int64_t waves) const {
        return of.empty() ? (waves + most - 1) / most : std::ssize(std::set(of.begin(), of.begin() + waves));
    }
};

}  // namespace overturn
