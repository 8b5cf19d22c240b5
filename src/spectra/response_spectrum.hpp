/// Elastic response spectra: largest displacement, velocity and absolute acceleration of oscillators.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace overturn {

/// One ordinate per period.
struct ResponseSpectrum {
    double damping = 0;            ///< ratio to critical [-]
    std::vector<double> period_s;  ///< [s]
    std::vector<double> sd_m;      ///< largest |y| [m]
    std::vector<double> sv_mps;    ///< largest |y'| [m/s]
    std::vector<double> sa_mps2;   ///< largest |y'' + a|, absolute acceleration [m/s2]
    std::vector<double> psv_mps;   ///< pseudo-velocity w sd [m/s]
    std::vector<double> psa_mps2;  ///< pseudo-acceleration w^2 sd [m/s2]
};

/// Behind the last sample the ground goes to rest within one time step, and what oscillators do from then on is known
/// in closed form: zeros that are appended to a wave change nothing.
enum class AfterEnd {
    vibrates,  ///< counts
    left_out   ///< only what happens up to the last sample counts, as in a match
};

/// When a response is looked at. Peaks are taken at the samples, the usual reading of a record, but never more sparsely
/// than `points_per_period`: below that period each sample interval is cut into equal steps of the same exact
/// recursion, at most 32. A vibration seen k times a period is read too low by at most 1 - cos(pi/k): 4.9 % for the
/// default, which is also what an uncut reading has at a period of ten time steps.
struct PeakRule {
    int points_per_period = 10;
    AfterEnd after_end = AfterEnd::vibrates;
};

/// Steps per sample interval under `rule`.
[[nodiscard]] int steps_per_sample(double period_s, double time_step_s, PeakRule const& rule);

/// Spectrum of a wave that starts at rest; 200 periods of 16384 samples take about 2 ms.
/// \throws InputError if a period, the damping or the time step is not usable.
[[nodiscard]] ResponseSpectrum response_spectrum(std::span<double const> acceleration_mps2, double time_step_s,
                                                 std::span<double const> periods_s, double damping,
                                                 PeakRule const& rule = {});

/// Only the largest |y| [m], for loops that need nothing else; the same bits as ResponseSpectrum::sd_m.
[[nodiscard]] std::vector<double> displacement_spectrum(std::span<double const> acceleration_mps2, double time_step_s,
                                                        std::span<double const> periods_s, double damping,
                                                        PeakRule const& rule = {});

/// `count` periods in equal ratios, both ends included. \throws InputError unless 0 < from < to and count >= 2.
[[nodiscard]] std::vector<double> log_periods(double from_s, double to_s, std::size_t count);

/// Periods in equal ratios [s], at least `per_decade` of them in each decade.
[[nodiscard]] std::vector<double> log_periods_per_decade(double from_s, double to_s, double per_decade);

}  // namespace overturn
