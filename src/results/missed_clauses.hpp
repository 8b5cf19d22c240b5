/// Clauses of an acceptance rule that waves missed, by component, and at which periods.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "campaign/rows.hpp"

namespace overturn {

/// One clause that some waves missed.
struct MissedClause {
    std::string component;  ///< whose spectrum; empty: it is about the wave as a whole
    std::string clause;     ///< one of clause_names()
    std::int64_t waves = 0;
    std::optional<double> worst = {};                            ///< the figure of the wave that missed it most
    std::optional<double> from_period_s = {}, to_period_s = {};  ///< range of nine tenths of them [s]
};

/// Counts over waves that miss the rule, in any order.
class MissedClauses {
  public:
    void add(WaveRow const& row);
    /// Missed clauses, the most often missed first.
    [[nodiscard]] std::vector<MissedClause> rows() const;
    [[nodiscard]] bool empty() const { return seen_.empty(); }

  private:
    struct Seen {
        std::int64_t waves = 0;
        std::optional<double> worst;
        std::vector<double> periods_s;
    };
    void add_component(std::size_t component, std::int64_t failures, ComponentMatch const& match, double worst_decade);

    std::map<std::pair<std::size_t, std::size_t>, Seen> seen_;  ///< by clause and component
};

}  // namespace overturn
