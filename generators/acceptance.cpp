#include "generators/acceptance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

namespace overturn {
namespace {

struct ClauseText {
    char const* name;
    char const* remedy;
};
constexpr auto* follow = "State a longer duration or level part of the envelope, or more match_iterations";
// The order is that of stored bits: never change it, only add.
constexpr std::array clause_texts{
    ClauseText{"time step", "State a waves.time_step of at most 0.01 s"},
    ClauseText{"duration", "State a waves.duration of at least 20 s"},
    ClauseText{"judged to", "State waves.target.longest up to the target's last period, or 10 s"},
    ClauseText{"lowest ratio", follow},
    ClauseText{"adjacent below", follow},
    ClauseText{"highest ratio", follow},
    ClauseText{"SI ratio", follow},
    ClauseText{"cov of the ratio", follow},
    ClauseText{"error of the mean", follow},
    ClauseText{"worst decade", follow},
    ClauseText{"end velocity", "State an envelope that ends before the wave does"},
    ClauseText{"component correlation", "State no correlation above 0.16, or a longer duration"},
    ClauseText{"rocking band", "State waves.target.longest beyond T1 of every body, or a longer duration"}};

Clause at_most(std::size_t name, double figure, double limit) {
    return {clause_texts.at(name).name, figure, limit, false, {}};
}
Clause at_least(std::size_t name, double figure, double limit) {
    return {clause_texts.at(name).name, figure, limit, true, {}};
}

}  // namespace

std::span<config::Entry<AcceptanceRule> const> acceptance_rules() {
    static constexpr std::array entries{
        config::Entry<AcceptanceRule>{"none", "no rule: waves are reported, none is refused", {}},
        config::Entry<AcceptanceRule>{
            "srp-3.7.1",
            "spectrum clauses of US NRC SRP 3.7.1, option 1, approach 2 (not its power spectral density, strong-motion "
            "duration, V/A and AD/V2), and 5 % over [T0, T1]",
            {.largest_time_step_s = 0.01,
             .shortest_duration_s = 20,
             .lowest_ratio = 0.90,
             .highest_ratio = 1.30,
             .most_adjacent_below = 9,
             .aim = 1.02}},
        config::Entry<AcceptanceRule>{"japan",
                                      "ratio 0.85, SI 1, cov 0.05, mean 0.02, and 5 % over [T0, T1]",
                                      {.lowest_ratio = 0.85,
                                       .lowest_intensity_ratio = 1,
                                       .largest_cov = 0.05,
                                       .largest_mean_error = 0.02,
                                       .aim = 1.01}},
    };
    return entries;
}

std::string Clause::text() const {
    return fmt::format("{} {:.4g} (at {} {:g}): {}", name, figure, at_least ? "least" : "most", limit,
                       passed() ? "pass" : "fail");
}

std::vector<std::string> clause_names() {
    std::vector<std::string> names;
    std::ranges::transform(clause_texts, std::back_inserter(names), &ClauseText::name);
    return names;
}

std::vector<std::string> clause_remedies() {
    std::vector<std::string> remedies;
    std::ranges::transform(clause_texts, std::back_inserter(remedies), &ClauseText::remedy);
    return remedies;
}

std::int64_t failed_clauses(std::span<Clause const> clauses) {
    std::int64_t bits = 0;
    for (auto const& clause : clauses) {
        auto const* const found = std::find_if(clause_texts.begin(), clause_texts.end(), [&](ClauseText const& text) {
            return clause.name.starts_with(text.name);
        });
        if (!clause.passed() && found != clause_texts.end()) {
            bits |= std::int64_t{1} << (found - clause_texts.begin());
        }
    }
    return bits;
}

std::vector<Clause> spectrum_clauses(AcceptanceRule const& rule, MatchFacts const& facts) {
    std::vector<Clause> clauses;
    auto const& f = facts.figures;
    clauses.push_back(at_least(2, facts.judged_to_s, facts.defined_to_s));
    clauses.push_back(at_least(3, f.lowest_ratio, rule.lowest_ratio));
    if (std::isfinite(rule.most_adjacent_below)) {
        clauses.push_back(at_most(4, f.longest_below, rule.most_adjacent_below));
    }
    if (std::isfinite(rule.highest_ratio)) {
        clauses.push_back(at_most(5, f.highest_ratio, rule.highest_ratio));
    }
    if (rule.lowest_intensity_ratio > 0) {
        clauses.push_back(at_least(6, facts.intensity_ratio, rule.lowest_intensity_ratio));
    }
    if (std::isfinite(rule.largest_cov)) {
        clauses.push_back(at_most(7, f.cov, rule.largest_cov));
        clauses.push_back(at_most(8, std::abs(f.mean_ratio - 1), rule.largest_mean_error));
    }
    clauses.push_back(at_most(9, facts.worst_decade, largest_band_misfit));
    return clauses;
}

std::vector<Clause> wave_clauses(AcceptanceRule const& rule, WaveFacts const& facts) {
    constexpr double slack = 1e-9;  // 0.01 s as a product of others is still 0.01 s
    constexpr double largest_end_velocity = 1e-6;
    constexpr double largest_correlation = 0.16;
    std::vector<Clause> clauses;
    if (std::isfinite(rule.largest_time_step_s)) {
        clauses.push_back(at_most(0, facts.time_step_s, rule.largest_time_step_s * (1 + slack)));
        clauses.push_back(at_least(1, facts.duration_s, rule.shortest_duration_s * (1 - slack)));
    }
    clauses.push_back(at_most(10, facts.end_velocity_ratio, largest_end_velocity));
    clauses.push_back(at_most(11, facts.correlation, largest_correlation));
    return clauses;
}

Clause band_clause(std::string const& body, double mean_misfit) {
    auto clause = at_most(12, mean_misfit, largest_band_misfit);
    clause.name += " [T0, T1] of " + body;
    return clause;
}

bool all_passed(std::span<Clause const> clauses) {
    return std::all_of(clauses.begin(), clauses.end(), [](Clause const& clause) { return clause.passed(); });
}

void expect_judgeable(config::Table const& waves, char const* key, TargetSpectrum const& target) {
    constexpr double rule_damping = 0.05;
    constexpr double stated_from_s = 0.1;
    if (target.is_energy() || target.damping() != rule_damping) {
        waves.fail(key,
                   "beside acceptance, which speaks of response spectra at 5 % damping (the target is another). Use "
                   "acceptance = 'none'");
    }
    if (target.first_period_s() > stated_from_s) {
        waves.fail(key,
                   fmt::format("beside acceptance, which speaks of periods from {} s (the target begins at {:g} s). "
                               "State the target from there on",
                               stated_from_s, target.first_period_s()));
    }
}

}  // namespace overturn
