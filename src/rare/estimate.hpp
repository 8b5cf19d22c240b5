/// A probability as an estimator states it: with its interval and how far it can be trusted, or not at all.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "stats/proportion.hpp"

namespace overturn::rare {

enum class Method { crude, subset, pulse_mixture };
[[nodiscard]] std::string name_of(Method method);

/// not_trusted: a health check failed. not_resolved: too few failures were seen to say more than a bound.
enum class State { trusted, not_trusted, not_resolved };
[[nodiscard]] std::string name_of(State state);

/// One look at an estimator's health.
struct HealthCheck {
    std::string name;
    double value = 0;
    double limit = 0;
    bool passed = true;
};

/// Estimate at one factor. Printed is `probability` only where there is one.
struct Estimate {
    double factor = 0;
    Method method = Method::crude;
    State state = State::not_resolved;
    std::string reason;                 ///< why it is not trusted or not resolved; empty if trusted
    std::optional<double> probability;  ///< only if trusted
    Interval interval_95;               ///< if not trusted, from 0 to the bound that no assumption enters
    double cov = 0;                     ///< standard error over probability; 0 without one
    std::int64_t runs = 0;              ///< waves made, those that other factors share included
    double crude_runs = 0;              ///< waves that crude Monte Carlo needs for this c.o.v.; 0 without one
    std::vector<std::string> tried;     ///< estimators that were not trusted before: what was found of each
    std::vector<double> replicates;     ///< each one's estimate, for the eye; not to be used where it is not trusted
    std::vector<HealthCheck> health;
};

/// Failures seen among plain trials, and what they bound: the exact 95 % interval of Clopper and Pearson (1934).
struct Count {
    std::int64_t failed = 0;
    std::int64_t undecided = 0;
    std::int64_t trials = 0;

    void add(Count const& more) {
        failed += more.failed;
        undecided += more.undecided;
        trials += more.trials;
    }
};
/// Undecided trials count as safe for the lower end and as failed for the upper one.
[[nodiscard]] Interval clopper_pearson(Count const& count);

/// Mean of independent replicates with the 95 % interval of Student's t on the logarithm: P exp(+-t se / P).
struct ReplicateMean {
    double mean = 0;
    double standard_error = 0;
    Interval interval_95;
};
/// \pre at least two replicates
[[nodiscard]] ReplicateMean mean_of_replicates(std::span<double const> replicates);

/// Waves that crude Monte Carlo needs for a coefficient of variation.
[[nodiscard]] double crude_runs_for(double probability, double cov);

/// Turns an estimate into one that is not trusted: no probability, the bound of plain trials, the failed checks named.
void distrust(Estimate& estimate, State state, std::string reason, Count const& plain);

/// "hits at the fitted level .03 (at least .15)": the checks that did not pass.
[[nodiscard]] std::string words_of(std::span<HealthCheck const> failed);

}  // namespace overturn::rare
