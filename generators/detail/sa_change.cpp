#include "generators/detail/sa_change.hpp"

#include <cmath>
#include <cstddef>

#include <fmt/format.h>

#include "spectra/response_spectrum.hpp"

namespace overturn {

std::string sa_change_text(GroundMotion const& from, GroundMotion const& to) {
    constexpr double shortest_s = 0.3;
    constexpr double longest_s = 10;
    constexpr std::size_t count = 40;
    auto const periods = log_periods(shortest_s, longest_s, count);
    constexpr double damping = 0.05;
    auto const before = displacement_spectrum(from.horizontal_mps2, from.time_step_s, periods, damping);
    auto const after = displacement_spectrum(to.horizontal_mps2, to.time_step_s, periods, damping);
    double most = 0;
    for (std::size_t i = 0; i < count; ++i) {
        double const change = before[i] > 0 ? after[i] / before[i] - 1 : 0;
        most = std::abs(change) > std::abs(most) ? change : most;
    }
    constexpr double percent = 100;
    return fmt::format(", Sa from {} to {} s by {:+.3g} % at most", shortest_s, longest_s, percent * most);
}

}  // namespace overturn
