#include "results/grid_map.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/error.hpp"
#include "core/field.hpp"
#include "core/units.hpp"
#include "response/registry.hpp"
#include "rocking/closed_forms.hpp"

namespace overturn {
namespace {

void lower_to(std::optional<std::size_t>& least, std::size_t level) { least = std::min(least.value_or(level), level); }

}  // namespace

GridLine::GridLine(std::int64_t wave_number, double wave_period_s, std::size_t levels, std::size_t limits)
    : wave(wave_number), period_s(wave_period_s), ends(levels, Verdict::failed), least(limits) {}

void GridLine::add(TrialRow const& row, LimitOutcomes const& limits) {
    std::size_t const level = row.level;
    auto const& end = entry_of(row.verdict);
    ends.at(level) = row.verdict;
    undecided += end.decided ? 0 : 1;
    if (end.fell || !std::isnan(row.first_uplift_s)) {
        lower_to(uplift, level);
    }
    if (end.decided && !end.fell) {
        standing = std::max(standing.value_or(level), level);
    }
    for (std::size_t limit = 0; limit < least.size(); ++limit) {
        if (limits.has_passed(limit)) {
            lower_to(least[limit], level);
        }
    }
}

double GridMap::value(std::optional<std::size_t> level) const { return level ? levels.at(*level) : never; }

double steady_rotation_ratio(LevelSpec const& levels, double level, double period_s, RigidBody const& body) {
    double const omega = 2 * pi / period_s;
    double amplitude = never;
    if (levels.measure == measure_named("pga")) {
        amplitude = level;
    } else if (levels.measure == measure_named("pgv")) {
        amplitude = level * omega;
    } else if (levels.measure == measure_named("pgd")) {
        amplitude = level * omega * omega;
    }
    if (body.lopsided() || std::isnan(amplitude) || amplitude <= body.uplift_acceleration_mps2()) {
        return never;
    }
    try {
        return steady_harmonic_rotation(
            {omega / body.p_radps(), amplitude / (g0 * body.alpha_rad()), body.restitution()});
    } catch (InputError const&) {
        return never;  // P^2 + 1 < Q^2
    }
}

}  // namespace overturn
