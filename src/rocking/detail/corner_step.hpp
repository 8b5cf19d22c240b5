/// Common part of steps on one corner, stuck or slipping: their end, and the state after them.
#pragma once

#include <algorithm>
#include <cmath>

#include "rocking/detail/impact.hpp"
#include "rocking/detail/resets.hpp"
#include "rocking/detail/rocking_events.hpp"
#include "rocking/detail/rocking_run.hpp"

namespace overturn::rocking {

/// Makes of the state, which stands at the event, what it is after it.
using Reset = void (*)(RockingRun& run);

/// End of a step: at a guard's zero, with the reset that belongs to it, or before any. [s] from its start.
struct Ending {
    double at;
    Reset reset = nullptr;

    /// A guard and its reset: `guard`, an instant in [0, at), becomes the earlier ending; none is below zero.
    void earlier(double guard, Reset r) {
        if (guard >= 0 && guard < at) {
            *this = {guard, r};
        }
    }
    /// \pre the state stands at the ending
    void apply(RockingRun& run) const {
        if (reset != nullptr) {
            reset(run);
        }
    }
    [[nodiscard]] bool is_impact() const { return reset == &apply_impact || reset == &land_and_apply_impact; }
};

/// The rest of the sample, or less where substeps or the last series term ask for it.
template <class Order> [[nodiscard]] double step_length(RockingRun& run, RotationSeries<Order> const& series) {
    auto const& accuracy = run.setup.accuracy;
    auto const& sample = run.sample;
    int const order = series.order;
    double const left = sample.left();
    // So that as many substeps reach the sample's end: a thousand of them, the most that a campaign may ask for, sum up
    // 1e-13 of rounding.
    constexpr double slack = 1e-12;
    double h = accuracy.substeps > 1 ? std::min(left, sample.length_s / accuracy.substeps * (1 + slack)) : left;
    double power = 1;
    for (int k = 0; k < order; ++k) {
        power *= h;
    }
    // The last but one term guards against a last one that vanishes by accident.
    double const size =
        power * std::max(std::abs(series.phi[order]), std::abs(series.phi[order - 1]) * run.corner().p_radps);
    // The size grows as the order-th power of the step; nine tenths leave room for terms that are not yet so.
    if (double const allowed = accuracy.step_tolerance * run.corner().alpha_rad; size > allowed) {
        h *= 0.9 * std::pow(allowed / size, 1.0 / order);
    }
    constexpr double min_step_share = 1e-12;  // of the sample: shorter steps end no trial
    if (!(h > sample.length_s * min_step_share) && left > sample.length_s * min_step_share) {
        run.log.fail(FailureReason::no_convergence);
    }
    return h;
}

/// Guard: |theta| rises to pi/2. Reset: overturn_now.
template <class Order> void find_overturning(RotationSeries<Order> const& series, Ending& ending) {
    auto beyond = series.phi;
    beyond[0] -= overturned_rad;
    if (!ending.is_impact() && evaluate(beyond, ending.at) >= 0) {
        auto const roots = roots_in(beyond, 0.0, ending.at);
        ending = {roots.count > 0 ? roots.at[0] : ending.at, &overturn_now};
    }
}

/// Advances the rotation to the ending, peaks included, and looks at the energy there.
template <class Order> void move(RockingRun& run, RotationSeries<Order> const& series, Ending const& ending) {
    auto& state = run.state;
    double const now = run.sample.now();
    if (state.phi + tail_bound(series.phi, 1, ending.at) > run.log.peak()) {
        for_each_maximum(series.phi, ending.at,
                         [&](double t) { run.log.raise_peak(evaluate(series.phi, t), now + t); });
    }
    state.phi = ending.is_impact() ? 0 : evaluate(series.phi, ending.at);
    state.omega = evaluate(series.velocity(), ending.at);
    run.sample.advance(ending.at, ending.reset != nullptr);
    state.start_root = ending.at > 0 ? StartRoot::none : state.start_root;
    run.log.raise_peak(state.phi, run.sample.now());
    run.log.raise_energy(run.energy());
}

}  // namespace overturn::rocking
