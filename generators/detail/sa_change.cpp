#include "generators/detail/sa_change.hpp"

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "spectra/response_spectrum.hpp"

namespace overturn {

namespace {

constexpr double shortest_compared_s = 0.3;
constexpr double longest_compared_s = 10;

/// [%]
double largest_change(std::vector<double> const& from, double from_step_s, std::vector<double> const& to,
                      double to_step_s) {
    constexpr std::size_t count = 40;
    auto const periods = log_periods(shortest_compared_s, longest_compared_s, count);
    constexpr double damping = 0.05;
    auto const before = displacement_spectrum(from, from_step_s, periods, damping);
    auto const after = displacement_spectrum(to, to_step_s, periods, damping);
    double most = 0;
    for (std::size_t i = 0; i < count; ++i) {
        double const change = before[i] > 0 ? after[i] / before[i] - 1 : 0;
        most = std::abs(change) > std::abs(most) ? change : most;
    }
    constexpr double percent = 100;
    return percent * most;
}

}  // namespace

std::string sa_change_text(GroundMotion const& from, GroundMotion const& to) {
    auto const change = [&](std::vector<double> GroundMotion::*component) {
        return largest_change(from.*component, from.time_step_s, to.*component, to.time_step_s);
    };
    bool const several = !from.transverse_mps2.empty() || !from.vertical_mps2.empty();
    auto text = fmt::format("{} Sa from {} to {} s by {:+.3g} % at most", several ? ";" : ",", shortest_compared_s,
                            longest_compared_s, change(&GroundMotion::horizontal_mps2));
    for (auto const& [name, component] :
         {std::pair{"transverse", &GroundMotion::transverse_mps2}, {"vertical", &GroundMotion::vertical_mps2}}) {
        if (!(from.*component).empty()) {
            text += fmt::format(", {} by {:+.3g} %", name, change(component));
        }
    }
    return text;
}

}  // namespace overturn
