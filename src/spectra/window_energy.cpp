#include "spectra/window_energy.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/units.hpp"
#include "spectra/band_rule.hpp"
#include "spectra/fourier.hpp"
#include "spectra/window_kernel.hpp"
#include "spectra/window_sweep.hpp"

namespace overturn {
namespace {

std::vector<double> window_history(std::span<double const> samples, double time_step_s, std::size_t window,
                                   BandRule const& rule, WindowReading reading) {
    auto history = reading == WindowReading::running ? swept_window_squares(samples, time_step_s, window, rule, reading)
                                                     : window_squares(samples, time_step_s, window, rule);
    for (double& value : history) {
        value = std::sqrt(std::max(0.0, value));
    }
    return history;
}

std::size_t samples_of(double time_s, double time_step_s) {
    return static_cast<std::size_t>(std::max(1.0, std::round(time_s / time_step_s)));
}

}  // namespace

double overturning_energy_velocity(std::span<double const> acceleration_mps2, double time_step_s,
                                   PeriodBand const& band, double panel_phase_rad) {
    double const length = time_step_s * static_cast<double>(acceleration_mps2.size());
    auto const rule = band_rule(band, length, panel_phase_rad);
    auto const amplitudes = fourier_amplitudes(acceleration_mps2, time_step_s, rule.frequency_radps);
    double sum = 0;
    for (std::size_t i = 0; i < amplitudes.size(); ++i) {
        sum += rule.weight[i] * std::norm(amplitudes[i]);
    }
    return std::sqrt(std::max(0.0, sum));
}

std::vector<double> trailing_mean(std::span<double const> values, std::size_t count) {
    OVERTURN_EXPECT(count > 0);
    std::vector<double> tails(count + 1, 0.0);  // sums of the block before, from each place on
    std::vector<double> means(values.size());
    for (std::size_t begin = 0; begin < values.size(); begin += count) {
        double head = 0;
        auto const length = std::min(count, values.size() - begin);
        for (std::size_t j = 0; j < length; ++j) {
            head += values[begin + j];
            means[begin + j] = (head + tails[j + 1]) / static_cast<double>(count);
        }
        for (std::size_t j = length; j-- > 0;) {
            tails[j] = tails[j + 1] + values[begin + j];
        }
    }
    return means;
}

WindowEnergy window_energy(std::span<double const> acceleration_mps2, double time_step_s, PeriodBand const& band,
                           WindowOptions const& options) {
    validate(time_step_s > 0 && std::isfinite(time_step_s), "time step {} s (must be positive and finite). Mend it",
             time_step_s);
    WindowEnergy energy;
    energy.ou_v_e_mps = overturning_energy_velocity(acceleration_mps2, time_step_s, band, options.panel_phase_rad);
    if (acceleration_mps2.empty()) {
        return energy;
    }
    // A body swings on after the last sample: quiet ground follows until window and mean have left the wave.
    auto const window = samples_of(band.t1_s, time_step_s);
    auto const mean = samples_of(band.t0_s, time_step_s);
    std::vector<double> samples(acceleration_mps2.begin(), acceleration_mps2.end());
    samples.resize(samples.size() + window + mean, 0.0);
    bool const whole = options.reading == WindowReading::running;
    auto const resolved = static_cast<double>(whole ? samples.size() : window) * time_step_s;
    auto history = window_history(samples, time_step_s, window, band_rule(band, resolved, options.panel_phase_rad),
                                  options.reading);
    if (options.smoothed) {
        history = trailing_mean(history, mean);
    }
    auto const largest = std::max_element(history.begin(), history.end());
    energy.v_wes_max_mps = *largest;
    energy.v_wes_time_s = time_step_s * static_cast<double>(largest - history.begin());
    if (options.keep_history) {
        energy.v_wes_mps = std::move(history);
    }
    return energy;
}

}  // namespace overturn
