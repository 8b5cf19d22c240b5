#include <cmath>
#include <string_view>
#include <vector>

#include "core/units.hpp"
#include "qualify/known_answers.hpp"
#include "spectra/band_rule.hpp"
#include "spectra/input_energy.hpp"
#include "spectra/named_targets.hpp"
#include "spectra/period_correlation.hpp"
#include "spectra/response_spectrum.hpp"
#include "spectra/window_energy.hpp"

namespace overturn::qualify {
namespace {

Check triangle_energy() {
    constexpr double half_base = 0.02, peak = 3, w = 49.9;
    std::vector<double> const triangle{0, peak, 0};
    double const found = undamped_energy_velocities(triangle, half_base, std::vector{2 * pi / w}).at(0);
    double const expected = 2 * peak * (1 - std::cos(w * half_base)) / (w * w * half_base);
    return {"S-01",
            "V_E without damping is the Fourier amplitude, of a triangle",
            "Akiyama (1985)",
            "m/s",
            found,
            expected,
            1e-12 * expected};
}

// A constant acceleration sets in at once: the first peak comes after half a damped period.
Check step_response() {
    constexpr double period = 2, damping = 0.05, acceleration = 1;
    constexpr std::size_t steps = 200;
    double const w = 2 * pi / period;
    double const root = std::sqrt(1 - damping * damping);
    std::vector<double> const constant(3 * steps, acceleration);
    double const found = response_spectrum(constant, pi / (w * root) / steps, std::vector{period}, damping).sd_m.at(0);
    double const expected = acceleration / (w * w) * (1 + std::exp(-damping * pi / root));
    return {"S-02", "peak of a damped oscillator under a step", "closed form", "m", found, expected, 1e-12 * expected};
}

// So short a triangle is a velocity step, to damping w dt: all that it feeds in is there before anything is damped.
Check damped_energy() {
    constexpr double period = 1, damping = 0.1, dt = 1e-6;
    std::vector<double> const triangle{0, 2, 0, 0};
    double const found = input_energy_velocities(triangle, dt, std::vector{period}, damping).at(0);
    double const expected = 2 * dt;
    return {"S-03",
            "V_E of a velocity step is the step, whatever the damping",
            "Akiyama (1985)",
            "m/s",
            found,
            expected,
            1e-5 * expected};
}

Checks of_windows() {
    constexpr double step = 1e-5;
    std::vector<double> pulse(2000, 0.0);
    pulse[700] = 1;  // a triangle: a velocity step of 1e-5 m/s
    PeriodBand const band{0.5, 5.0};
    auto const found = window_energy(pulse, step, band, {.smoothed = false});
    auto const paper = rocking_period_band(1.247);
    return {
        {"S-04", "ouV_E of a velocity step is the step", "its definition", "m/s", found.ou_v_e_mps, step, 1e-8 * step},
        {"S-05", "largest V_WES of a velocity step is the step", "its definition", "m/s", found.v_wes_max_mps, step,
         1e-8 * step},
        {"S-06", "T1 of a body of R = 124.7 cm is sqrt(R) / 2", "PATRAM 2013", "s", paper.t1_s, 0.5 * std::sqrt(124.7),
         1e-12}};
}

Check target() {
    double psa = std::nan("");
    for (auto const& entry : named_targets()) {
        if (std::string_view(entry.name) == "mlit-ch1") {
            psa = entry.value({}).psa_mps2(4);
        }
    }
    return {"S-07", "Sa of CH1 at 4 s", "MLIT, Kokujushi 1111 (2016)", "gal", psa / gal_mps2, 256, 1e-9};
}

}  // namespace

Checks spectra() {
    Checks all{triangle_energy(), step_response(), damped_energy()};
    for (auto const& check : of_windows()) {
        all.push_back(check);
    }
    all.push_back(target());
    all.push_back({"S-08", "correlation of ln Sa at 1 s and 2 s", "Baker and Jayaram (2008)", "1",
                   baker_jayaram_2008(1, 2), 0.749021, 1e-6});
    return all;
}

}  // namespace overturn::qualify
