#include "motion/usual_time_step.hpp"

#include <fmt/format.h>

namespace overturn {

std::string unusual_time_step(double step_s) {
    constexpr double longest_s = 0.1;
    constexpr double shortest_s = 5e-5;
    constexpr double nyquist = 0.5;
    if (step_s > longest_s) {
        return fmt::format("time step of {:g} s (nothing above {:.3g} Hz is in it)", step_s, nyquist / step_s);
    }
    return step_s < shortest_s ? fmt::format("time step of {:g} s (no instrument records so)", step_s) : std::string();
}

}  // namespace overturn
