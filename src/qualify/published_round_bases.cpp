#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <fmt/format.h>

#include "core/units.hpp"
#include "qualify/detail/published_parts.hpp"
#include "qualify/detail/type_a.hpp"
#include "spatial/rolling_cylinder.hpp"
#include "spatial/spatial_motion.hpp"

namespace overturn::qualify {
namespace {

SpatialBlock on_its_rim(Pad const& pad, double friction) {
    Footing const footing{.base = {.shape = BaseShape::round, .points = 0}, .pad = pad, .stated = true};
    return spatial_block(type_a(), footing, Friction{friction, friction});
}

struct LastPose : SpatialObserver {
    double tilt_rad = 0, azimuth_rad = 0, turned_rad = 0;
    void at(SpatialInstant const& instant) override {
        double const step_rad = instant.azimuth_rad() - azimuth_rad;
        turned_rad += step_rad > pi ? step_rad - 2 * pi : step_rad < -pi ? step_rad + 2 * pi : step_rad;
        tilt_rad = instant.tilt_rad();
        azimuth_rad = instant.azimuth_rad();
    }
};

Checks rolling() {
    constexpr double no_slip = 100, tilt = 0.2, seconds = 3, sample_s = 0.01;
    auto const block = on_its_rim({.vertical_frequency_hz = 400, .normal_restitution = 1}, no_slip);
    double const precession = rolling_cylinder(block, false).steady_precession_radps(tilt);
    double const spin = RollingCylinder::spin_without_pivoting(tilt, precession);
    std::vector<double> const calm(static_cast<std::size_t>(std::lround(seconds / sample_s)) + 1, 0.0);
    LastPose last;
    (void)simulate_spatial(block, {.horizontal_mps2 = calm, .time_step_s = sample_s},
                           {.longest_after_s = 0, .rest_gate = false}, rolling_start(block, tilt, precession, spin),
                           &last);
    constexpr char const* source = "Srinivasan and Ruina (2008), rigid cylinder";
    auto const remark = fmt::format(
        "{}, from their equations in closed form, without pivoting; the rim here gives way: ten times less of it at "
        "1600 Hz",
        solved_again);
    return {relative("L-28", "tilt of a round body after 3 s of steady rolling on its rim", source, "rad",
                     last.tilt_rad, tilt, 1e-3, remark),
            relative("L-30", "angle by which it precessed meanwhile", source, "rad", last.turned_rad,
                     precession * seconds, 1e-3, remark)};
}

Check azimuth() {
    auto const block = on_its_rim({}, 0.7);
    constexpr double step_s = 0.01, period_s = 0.7, peak_mps2 = 8;
    constexpr std::size_t samples = 200;
    std::vector<double> pulse(samples, 0.0);
    for (std::size_t i = 0; step_s * static_cast<double>(i) < period_s; ++i) {
        pulse[i] = peak_mps2 * std::sin(2 * pi * step_s * static_cast<double>(i) / period_s);
    }
    std::vector<double> tilts;
    for (double const degrees : {0.0, 2.0, 33.0, 77.0, 251.0}) {
        std::vector<double> x(samples);
        std::vector<double> y(samples);
        for (std::size_t i = 0; i < samples; ++i) {
            x[i] = std::cos(degrees * pi / 180) * pulse[i];
            y[i] = std::sin(degrees * pi / 180) * pulse[i];
        }
        auto const out = simulate_spatial(block, {.horizontal_mps2 = x, .transverse_mps2 = y, .time_step_s = step_s},
                                          {}, {}, nullptr);
        tilts.push_back(out.peak_rotation_rad);
    }
    auto const [least, most] = std::ranges::minmax(tilts);
    return {"L-29",
            "largest tilt of a round body under a pulse turned in plan by 2 to 251 degrees: greatest over least",
            "symmetry",
            "1",
            most / least,
            1,
            1e-9,
            "rounding",
            "",
            Basis::law};
}

}  // namespace

Checks published_round_bases() {
    auto all = rolling();
    all.push_back(azimuth());
    return all;
}

}  // namespace overturn::qualify
