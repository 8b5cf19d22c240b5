/// The noise that spectrum-compatible waves are drawn from: Fourier lines whose power fits a target, under an envelope.
#pragma once

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "generators/detail/high_pass_baseline.hpp"
#include "generators/detail/line_draws.hpp"
#include "generators/detail/real_fft.hpp"
#include "generators/envelope.hpp"
#include "spectra/target_spectrum.hpp"

namespace overturn {

struct NoiseInput {
    TargetSpectrum target;
    double longest_s = 10;  ///< longest period of interest [s]
    double time_step_s = 0.01;
    std::size_t samples = 0;
    Envelope envelope{};
    LineAmplitudes amplitudes = LineAmplitudes::fixed;
    bool refined = false;  ///< refine_density
};

/// Lines k = 1, 2, ... lie at k spacing_radps. They fade out between the longest period and 1.5 times it, so that
/// displacement stays bounded.
class NoiseLines {
  public:
    explicit NoiseLines(NoiseInput const& input);

    /// The first `count` lines of a draw.
    [[nodiscard]] Lines draw(LineStreams const& streams, std::size_t count) const {
        return draw_lines(streams, std::span(amplitude_).first(std::min(count, amplitude_.size())), amplitudes_);
    }
    [[nodiscard]] Lines draw(LineStreams const& streams) const { return draw(streams, amplitude_.size()); }

    /// The lines that pairs of standard normals give, the first pair line 1: distributed as draw's.
    [[nodiscard]] Lines from_normals(std::span<double const> normals) const {
        return lines_of_normals(normals, amplitude_, amplitudes_);
    }
    [[nodiscard]] bool is_gaussian() const { return amplitudes_ == LineAmplitudes::gaussian; }

    /// The wave, envelope and baseline included.
    [[nodiscard]] std::vector<double> synthesise(Lines const& lines, std::span<double const> envelope) const;

    /// The lines of a motion, cut or followed by silence to the length of these; no mean, long periods faded.
    [[nodiscard]] Lines analyse(std::span<double const> acceleration_mps2) const;

    /// sum_n weights_n exp(i w_k t_n) of the lines k below `count`: what a line of amplitude 1 adds to a weighted sum
    /// of the samples that it makes. \pre no more weights than length()
    [[nodiscard]] Lines products(std::span<double const> weights, std::size_t count) const;

    /// Lowest ratio of a wave's power to what its lines' density leads to expect, both averaged over 20 % of frequency
    /// to either side, from 0.3 Hz to 24 Hz; first the ratio, then where [Hz].
    [[nodiscard]] std::pair<double, double> lowest_power(std::span<double const> acceleration_mps2) const;

    /// Divides each line's amplitude by what `divisors` says at its period, between `periods_s` that rise in equal
    /// ratios; beyond them the last one holds.
    void divide(std::span<double const> periods_s, std::span<double const> divisors);

    [[nodiscard]] std::vector<double> const& envelope() const { return envelope_; }
    [[nodiscard]] double time_step_s() const { return time_step_s_; }
    [[nodiscard]] double longest_s() const { return longest_s_; }
    [[nodiscard]] std::size_t length() const { return fft_.length(); }  ///< samples of the unenveloped, periodic wave
    [[nodiscard]] double spacing_radps() const { return spacing_radps_; }
    [[nodiscard]] std::size_t count() const { return amplitude_.size(); }
    [[nodiscard]] std::size_t first() const { return first_; }  ///< the first line that has any power

  private:
    double time_step_s_, longest_s_;
    LineAmplitudes amplitudes_;
    RealFft fft_;
    double spacing_radps_;
    std::vector<double> envelope_;
    HighPassBaseline baseline_;
    double strong_s_ = 0;            // integral of the squared envelope
    std::vector<double> amplitude_;  // root mean square times sqrt 2
    std::size_t first_ = 1;
};

/// Multiplies or divides lines by what `values` says at their periods, as NoiseLines::divide does.
void divide_lines(Lines& lines, double spacing_radps, std::span<double const> periods_s,
                  std::span<double const> divisors);

}  // namespace overturn
