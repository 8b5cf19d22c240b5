/// Named rules that say whether an artificial wave may stand for its target, clause by clause.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "config/registry.hpp"
#include "config/table.hpp"
#include "generators/match_figures.hpp"
#include "spectra/target_spectrum.hpp"

namespace overturn {

/// The limits that a rule sets on a wave; a limit that it does not set is infinite or 0.
struct AcceptanceRule {
    double largest_time_step_s = std::numeric_limits<double>::infinity();
    double shortest_duration_s = 0;
    double lowest_ratio = 0;
    double highest_ratio = std::numeric_limits<double>::infinity();
    double most_adjacent_below = std::numeric_limits<double>::infinity();
    double lowest_intensity_ratio = 0;
    double largest_cov = std::numeric_limits<double>::infinity();
    double largest_mean_error = std::numeric_limits<double>::infinity();
    double aim = 1;  ///< ratio that a match for this rule aims at

    [[nodiscard]] bool enabled() const { return lowest_ratio > 0; }
};

/// The rule of a campaign, and the use of waves that miss it.
struct Acceptance {
    std::string rule = "none";
    std::int64_t most_drawn = 1;  ///< largest number of waves drawn for each one requested
    bool uses_refused = false;    ///< measured motions that miss the rule are tried all the same

    [[nodiscard]] bool asked() const { return rule != "none"; }
    /// Are waves that miss the rule no trials?
    [[nodiscard]] bool refuses() const { return asked() && !uses_refused; }
};

/// srp-3.7.1: US NRC NUREG-0800, section 3.7.1 rev. 4 (2014), option 1, approach 2: time step at most 0.01 s, at least
/// 20 s, and at 100 frequencies a decade from 0.1 Hz to 50 Hz, 5 % damping: nowhere more than 10 % below the target, no
/// more than 9 adjacent frequencies below it, nowhere more than 30 % above. japan: nowhere below 0.85, spectral
/// intensity over 0.1 s to 2.5 s at least 1, coefficient of variation at most 0.05, mean within 0.02 of 1. Both: end
/// velocity at most 1e-6 of the peak, components correlated at most 0.16, and by this program's own standard 5 % mean
/// misfit over [T0, T1] of every body and over any decade, since the others stop short of what overturns a cask.
[[nodiscard]] std::span<config::Entry<AcceptanceRule> const> acceptance_rules();

/// Fails at `key` unless the rules can judge waves made for this target: they speak of response spectra at 5 % damping,
/// and of SI from 0.1 s on.
void expect_judgeable(config::Table const& waves, char const* key, TargetSpectrum const& target);

/// One demand and how the wave met it.
struct Clause {
    std::string name;
    double figure = 0;
    double limit = 0;
    bool at_least = false;       ///< the figure must not be below its limit, else not above
    std::string component = {};  ///< whose spectrum it is about; empty: the wave as a whole

    [[nodiscard]] bool passed() const { return at_least ? figure >= limit : figure <= limit; }
    /// "lowest ratio 0.953 (at least 0.9): pass"
    [[nodiscard]] std::string text() const;
};

/// Names of all clauses there can be, in the order of the bits of failed_clauses.
[[nodiscard]] std::vector<std::string> clause_names();
/// Advice for waves that miss a clause, in the same order.
[[nodiscard]] std::vector<std::string> clause_remedies();
/// Bit n: the clause called clause_names()[n] is among `clauses` and did not pass.
[[nodiscard]] std::int64_t failed_clauses(std::span<Clause const> clauses);

/// Largest mean misfit over [T0, T1] and over any decade.
inline constexpr double largest_band_misfit = 0.05;

/// The figures of one component's match that the clauses on a spectrum need.
struct MatchFacts {
    MatchFigures figures;        ///< over all judged periods
    double worst_decade = 0;     ///< worst_decade_misfit
    double intensity_ratio = 0;  ///< spectral_intensity_ratio
    double judged_to_s = 0;      ///< longest judged period [s]
    double defined_to_s = 0;     ///< longest period that the rule checks and the target has [s]
};
/// The clauses on a spectrum.
[[nodiscard]] std::vector<Clause> spectrum_clauses(AcceptanceRule const& rule, MatchFacts const& facts);

/// The figures of a wave, besides its spectrum, that the clauses on a wave need.
struct WaveFacts {
    double time_step_s = 0;
    double duration_s = 0;
    double end_velocity_ratio = 0;  ///< |v| at the end over the peak [-]
    double correlation = 0;         ///< largest |coefficient| between two components [-]
};
[[nodiscard]] std::vector<Clause> wave_clauses(AcceptanceRule const& rule, WaveFacts const& facts);

/// The clause on [T0, T1] of a body.
[[nodiscard]] Clause band_clause(std::string const& body, double mean_misfit);

[[nodiscard]] bool all_passed(std::span<Clause const> clauses);

}  // namespace overturn
