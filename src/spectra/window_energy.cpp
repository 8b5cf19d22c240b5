#include "spectra/window_energy.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "core/error.hpp"
#include "core/units.hpp"
#include "spectra/band_rule.hpp"
#include "spectra/detail/fourier.hpp"
#include "spectra/detail/window_kernel.hpp"
#include "spectra/detail/window_sweep.hpp"

namespace overturn {
namespace {

std::size_t samples_of(double time_s, double time_step_s) {
    return static_cast<std::size_t>(std::max(1.0, std::round(time_s / time_step_s)));
}

// ouV_E of waves of one length.
class WholeWave {
  public:
    WholeWave(std::size_t samples, double time_step_s, PeriodBand const& band, double panel_phase_rad)
        : rule_(band_rule(band, time_step_s * static_cast<double>(samples), panel_phase_rad)),
          integrals_(samples, time_step_s, rule_.frequency_radps) {}

    [[nodiscard]] double velocity_mps(std::span<double const> acceleration_mps2) const {
        auto const amplitudes = integrals_.of(acceleration_mps2);
        double sum = 0;
        for (std::size_t i = 0; i < amplitudes.size(); ++i) {
            sum += rule_.weight[i] * std::norm(amplitudes[i]);
        }
        return std::sqrt(std::max(0.0, sum));
    }

  private:
    BandRule rule_;
    FourierIntegrals integrals_;
};

// Measures waves of one length.
struct Kind {
    std::size_t samples;
    double time_step_s, t0_s, t1_s, panel_phase_rad;
    WindowReading reading;

    [[nodiscard]] auto parts() const { return std::tie(samples, time_step_s, t0_s, t1_s, panel_phase_rad, reading); }
    friend bool operator<(Kind const& a, Kind const& b) { return a.parts() < b.parts(); }
};

class Meter {
  public:
    explicit Meter(Kind const& kind)
        : kind_(kind),
          window_(samples_of(kind.t1_s, kind.time_step_s)),
          mean_(samples_of(kind.t0_s, kind.time_step_s)),
          whole_(kind.samples, kind.time_step_s, band(), kind.panel_phase_rad),
          rule_(band_rule(band(), resolved_s(), kind.panel_phase_rad)) {
        if (kind.reading == WindowReading::restarted) {
            kernel_.emplace(followed(), kind.time_step_s, window_, rule_);
        }
    }

    [[nodiscard]] double whole(std::span<double const> acceleration_mps2) const {
        return whole_.velocity_mps(acceleration_mps2);
    }

    /// V_WES at every sample and on until window and mean have left the wave: a body swings on after the last sample.
    [[nodiscard]] std::vector<double> history(std::span<double const> acceleration_mps2, bool smoothed) const {
        std::vector<double> samples;
        samples.reserve(followed());
        samples.assign(acceleration_mps2.begin(), acceleration_mps2.end());
        samples.resize(followed(), 0.0);
        auto history = kernel_ ? kernel_->squares(std::move(samples))
                               : swept_window_squares(samples, kind_.time_step_s, window_, rule_, kind_.reading);
        for (double& value : history) {
            value = std::sqrt(std::max(0.0, value));
        }
        return smoothed ? trailing_mean(history, mean_) : history;
    }

  private:
    [[nodiscard]] PeriodBand band() const { return {kind_.t0_s, kind_.t1_s}; }
    [[nodiscard]] std::size_t followed() const { return kind_.samples + window_ + mean_; }
    [[nodiscard]] double resolved_s() const {
        bool const running = kind_.reading == WindowReading::running;
        return static_cast<double>(running ? followed() : window_) * kind_.time_step_s;
    }

    Kind kind_;
    std::size_t window_, mean_;
    WholeWave whole_;
    BandRule rule_;
    std::optional<WindowKernel> kernel_;
};

// Waves of a campaign are of one kind per body, and share what is prepared for it.
Meter const& meter_for(Kind const& kind) {
    validate_band({kind.t0_s, kind.t1_s}, kind.panel_phase_rad);  // a key that is not a number would fit any
    thread_local std::map<Kind, Meter> known;
    // Few of long waves, which take some dozen numbers a sample.
    std::size_t const most = std::clamp<std::size_t>(4'000'000 / (kind.samples + 1), 4, 64);
    if (known.size() >= most && !known.contains(kind)) {
        known.clear();
    }
    return known.try_emplace(kind, kind).first->second;
}

}  // namespace

double overturning_energy_velocity(std::span<double const> acceleration_mps2, double time_step_s,
                                   PeriodBand const& band, double panel_phase_rad) {
    return WholeWave(acceleration_mps2.size(), time_step_s, band, panel_phase_rad).velocity_mps(acceleration_mps2);
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
    auto const& meter = meter_for(
        {acceleration_mps2.size(), time_step_s, band.t0_s, band.t1_s, options.panel_phase_rad, options.reading});
    WindowEnergy energy;
    energy.ou_v_e_mps = meter.whole(acceleration_mps2);
    if (acceleration_mps2.empty()) {
        return energy;
    }
    auto history = meter.history(acceleration_mps2, options.smoothed);
    auto const largest = std::max_element(history.begin(), history.end());
    energy.v_wes_max_mps = *largest;
    energy.v_wes_time_s = time_step_s * static_cast<double>(largest - history.begin());
    if (options.keep_history) {
        energy.v_wes_mps = std::move(history);
    }
    return energy;
}

}  // namespace overturn
