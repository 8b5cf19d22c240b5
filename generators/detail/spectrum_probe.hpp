/// One iteration of a match: the peaks of oscillators at some of the judged periods, and the step on the wave's lines
/// that follows from them.
#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

#include "generators/acceptance.hpp"
#include "generators/detail/line_gains.hpp"
#include "generators/detail/long_period_step.hpp"
#include "generators/detail/noise_lines.hpp"
#include "spectra/peak_response.hpp"

namespace overturn {

/// Periods a match is judged at, and the pseudo-velocity wanted there.
struct JudgedPeriods {
    std::vector<double> period_s;
    std::vector<double> target_mps;

    /// Response over target.
    [[nodiscard]] double ratio(std::size_t i, double displacement_m) const;
    /// `values` of some of the periods.
    [[nodiscard]] std::vector<double> at(std::span<std::size_t const> chosen) const;
};

class SpectrumProbe {
  public:
    /// \param chosen of them, rising, first and last included
    SpectrumProbe(JudgedPeriods judged, std::vector<std::size_t> chosen, double damping, NoiseLines const& noise);

    [[nodiscard]] std::vector<PeakDisplacement> peaks(std::span<double const> acceleration_mps2) const {
        return sweep_.peaks(acceleration_mps2);
    }

    /// Response over target at all judged periods, between the chosen ones on straight lines.
    [[nodiscard]] std::vector<double> ratios(std::span<PeakDisplacement const> peaks) const;

    /// Steps the lines towards the rule's aim. \param ratios at all judged periods, a chosen one answers for those
    /// beside it \param envelope the wave's, per sample
    void step(Lines& lines, std::span<PeakDisplacement const> peaks, std::span<double const> ratios,
              std::span<double const> envelope, AcceptanceRule const& rule, LineGains::Trust trust) const;
    /// The same, for slow oscillators by LongPeriodStep, and for the others by amplitudes.
    void step_slow(Lines& lines, std::span<PeakDisplacement const> peaks, std::span<double const> ratios,
                   std::span<double const> envelope, AcceptanceRule const& rule, NoiseLines const& noise) const;

  private:
    [[nodiscard]] std::vector<double> wanted(std::span<double const> ratios, AcceptanceRule const& rule) const;
    [[nodiscard]] std::vector<double> strength(std::span<PeakDisplacement const> peaks,
                                               std::span<double const> envelope) const;
    [[nodiscard]] double governing_ratio(std::span<double const> ratios, std::size_t c,
                                         AcceptanceRule const& rule) const;

    JudgedPeriods judged_;
    std::vector<std::size_t> chosen_;
    double time_step_s_;
    PeakResponse sweep_;
    LineGains gains_;
    LongPeriodStep slow_;
};

}  // namespace overturn
