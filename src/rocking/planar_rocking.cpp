#include "rocking/planar_rocking.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "rocking/detail/rocking_integrator.hpp"
#include "rocking/detail/rocking_lanes.hpp"

namespace overturn {
namespace {

struct Arguments {
    RockingBlock const& block;
    Excitation const& shaking;
    RockingAccuracy const& accuracy;
    RockingStart const& start;
    RockingObserver* observer;

    template <int Order, class Restoring, Slip Friction> [[nodiscard]] RockingOutcome run() const {
        if (shaking.vertical_mps2.empty()) {
            return rocking::Integrator<Order, Restoring, false, Friction>(block, shaking, accuracy, observer)
                .run(start);
        }
        return rocking::Integrator<Order, Restoring, true, Friction>(block, shaking, accuracy, observer).run(start);
    }

    template <class Restoring, Slip Friction> [[nodiscard]] RockingOutcome with_order() const {
        RockingOutcome outcome;
        auto const one_of = [&]<std::size_t... i>(std::index_sequence<i...>) {
            return ((accuracy.taylor_order == taylor_orders[i]
                     && (outcome = run<taylor_orders[i], Restoring, Friction>(), true))
                    || ...);
        };
        validate(one_of(std::make_index_sequence<taylor_orders.size()>()), "taylor_order {} (not offered). Use {}",
                 accuracy.taylor_order, fmt::join(taylor_orders, ", "));
        return outcome;
    }
};

}  // namespace

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
    Arguments const call{block, shaking, accuracy, start, observer};
    if (accuracy.restoring == Restoring::linear) {
        validate(!block.lopsided,
                 "differing corners of the linearised block (its energies are those of one). Use restoring = "
                 "\"nonlinear\"");
        validate(slip == Slip::ignored,
                 "slip of the linearised block (its contact forces mean nothing). Use restoring = "
                 "\"nonlinear\"");
        return call.with_order<rocking::LinearRestoring, Slip::ignored>();
    }
    switch (slip) {
        case Slip::ignored:
            return call.with_order<rocking::NonlinearRestoring, Slip::ignored>();
        case Slip::detected:
            return call.with_order<rocking::NonlinearRestoring, Slip::detected>();
        case Slip::simulated:
            break;
    }
    return call.with_order<rocking::NonlinearRestoring, Slip::simulated>();
}

namespace {

void side_by_side(std::span<RockingTrial const> trials, RockingAccuracy const& accuracy, Slip slip,
                  std::span<RockingOutcome> outcomes, std::span<rocking::Checkpoint> checkpoints) {
    OVERTURN_EXPECT(outcomes.size() == trials.size());
    bool const lanes = accuracy.taylor_order == rocking::LaneStep::order && accuracy.substeps == 1
                       && accuracy.restoring == Restoring::nonlinear && slip != Slip::simulated;
    std::vector<std::size_t> plain;
    std::vector<std::size_t> vertical;
    for (std::size_t i = 0; i < trials.size(); ++i) {
        auto const& [block, shaking, start] = trials[i];
        expect_sound(block, shaking, slip);
        if (!lanes) {
            outcomes[i] = simulate_rocking(block, shaking, accuracy, start, nullptr, slip);
        } else if (!starts_at_rest(start) || !stays_at_rest(block, shaking, accuracy, slip, outcomes[i])) {
            (shaking.vertical_mps2.empty() ? plain : vertical).push_back(i);
        }
    }
    if (slip == Slip::ignored) {
        rocking::step_in_lanes<false, Slip::ignored>(trials, plain, accuracy, outcomes, checkpoints);
        rocking::step_in_lanes<true, Slip::ignored>(trials, vertical, accuracy, outcomes, checkpoints);
    } else {
        rocking::step_in_lanes<false, Slip::detected>(trials, plain, accuracy, outcomes, checkpoints);
        rocking::step_in_lanes<true, Slip::detected>(trials, vertical, accuracy, outcomes, checkpoints);
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
    OVERTURN_EXPECT(checkpoint.at_hand);
    auto const go_on = [&]<bool Vertical>() {
        using Trial =
            rocking::Integrator<rocking::LaneStep::order, rocking::NonlinearRestoring, Vertical, Slip::simulated>;
        return Trial(trial.block, trial.shaking, accuracy, nullptr).run_from(checkpoint);
    };
    return trial.shaking.vertical_mps2.empty() ? go_on.template operator()<false>() : go_on.template operator()<true>();
}

double peak_tipping_ratio(Excitation const& shaking, double gravity_mps2) {
    double const k = shaking.scale / gravity_mps2;
    double peak = 0;
    for (std::size_t i = 0; i < shaking.horizontal_mps2.size(); ++i) {
        double const gv = shaking.vertical_mps2.empty() ? 1.0 : 1 + k * shaking.vertical_mps2[i];
        if (!(gv > 0)) {
            return std::numeric_limits<double>::infinity();
        }
        // Between samples a and gv are linear and gv positive, so the ratio is largest at a sample.
        peak = std::max(peak, std::abs(k * shaking.horizontal_mps2[i]) / gv);
    }
    return peak;
}

}  // namespace overturn
