#include "results/hand_check.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

#include <fmt/format.h>

#include "campaign/plan.hpp"
#include "campaign/trial.hpp"
#include "spectra/response_spectrum.hpp"
#include "stats/bootstrap.hpp"
#include "stats/quantile.hpp"

namespace overturn {
namespace {

constexpr std::int64_t most_checked_waves = 32;
// Of the demand, as CDFM asks; the highest of waves too few for it.
double fractile_of(std::vector<GroundMotion> const& motions) {
    constexpr double asked = 0.84;
    return std::ssize(motions) < least_waves ? 1 : asked;
}
constexpr std::size_t rotations = 60;

// The first waves, each scaled to a level of 1.
std::vector<GroundMotion> unit_motions(CampaignSpec const& spec) {
    Plan const plan(spec);
    std::vector<GroundMotion> motions;
    PhaseSeconds seconds;
    auto const most = static_cast<std::size_t>(std::min(most_checked_waves, plan.asked()));
    for (std::int64_t wave = 0; wave < plan.waves() && motions.size() < most; ++wave) {
        auto prepared = prepare_wave(spec, plan, wave, seconds);
        auto const scale = prepared.row.failed == 0 && prepared.tried
                               ? spec.levels.scale({1, LevelClass::ordinary}, prepared.row)
                               : std::nullopt;
        if (scale) {
            prepared.motion.scale(*scale);
            motions.push_back(std::move(prepared.motion));
        }
    }
    return motions;
}

// Per unit of the level, the fractile of pseudo-acceleration at every period [m/s2]; of two horizontal components their
// vector, as if both peaked at once.
std::vector<double> demand(std::vector<GroundMotion> const& motions, std::span<double const> periods_s,
                           double damping) {
    std::vector<std::vector<double>> by_period(periods_s.size());
    for (auto const& motion : motions) {
        auto const spectrum = response_spectrum(motion.horizontal_mps2, motion.time_step_s, periods_s, damping);
        auto const across =
            motion.transverse_mps2.empty()
                ? std::vector<double>(periods_s.size())
                : response_spectrum(motion.transverse_mps2, motion.time_step_s, periods_s, damping).psa_mps2;
        for (std::size_t p = 0; p < periods_s.size(); ++p) {
            by_period[p].push_back(std::hypot(spectrum.psa_mps2[p], across[p]));
        }
    }
    std::vector<double> fractiles;
    for (auto& values : by_period) {
        std::ranges::sort(values);
        fractiles.push_back(quantile(values, fractile_of(motions)));
    }
    return fractiles;
}

void check_rocking(HandCheck& check, RigidBody const& body, std::vector<GroundMotion> const& motions) {
    std::vector<RockingCapacity> capacities;
    std::vector<double> periods;
    for (std::size_t i = 1; i <= rotations; ++i) {
        double const share = static_cast<double>(i) / static_cast<double>(rotations);
        capacities.push_back(rocking_capacity(body, share * body.alpha_rad()));
        periods.push_back(1 / capacities.back().frequency_hz);
    }
    constexpr double most_damping = 0.99;  // of an oscillator that still oscillates
    auto const asked = demand(motions, periods, std::min(most_damping, capacities.front().damping));
    for (std::size_t i = 0; i < rotations; ++i) {
        if (double const level = capacities[i].spectral_mps2 / asked[i]; level > check.overturning_level) {
            check.overturning_level = level;
            check.rocking = capacities[i];
        }
    }
}

void check_sliding(HandCheck& check, double friction, double level, std::vector<GroundMotion> const& motions) {
    constexpr double shortest_s = 0.05;
    constexpr double longest_s = 20;
    constexpr std::size_t count = 120;
    auto const periods = log_periods(shortest_s, longest_s, count);
    auto const asked = demand(motions, periods, sliding_damping);
    std::vector<double> peaks;
    peaks.reserve(motions.size());
    for (auto const& motion : motions) {
        peaks.push_back(level * peak_of(motion.vertical_mps2));
    }
    std::ranges::sort(peaks);
    double const capacity = sliding_capacity_mps2(friction, quantile(peaks, fractile_of(motions)));
    check.sliding_m = capacity > 0 ? 0 : std::numeric_limits<double>::infinity();
    for (std::size_t p = periods.size(); p-- > 0 && capacity > 0;) {
        if (level * asked[p] >= capacity) {
            check.sliding_frequency_hz = 1 / periods[p];
            check.sliding_m = sliding_distance_m(capacity, check.sliding_frequency_hz);
            return;
        }
    }
}

}  // namespace

std::vector<HandCheck> hand_checks(CampaignSpec const& spec) {
    std::vector<HandCheck> checks;
    auto const motions = spec.is_grid() ? std::vector<GroundMotion>{} : unit_motions(spec);
    if (motions.empty()) {
        return checks;
    }
    auto const* const basis = spec.levels.design_basis();
    for (auto const& body : spec.bodies) {
        HandCheck check;
        check.body = body.name;
        check.waves = motions.size();
        check.fractile = fractile_of(motions);
        check.left_out = motions.front().vertical_mps2.empty() ? "" : "vertical";
        check_rocking(check, body.body, motions);
        if (body.friction && basis != nullptr) {
            check_sliding(check, body.friction->kinetic_coefficient, basis->value, motions);
        }
        checks.push_back(check);
    }
    return checks;
}

void compare(std::span<HandCheck> checks, Statistics const& statistics, std::span<BodyAnalysis const> analysis) {
    for (auto& check : checks) {
        auto const body = std::ranges::find(analysis, check.body, &BodyAnalysis::body);
        if (body == analysis.end()) {
            continue;
        }
        auto const& stripes = statistics.bodies()[body - analysis.begin()].stripes;
        auto const half = std::ranges::find_if(stripes, [](Stripe const& stripe) {
            return stripe.decided() > 0 && 2 * stripe.overturned >= stripe.decided();
        });
        if (auto const& fit = body->over_levels().fit; fit.identifiable()) {
            check.simulated_median = std::exp(fit.line->log_median());
        } else if (half != stripes.end()) {
            check.simulated_median = half->amplitude;
        }
    }
}

}  // namespace overturn
