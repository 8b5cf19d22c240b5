#include "rocking/planar_rocking.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/error.hpp"
#include "rocking/detail/rocking_lanes.hpp"
#include "rocking/detail/rocking_run.hpp"
#include "simd/lane_scheduler.hpp"

namespace overturn {
namespace {

void expect_sound([[maybe_unused]] RockingBlock const& block, [[maybe_unused]] Excitation const& shaking,
                  [[maybe_unused]] Slip slip) {
    OVERTURN_EXPECT(block.alpha_rad > 0 && block.alpha_rad < 0.5 * pi && block.p_radps > 0);
    OVERTURN_EXPECT(block.restitution >= 0 && block.restitution <= 1);
    OVERTURN_EXPECT(shaking.vertical_mps2.empty() || shaking.vertical_mps2.size() == shaking.horizontal_mps2.size());
    OVERTURN_EXPECT(shaking.horizontal_mps2.size() < 2 || shaking.time_step_s > 0);
    OVERTURN_EXPECT(slip == Slip::ignored || block.friction_kinetic <= block.friction_static);
}

bool starts_at_rest(RockingStart const& start) { return start.rotation_rad == 0 && start.velocity_radps == 0; }

// A trial that one comparison decides.
bool stays_at_rest(RockingBlock const& block, Excitation const& shaking, RockingAccuracy const& accuracy, Slip slip,
                   RockingOutcome& rest) {
    if (!shaking.vertical_mps2.empty() || block.lopsided) {
        return false;
    }
    double const ratio = std::abs(shaking.scale) / block.gravity_mps2 * shaking.peak_mps2;
    double const tips = accuracy.restoring == Restoring::linear ? block.alpha_rad : std::tan(block.alpha_rad);
    if (!(ratio <= (slip == Slip::ignored ? tips : std::min(tips, block.friction_static)))) {
        return false;
    }
    rest = {};
    rest.friction_demand = ratio;
    return true;
}

}  // namespace

RockingOutcome simulate_rocking(RockingBlock const& block, Excitation const& shaking, RockingAccuracy const& accuracy,
                                RockingStart const& start, RockingObserver* observer, Slip slip) {
    expect_sound(block, shaking, slip);
    RockingOutcome rest;
    if (observer == nullptr && starts_at_rest(start) && stays_at_rest(block, shaking, accuracy, slip, rest)) {
        return rest;
    }
    if (accuracy.restoring == Restoring::linear) {
        validate(!block.lopsided,
                 "differing corners of the linearised block (its energies are those of one). Use restoring = "
                 "\"nonlinear\"");
        validate(slip == Slip::ignored,
                 "slip of the linearised block (its contact forces mean nothing). Use restoring = "
                 "\"nonlinear\"");
    }
    validate(std::ranges::find(taylor_orders, accuracy.taylor_order) != taylor_orders.end(),
             "taylor_order {} (not offered). Use {}", accuracy.taylor_order, fmt::join(taylor_orders, ", "));
    rocking::RockingRun run(block, shaking, accuracy, slip, observer);
    return run_from_start(run, start);
}

namespace {

void side_by_side(std::span<RockingTrial const> trials, RockingAccuracy const& accuracy, Slip slip,
                  std::span<RockingOutcome> outcomes, std::span<rocking::Checkpoint> checkpoints) {
    OVERTURN_EXPECT(outcomes.size() == trials.size());
    bool const in_lanes = rocking::steps_in_lanes(accuracy) && slip != Slip::simulated;
    std::vector<std::size_t> plain;
    std::vector<std::size_t> vertical;
    for (std::size_t i = 0; i < trials.size(); ++i) {
        auto const& [block, shaking, start] = trials[i];
        expect_sound(block, shaking, slip);
        if (!in_lanes) {
            outcomes[i] = simulate_rocking(block, shaking, accuracy, start, nullptr, slip);
        } else if (!starts_at_rest(start) || !stays_at_rest(block, shaking, accuracy, slip, outcomes[i])) {
            (shaking.vertical_mps2.empty() ? plain : vertical).push_back(i);
        }
    }
    for (auto const& queue : {plain, vertical}) {
        rocking::RockingLanes lanes(trials, queue, accuracy, slip, outcomes, checkpoints);
        simd::LaneScheduler(lanes).run();
    }
}

}  // namespace

void simulate_rocking(std::span<RockingTrial const> trials, RockingAccuracy const& accuracy, Slip slip,
                      std::span<RockingOutcome> outcomes) {
    side_by_side(trials, accuracy, slip, outcomes, {});
}

void simulate_until_slip(std::span<RockingTrial const> trials, RockingAccuracy const& accuracy,
                         std::span<RockingOutcome> outcomes, std::span<rocking::Checkpoint> checkpoints) {
    OVERTURN_EXPECT(checkpoints.size() == trials.size());
    side_by_side(trials, accuracy, Slip::detected, outcomes, checkpoints);
}

RockingOutcome resume_sliding(RockingTrial const& trial, RockingAccuracy const& accuracy,
                              rocking::Checkpoint const& checkpoint) {
    OVERTURN_EXPECT(checkpoint.reached);
    rocking::RockingRun run(trial.block, trial.shaking, accuracy, Slip::simulated, nullptr);
    return run_from_checkpoint(run, checkpoint);
}

}  // namespace overturn
