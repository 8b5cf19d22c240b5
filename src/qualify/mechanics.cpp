#include <cmath>
#include <vector>

#include "body/rigid_body.hpp"
#include "body/similarity.hpp"
#include "core/boundary.hpp"
#include "model/trial.hpp"
#include "qualify/known_answers.hpp"
#include "rocking/closed_forms.hpp"
#include "rocking/planar_rocking.hpp"

namespace overturn::qualify {
namespace {

constexpr double located = 1e-9;  // relative error of an event that is bisected or located on a series

BodyInput rectangle(double half_width_m, double half_height_m) {
    constexpr double mass = 1000;
    return {.mass_kg = mass,
            .half_width_m = half_width_m,
            .centre_height_m = half_height_m,
            .inertia_kgm2 = mass * (half_width_m * half_width_m + half_height_m * half_height_m) / 3};
}

// Instants of the impacts of a block that is let go.
struct ImpactTimes : RockingObserver {
    void at(RockingInstant const& instant) override {
        if (instant.rotation_rad == 0 && (times.empty() || instant.time_s > times.back())) {
            times.push_back(instant.time_s);
        }
    }
    std::vector<double> times;
};

std::vector<double> impact_times(RockingBlock const& block, double phi0, Restoring restoring) {
    std::vector<double> const calm(3000, 0.0);
    ImpactTimes impacts;
    (void)simulate_rocking(block, {.horizontal_mps2 = calm, .time_step_s = 0.01}, {.restoring = restoring},
                           {.rotation_rad = phi0 * block.alpha_rad}, &impacts);
    return impacts.times;
}

Checks of_the_body() {
    RigidBody const prototype(
        {.mass_kg = 138e3, .half_width_m = 1.7, .centre_height_m = 2.61, .inertia_kgm2 = 4e5, .restitution = 0.8});
    RigidBody const model(
        {.mass_kg = 12.6e3, .half_width_m = 0.68, .centre_height_m = 1.045, .inertia_kgm2 = 6e3, .restitution = 0.8});
    RigidBody const block(rectangle(0.2, 0.8));
    double const sine = std::sin(block.alpha_rad());
    return {{"M-01", "limit velocity V_Ereq of the prototype cask", "PATRAM 2013", "m/s",
             prototype.limit_velocity_mps(), 3.15, 0.005},
            {"M-02", "limit velocity V_Ereq of its 2/5 model, type A", "PATRAM 2013", "m/s", model.limit_velocity_mps(),
             1.99, 0.005},
            relative("M-03", "frequency parameter of a uniform rectangle is sqrt(3 g / 4 R)", "Housner (1963)", "rad/s",
                     block.p_radps(), std::sqrt(3 * g0 / (4 * block.radius_m())), 1e-14),
            relative("M-04", "restitution of a uniform rectangle is 1 - 3/2 sin^2(alpha)", "Housner (1963)", "1",
                     block.housner_restitution(), 1 - 1.5 * sine * sine, 1e-14),
            {"M-05", "mass of the 2/5 model over the prototype's", "PATRAM 2013, table 1", "1", SimilarityLaw{}.mass(),
             0.091, 0.0006}};
}

Checks of_free_rocking() {
    RockingBlock const block{.alpha_rad = 0.25, .p_radps = 1.5, .restitution = 0.9};
    constexpr double phi0 = 0.5;
    auto const linear = impact_times(block, phi0, Restoring::linear);
    auto const nonlinear = impact_times(block, phi0, Restoring::nonlinear);
    constexpr int impacts = 5;
    double const half_period = free_rocking_period(free_rocking_amplitude(phi0, block.restitution, impacts)) / 2;
    return {relative("M-06", "period of free rocking, times p", "Housner (1963), eq. 5", "1",
                     4 * block.p_radps * linear.at(0), free_rocking_period(phi0), located),
            relative("M-07", "half period after five impacts, times p", "Housner (1963), eq. 8", "1",
                     block.p_radps * (linear.at(impacts) - linear.at(impacts - 1)), half_period, located),
            relative("M-08", "period of the nonlinear block, alpha = 0.25, times p", "elliptic integral", "1",
                     4 * block.p_radps * nonlinear.at(0), 5.277503, 2e-7)};
}

Checks of_thresholds() {
    RockingBlock const block{.alpha_rad = 0.25, .p_radps = 2, .restitution = 0.5};  // soon at rest again
    std::vector<double> const constant(3, 1.0);
    auto const lifts = [&](double g_units) {
        auto const end = simulate_rocking(
            block, {.horizontal_mps2 = constant, .time_step_s = 1e-3, .scale = g_units * block.gravity_mps2});
        return end.verdict != Verdict::at_rest;
    };
    // A pulse of twice g alpha, this long.
    auto const falls = [&](double p_times_duration) {
        constexpr double ratio = 2;
        auto const end = simulate_rocking(block,
                                          {.horizontal_mps2 = constant,
                                           .time_step_s = 0.5 * p_times_duration / block.p_radps,
                                           .scale = ratio * block.gravity_mps2 * block.alpha_rad},
                                          {.restoring = Restoring::linear});
        return end.verdict == Verdict::overturned;
    };
    auto slippery = block;
    auto const slides = [&](double g_units) {
        slippery.friction_static = slippery.friction_kinetic = 0.2;
        auto const end = simulate_rocking(
            slippery, {.horizontal_mps2 = constant, .time_step_s = 1e-3, .scale = g_units * block.gravity_mps2}, {}, {},
            nullptr, Slip::simulated);
        return end.verdict != Verdict::at_rest;
    };
    // It may tip at 0.5 g but static friction cannot hold the corner, and kinetic friction cannot tip it: it slides.
    RockingBlock const sliding{.alpha_rad = std::atan(0.5),
                               .p_radps = 2,
                               .restitution = 0.5,
                               .friction_static = 0.55,
                               .friction_kinetic = 0.45};
    std::vector<double> const pulse(11, g0);
    auto const slid =
        simulate_rocking(sliding, {.horizontal_mps2 = pulse, .time_step_s = 0.01}, {}, {}, nullptr, Slip::simulated);
    return {relative("M-09", "uplift begins at tan(alpha)", "statics", "g", boundary(0.1, 1, lifts), std::tan(0.25),
                     located),
            relative("M-10", "longest pulse of 2 g alpha that does not overturn, times p", "Housner (1963), eq. 10",
                     "1", boundary(0.1, 2, falls), rectangular_pulse_limit(2), 1e-7),
            relative("M-11", "sliding begins at the static friction", "Coulomb", "g", boundary(0.1, 0.24, slides), 0.2,
                     located),
            relative("M-12", "slip under a pulse of 1 g over 0.1 s, kinetic friction 0.45", "Newmark (1965)", "m",
                     slid.peak_slip_m, 0.5 * (1 - 0.45) * g0 * 0.01 / 0.45, 1e-12)};
}

// 40 s that rock and slide a stocky block.
std::vector<double> rough_wave() {
    constexpr std::size_t samples = 4001;
    std::vector<double> wave(samples);
    for (std::size_t i = 0; i < samples; ++i) {
        double const t = 0.01 * static_cast<double>(i);
        wave[i] = 6 * std::sin(0.5 * t) * std::sin(pi * t / 40) * std::cos(2 * pi * 0.4 * t + 0.2 * t * t / 40);
    }
    return wave;
}

Checks of_laws() {
    auto const wave = rough_wave();
    RockingBlock const block{.alpha_rad = std::atan(0.45),
                             .p_radps = 2.5,
                             .restitution = 0.85,
                             .friction_static = 0.5,
                             .friction_kinetic = 0.47};
    Excitation const shaking{.horizontal_mps2 = wave, .time_step_s = 0.01};
    auto const end = simulate_rocking(block, shaking, {}, {}, nullptr, Slip::simulated);
    auto const& energy = end.energy;

    auto mirrored = wave;
    for (auto& a : mirrored) {
        a = -a;
    }
    auto const other =
        simulate_rocking(block, {.horizontal_mps2 = mirrored, .time_step_s = 0.01}, {}, {}, nullptr, Slip::simulated);
    bool const same = other.peak_rotation_rad == end.peak_rotation_rad && other.peak_slip_m == end.peak_slip_m
                      && other.verdict == end.verdict;

    constexpr int levels = 64;
    std::vector<RockingTrial> trials;
    for (int i = 0; i < levels; ++i) {
        auto one = shaking;
        one.scale = 0.3 + 0.02 * i;
        trials.push_back({block, one});
    }
    std::vector<RockingOutcome> together(trials.size());
    simulate_rocking(trials, {}, Slip::ignored, together);
    int other_bits = 0;
    for (std::size_t i = 0; i < trials.size(); ++i) {
        auto const alone = simulate_rocking(trials[i].block, trials[i].shaking);
        other_bits +=
            alone.peak_rotation_rad != together[i].peak_rotation_rad || alone.steps != together[i].steps ? 1 : 0;
    }
    Check balance{"M-13",
                  "work of the ground = energy kept + lost in impacts + in friction",
                  "conservation of energy",
                  "J/kg",
                  energy.input,
                  energy.mechanical + energy.impact_loss + energy.friction_work,
                  0};
    balance.tolerance = 1e-9 * (std::abs(energy.impact_loss) + std::abs(energy.friction_work));
    balance.remark = end.impacts > 0 && end.peak_slip_m > 0 ? "" : "the trial neither rocks nor slides";
    return {balance,
            {"M-14", "a mirrored wave moves it in mirror, bit by bit", "symmetry", "trials that differ",
             same ? 0.0 : 1.0, 0, 0},
            {"M-15", "64 trials side by side in vector lanes give the bits of each alone", "determinism",
             "trials that differ", static_cast<double>(other_bits), 0, 0}};
}

}  // namespace

Checks mechanics() {
    Checks all;
    for (auto const& part : {of_the_body(), of_free_rocking(), of_thresholds(), of_laws()}) {
        all.insert(all.end(), part.begin(), part.end());
    }
    return all;
}

}  // namespace overturn::qualify
