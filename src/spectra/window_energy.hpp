/// Akiyama's overturning measure ouV_E and the window energy spectrum V_WES: the energy a wave offers to a band of
/// periods, as a whole and within its last few seconds.
#pragma once

#include <span>
#include <vector>

#include "spectra/band_rule.hpp"

namespace overturn {

/// restarted: the oscillators are at rest when the window opens, |int over the window a exp(-iwt)|^2.
/// running: they have run since the wave began; what counts is the energy they gain over the window.
enum class WindowReading { restarted, running };

struct WindowOptions {
    WindowReading reading = WindowReading::restarted;
    bool smoothed = true;       ///< trailing mean of V_WES over T0; the time before the wave counts as 0
    bool keep_history = false;  ///< fill WindowEnergy::v_wes_mps
    /// Phase w t that one panel of 16 Gauss points may span [rad]. Error of ouV_E on a 120 s wave: rounding up to 20,
    /// 8e-14 at 25, 9e-12 at 30, 2e-8 at 40; its cost falls in proportion.
    double panel_phase_rad = 20;
};

struct WindowEnergy {
    double ou_v_e_mps = 0;          ///< whole wave, ouV_E^2 = int f V_E0^2 dT, f = 2 (T1-T)/(T1-T0)^2 [m/s]
    double v_wes_max_mps = 0;       ///< largest V_WES, also while the wave leaves the window after its end [m/s]
    double v_wes_time_s = 0;        ///< when it was first reached [s]
    std::vector<double> v_wes_mps;  ///< if requested: at every sample and for T0 + T1 after [m/s]
};

/// The window is T1 rounded to whole samples (at least one), cut at the start of the wave; after the wave the ground is
/// quiet. Integrals over time are
/// exact for acceleration that is linear between samples; integrals over T use Gauss panels in frequency that resolve
/// the length of what is transformed. V_WES is exact to rounding of the strongest part within ten windows: long waves
/// lose no digit. Linear in amplitude. 164 s at 0.01 s take about 1 ms, the first wave of a kind a third more,
/// running 44 ms. \throws InputError unless 0 < T0 < T1 and the time step and panel phase are positive.
[[nodiscard]] WindowEnergy window_energy(std::span<double const> acceleration_mps2, double time_step_s,
                                         PeriodBand const& band, WindowOptions const& options = {});

/// Only ouV_E [m/s].
[[nodiscard]] double overturning_energy_velocity(std::span<double const> acceleration_mps2, double time_step_s,
                                                 PeriodBand const& band, double panel_phase_rad = 20);

/// Mean of the last `count` values at every place, missing ones taken as 0, without drift.
[[nodiscard]] std::vector<double> trailing_mean(std::span<double const> values, std::size_t count);

}  // namespace overturn
