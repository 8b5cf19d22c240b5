/// Waves that share what was drawn or recorded, and are no independent samples.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace overturn {

struct SharedDraws {
    std::int64_t most = 1;              ///< so many waves at most share one; 1: all are independent
    std::vector<std::int64_t> of = {};  ///< number of the draw of each wave; empty: `most` in a row share one

    [[nodiscard]] std::int64_t operator()(std::int64_t wave) const { return of.empty() ? wave / most : of[wave]; }
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
    /// Waves share what they share in either: of several together the lowest number.
    [[nodiscard]] SharedDraws joined(SharedDraws const& other, std::int64_t waves) const {
        std::vector<std::int64_t> number(static_cast<std::size_t>(waves));
        std::iota(number.begin(), number.end(), 0);
        for (bool changed = true; changed;) {
            changed = false;
            for (auto const* draws : {this, &other}) {
                std::map<std::int64_t, std::int64_t> lowest;
                for (std::int64_t wave = 0; wave < waves; ++wave) {
                    auto const [at, is_new] = lowest.emplace((*draws)(wave), number[wave]);
                    at->second = std::min(at->second, number[wave]);
                }
                for (std::int64_t wave = 0; wave < waves; ++wave) {
                    auto const of_draw = lowest.at((*draws)(wave));
                    changed = changed || of_draw < number[wave];
                    number[wave] = of_draw;
                }
            }
        }
        std::int64_t together = 1;
        for (auto const draw : number) {
            together = std::max<std::int64_t>(together, std::ranges::count(number, draw));
        }
        return {.most = together, .of = together == 1 ? std::vector<std::int64_t>{} : std::move(number)};
    }
    /// Different ones of the first `waves`.
    [[nodiscard]] std::int64_t among(std::int64_t waves) const {
        return of.empty() ? (waves + most - 1) / most : std::ssize(std::set(of.begin(), of.begin() + waves));
    }
};

}  // namespace overturn
