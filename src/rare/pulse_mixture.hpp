/// Importance sampling with a mixture of failure pulses: rare events of waves that are linear in their normals.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rare/crude.hpp"
#include "rare/detail/pulse_fit.hpp"
#include "rare/mixture.hpp"

namespace overturn::rare {

struct PulseOptions {
    std::int64_t pilot_runs = 2000;  ///< of a stage and replicate; 1000 is the floor
    std::int64_t final_runs = 4000;  ///< of a replicate, at first
    std::int64_t most_rounds = 3;    ///< of final runs, each up to as many as all before it, until the c.o.v. is met
    double descent = 0.87;           ///< from one pilot stage to the next
    std::int64_t refits = 2;         ///< at the fitted factor, failures pooled
    FitOptions fit{};                ///< without pulses: crude Monte Carlo, bit for bit
};

/// A trial that was drawn from a mixture. Its weight is no count: only sums of weights mean anything.
struct WeightedRow {
    double weight = 1;            ///< density of a plain draw over that of the mixture
    std::uint64_t failed = 0;     ///< one bit for each factor
    std::uint64_t undecided = 0;  ///< likewise
    std::int64_t plain = 0;       ///< 1: left as it was drawn
};

/// Trials of one stage of one replicate, drawn from `mixture` with `key`, indices 0, 1, ...
struct MixtureStage {
    DrawKey key;
    std::vector<double> factors;
    Mixture mixture;
    std::vector<WeightedRow> rows;
};

struct PulseResult {
    std::vector<Estimate> estimates;                ///< one per factor
    std::vector<std::vector<MixtureStage>> stages;  ///< of every replicate; the last one holds all final runs
};

/// All factors from the same final waves, whose pulses are fitted at `fitted_factor`: best in the middle of the
/// factors. \param crude what plain trials gave at each factor, which the estimates have to agree with; empty: nothing
/// known \pre the problem has a frame
[[nodiscard]] PulseResult estimate_pulse_mixture(Problem const& problem, std::span<double const> factors,
                                                 double fitted_factor, Request const& request, Workforce& workers,
                                                 std::span<Count const> crude = {}, PulseOptions const& options = {});

/// The normals of a row. \return whether they were left as they were drawn
bool draw_from(Mixture const& mixture, DrawKey const& key, std::span<double> normals);

}  // namespace overturn::rare
