#include "motion/drift.hpp"

#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/units.hpp"
#include "motion/intensity.hpp"

namespace overturn {

double Drift::share() const { return pgv_mps > 0 ? std::abs(end_velocity_mps) / pgv_mps : 0; }

bool Drift::excessive() const {
    constexpr double most = 0.05;
    constexpr double farthest_m = 15;  // no instrument has gone further: a mean taken off brings any drift to rest
    return share() > most || pgd_m > farthest_m * factor;
}

std::string Drift::text(MotionUnits const& units) const {
    auto text =
        fmt::format("ends at {:.3g} {} ({:.3g} % of its PGV), {:.3g} {} from where it began",
                    end_velocity_mps / unit_factor(units.velocity, Dimension::velocity), units.velocity, 100 * share(),
                    end_displacement_m / unit_factor(units.length, Dimension::length), units.length);
    for (auto const& other : others) {
        text += fmt::format("; its {} component {}", other.component, other.text(units));
    }
    return text;
}

namespace {

Drift of_component(std::vector<double> const& a, double step_s, double factor) {
    auto const intensity = intensity_of(a, step_s);
    Drift drift{.pgv_mps = intensity.pgv_mps, .pgd_m = intensity.pgd_m, .factor = factor};
    if (!a.empty()) {
        drift.end_velocity_mps = velocity_of(a, step_s).back();
        drift.end_displacement_m = displacement_of(a, step_s).back();
    }
    return drift;
}

}  // namespace

Drift drift_of(GroundMotion const& motion, double factor) {
    auto drift = of_component(motion.horizontal_mps2, motion.time_step_s, factor);
    for (auto const& [name, a] :
         {std::pair("transverse", &motion.transverse_mps2), {"vertical", &motion.vertical_mps2}}) {
        auto other = of_component(*a, motion.time_step_s, factor);
        if (other.excessive()) {
            other.component = name;
            drift.others.push_back(std::move(other));
        }
    }
    return drift;
}

}  // namespace overturn
