#include "rocking/detail/rest.hpp"

#include <algorithm>
#include <cmath>

#include "model/chunk_extremes.hpp"
#include "rocking/detail/resets.hpp"

namespace overturn::rocking {
namespace {

// Where towards one side less holds it than towards the other.
void skip_lopsided_rest(RockingRun& run) {
    auto const& setup = run.setup;
    auto const& shaking = setup.shaking;
    std::size_t const n = shaking.horizontal_mps2.size();
    double const k = shaking.scale / setup.block.gravity_mps2;
    auto& index = run.progress.sample;
    auto const holds = [&](std::size_t i) {
        double const a = k * shaking.horizontal_mps2[i];
        double const gv = setup.has_vertical() ? 1 + k * shaking.vertical_mps2[i] : 1;
        if (!(gv > 0) || std::abs(a) > gv * setup.tipped_by(a).hold_ratio) {
            return false;
        }
        run.log.watch_forces(run.to_ground(a, gv, 1));
        return true;
    };
    if (index + 1 < n && holds(index)) {
        for (++index; index < n && holds(index);) {
            ++index;
        }
        --index;
    }
}

// Most samples of most waves pass through this loop: whether there is vertical motion is asked once, by a template
// parameter, not at each of them.
template <bool Vertical> void skip_symmetric_rest(RockingRun& run) {
    auto const& shaking = run.setup.shaking;
    std::size_t const n = shaking.horizontal_mps2.size();
    double const k = shaking.scale / run.setup.block.gravity_mps2;
    double const hold = run.corner().hold_ratio;
    std::size_t index = run.progress.sample;
    double most = 0;
    double least = 1;
    // For the strongest and the lightest of one sample or of many: a ratio that holds there holds for all of them.
    auto const holds = [&](double strongest, double lightest) {
        double const a = std::abs(k * strongest);
        double const gv = Vertical ? 1 + k * lightest : 1;
        if (a > gv * hold || !(gv > 0)) {
            return false;
        }
        if (double const ratio = Vertical ? a / gv : a; ratio > most) {
            most = ratio;
        }
        least = std::min(least, gv);
        return true;
    };
    auto const sample_holds = [&](std::size_t i) {
        return holds(shaking.horizontal_mps2[i], Vertical ? shaking.vertical_mps2[i] : 0);
    };
    // Of a chunk with a vertical component strongest over lightest is an upper bound of the ratio, not its maximum:
    // such a chunk is skipped only if it sets no record.
    auto const chunk_holds = [&](ChunkExtremes::Chunk const& chunk) {
        double const lowest = k > 0 ? chunk.lowest : chunk.highest;
        bool const exact =
            !Vertical
            || std::abs(k * chunk.strongest) <= (1 + k * lowest) * std::max(most, run.log.outcome().friction_demand);
        return exact && holds(chunk.strongest, lowest);
    };
    if (index + 1 < n && sample_holds(index)) {
        for (++index; index < n;) {
            auto const* const chunk = shaking.chunks != nullptr ? shaking.chunks->at(index) : nullptr;
            if (chunk != nullptr && chunk_holds(*chunk)) {
                index += ChunkExtremes::samples;
            } else if (sample_holds(index)) {
                ++index;
            } else {
                break;
            }
        }
        --index;
    }
    run.progress.sample = index;
    run.log.raise_demand(most);
    run.log.lower_contact(least);
}

void leave_rest(RockingRun& run, double tau, double acceleration) {
    run.sample.tau_s = tau;
    // Of equal limits both are passed: then it slides, as friction of b / h or less does not tip a sliding base.
    if (run.setup.limited() && run.setup.block.friction_static <= run.setup.tipped_by(acceleration).base_ratio) {
        start_sliding(run, acceleration);
    } else {
        lift(run, acceleration);
    }
}

}  // namespace

void skip_rest(RockingRun& run) {
    if (run.setup.lopsided) {
        skip_lopsided_rest(run);
    } else if (run.setup.has_vertical()) {
        skip_symmetric_rest<true>(run);
    } else {
        skip_symmetric_rest<false>(run);
    }
}

// Guard: |a| > gv hold_ratio; both sides are linear in time, so the instant is exact. Reset: leave_rest.
// Guard: gv <= 0. Reset: lose_contact_at_rest.
void step_at_rest(RockingRun& run) {
    auto& sample = run.sample;
    double const tau = sample.tau_s;
    double const a = sample.horizontal(tau);
    double const gv = sample.vertical(tau);
    auto const here = run.to_ground(a, gv, 1);
    run.log.lower_contact(here.normal);
    run.show(here.friction, here.normal);
    if (!(gv > 0)) {
        lose_contact_at_rest(run);
        return;
    }
    if (std::abs(a) > gv * run.setup.tipped_by(a).hold_ratio) {
        leave_rest(run, tau, a);
        return;
    }
    run.log.watch_forces(here);
    double const end = sample.length_s;
    double const a_end = sample.horizontal(end);
    double const gv_end = sample.vertical(end);
    double const hold_ratio = run.setup.tipped_by(a_end).hold_ratio;
    double const hold_end = gv_end * hold_ratio;
    if (std::abs(a_end) > hold_end) {
        double const sign = a_end < 0 ? -1.0 : 1.0;
        double const below = gv * hold_ratio - sign * a;
        double const above = sign * a_end - hold_end;
        leave_rest(run, std::min(end, tau + (end - tau) * (below / (below + above))), a_end);
        return;
    }
    sample.tau_s = end;
    run.log.watch_forces(run.to_ground(a_end, gv_end, 1));
    if (!(gv_end > 0)) {
        lose_contact_at_rest(run);
    }
}

}  // namespace overturn::rocking
