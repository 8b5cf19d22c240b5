#include "rocking/planar_rocking.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "rocking/rocking_integrator.hpp"

namespace overturn {
namespace {

template <int Order, class Restoring>
RockingOutcome run(RockingBlock const& block, Shaking const& shaking, RockingAccuracy const& accuracy,
                   RockingStart const& start, RockingObserver* observer) {
    if (shaking.vertical_mps2.empty()) {
        return rocking::Integrator<Order, Restoring, false>(block, shaking, accuracy, observer).run(start);
    }
    return rocking::Integrator<Order, Restoring, true>(block, shaking, accuracy, observer).run(start);
}

template <class Restoring>
RockingOutcome run(RockingBlock const& block, Shaking const& shaking, RockingAccuracy const& accuracy,
                   RockingStart const& start, RockingObserver* observer) {
    switch (accuracy.taylor_order) {
        case 4:
            return run<4, Restoring>(block, shaking, accuracy, start, observer);
        case 6:
            return run<6, Restoring>(block, shaking, accuracy, start, observer);
        case 8:
            return run<8, Restoring>(block, shaking, accuracy, start, observer);
        case 10:
            return run<10, Restoring>(block, shaking, accuracy, start, observer);
        case 12:
            return run<12, Restoring>(block, shaking, accuracy, start, observer);
        case 16:
            return run<16, Restoring>(block, shaking, accuracy, start, observer);
        default:
            break;
    }
    throw InputError(fmt::format("taylor_order {} (not offered). Use 4, 6, 8, 10, 12 or 16", accuracy.taylor_order));
}

}  // namespace

RockingOutcome simulate_rocking(RockingBlock const& block, Shaking const& shaking, RockingAccuracy const& accuracy,
                                RockingStart const& start, RockingObserver* observer) {
    OVERTURN_EXPECT(block.alpha_rad > 0 && block.alpha_rad < 0.5 * pi && block.p_radps > 0);
    OVERTURN_EXPECT(block.restitution >= 0 && block.restitution <= 1);
    OVERTURN_EXPECT(shaking.vertical_mps2.empty() || shaking.vertical_mps2.size() == shaking.horizontal_mps2.size());
    OVERTURN_EXPECT(shaking.horizontal_mps2.size() < 2 || shaking.time_step_s > 0);
    if (accuracy.restoring == Restoring::linear) {
        return run<rocking::LinearRestoring>(block, shaking, accuracy, start, observer);
    }
    return run<rocking::NonlinearRestoring>(block, shaking, accuracy, start, observer);
}

double peak_tipping_ratio(Shaking const& shaking, double gravity_mps2) {
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
