#include "response/detail/out_of_range.hpp"

#include <algorithm>
#include <cmath>

#include "core/units.hpp"
#include "motion/ground_motion.hpp"

namespace overturn {

bool out_of_range(Excitation const& shaking, EffectMask simulated) {
    constexpr double most_mps2 = 1e6 * g0;
    double peak = std::isfinite(shaking.peak_mps2) ? shaking.peak_mps2 : peak_of(shaking.horizontal_mps2);
    if (has(simulated, Effect::vertical)) {
        peak = std::max(peak, peak_of(shaking.vertical_mps2));
    }
    if (has(simulated, Effect::spatial)) {
        peak = std::max(peak, peak_of(shaking.transverse_mps2));
    }
    return !(std::abs(shaking.scale) * peak < most_mps2);
}

}  // namespace overturn
