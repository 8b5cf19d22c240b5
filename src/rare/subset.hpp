/// Subset simulation: a rare event as a chain of common ones, for any map from normals to answers.
#pragma once

#include <cstdint>
#include <vector>

#include "rare/crude.hpp"

namespace overturn::rare {

/// Au and Beck (2001) with adaptive conditional sampling (Papaioannou, Betz, Zwirglmaier and Straub 2015).
struct SubsetOptions {
    std::int64_t samples = 2000;  ///< N, of a level
    std::int64_t chains = 200;    ///< N_c; each has samples / chains states, its seed the first
    std::int64_t most_levels = 14;
    double first_step = 0.5;  ///< s: x' = sqrt(1 - s^2) x + s xi
    double wanted_acceptance = 0.44;
    std::int64_t most_growth =
        4;  ///< replicates are added up to so many times those requested, until the c.o.v. is met
};

/// A state of a chain by its descent: x of a root is its draw, of others sqrt(1 - s^2) x(parent) + s draw, rounded to
/// single precision. So states can be had again from their draws' identities alone.
struct SubsetNode {
    std::int64_t parent = -1;                     ///< of the same replicate; -1: a root
    std::int64_t level = 0, step = 0, index = 0;  ///< of its draw
    double step_size = 0;                         ///< s
    double driver = 0;
    std::int64_t failed = 0;
};

/// Record of a replicate.
struct SubsetReplicate {
    double probability = 0;
    std::int64_t levels = 0;         ///< below the last
    std::vector<double> thresholds;  ///< of the driver
    std::vector<double> acceptance;  ///< over each level's chains
    std::vector<SubsetNode> nodes;
};

struct SubsetResult {
    Estimate estimate;
    DrawKey key;  ///< of the draws, but for replicate, level, step and index
    std::vector<SubsetReplicate> replicates;
};

/// At one factor. Not trusted if the driver is not nested, its thresholds tie or trials are undecided; not resolved if
/// the last level is not reached. max_runs ends it with what it says to be not resolved. Replicates are added while the
/// c.o.v. exceeds target_cov and max_runs allows. \param plain trials at this factor made before, for the bound of an
/// estimate that is not trusted
[[nodiscard]] SubsetResult estimate_subset(Problem const& problem, double factor, Request const& request,
                                           Workforce& workers, SubsetOptions const& options = {},
                                           Count const& plain = {});

/// The normals of a node. \pre the node is one of `nodes`
void normals_of_node(std::vector<SubsetNode> const& nodes, std::int64_t node, DrawKey key, std::span<double> normals);

}  // namespace overturn::rare
