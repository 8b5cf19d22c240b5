/// Chance that a statistic is as large as it was found, by simulation.
#pragma once

#include <algorithm>
#include <optional>

#include "core/random_stream.hpp"
#include "stats/bootstrap.hpp"

namespace overturn {

/// \param draw(number) the statistic of that draw from the null hypothesis; nothing: it says nothing of it
/// \param enough draws as large as that end the search (Besag & Clifford 1991, Biometrika 78(2))
template <class Draw>
[[nodiscard]] double chance_of_draws(double found, BootstrapKey const& key, int enough, Draw const& draw) {
    constexpr int least = 199;
    constexpr int most = 999;
    constexpr double rounding = 1e-9;
    int const draws = std::clamp(key.replicates, least, most);
    int counted = 0;
    int larger = 0;
    for (int r = 0; r < draws; ++r) {
        std::optional<double> const drawn = draw(r);
        if (!drawn) {
            continue;
        }
        ++counted;
        larger += *drawn >= found * (1 - rounding) ? 1 : 0;
        if (larger == enough) {
            return static_cast<double>(larger) / counted;
        }
    }
    return (larger + 1.0) / (counted + 1.0);
}

/// The same, each draw(stream) from a stream of its own.
template <class Draw>
[[nodiscard]] double simulated_chance(double found, BootstrapKey const& key, int enough, Draw const& draw) {
    return chance_of_draws(found, key, enough, [&](int r) {
        RandomStream stream(key.seed, static_cast<std::uint64_t>(r), Purpose::shape_test, key.stream);
        return draw(stream);
    });
}

}  // namespace overturn
