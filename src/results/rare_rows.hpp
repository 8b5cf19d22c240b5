/// Rare-event trials as rows: enough to draw every one of them again.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/field.hpp"
#include "rare/automatic.hpp"

namespace overturn {

/// A limit state of one body.
struct RareBody {
    std::size_t body = 0, limit = 0;        ///< numbers in the campaign; limit 0: overturning
    std::vector<rare::Estimate> estimates;  ///< one per level
    rare::Record record;
};

/// Weights are sums' business: no count of rows means anything.
struct RareRow {
    std::int64_t method = 0;  ///< rare::Method
    std::int64_t run = 0;     ///< of the method, from 0: which mixture, which subset simulation
    std::int64_t problem = 0, replicate = 0, phase = 0, stage = 0, step = 0, index = 0;
    std::int64_t parent = -1;
    double weight = 1, step_size = never, driver = never;
    std::int64_t failed = 0, undecided = 0, plain = 1;
};
template <> [[nodiscard]] Fields const& fields_of<RareRow>();

/// In the order of rare::Method and rare::State.
[[nodiscard]] std::vector<std::string> rare_method_names();
[[nodiscard]] std::vector<std::string> rare_state_names();

/// All rows that a body's estimators left, mixtures first.
[[nodiscard]] std::vector<RareRow> rare_rows(RareBody const& body);

}  // namespace overturn
