/// Draws a component of an artificial wave and brings its response spectrum to a target.
#pragma once

#include <complex>
#include <cstdint>
#include <vector>

#include "generators/envelope.hpp"
#include "generators/real_fft.hpp"
#include "generators/wave_source.hpp"
#include "spectra/target_spectrum.hpp"

namespace overturn {

/// fixed: every line of the first draw has its mean-square amplitude (Shinozuka and Deodatis 1991); gaussian:
/// amplitudes scatter as those of Gaussian noise do.
enum class LineAmplitudes { fixed, gaussian };

struct SpectrumMatcherInput {
    TargetSpectrum target;
    double longest_s = 10;  ///< longest period of interest [s]
    double time_step_s = 0.01;
    std::size_t samples = 0;
    Envelope envelope;
    LineAmplitudes amplitudes = LineAmplitudes::fixed;
    double tolerance = 0.05;  ///< stop once both mean misfits are this small
    int iterations = 100;     ///< at most; 0 leaves the first draw as it is
};

/// a(t) = envelope(t) sum_k A_k cos(w_k t + phi_k) - baseline. Iteration multiplies A_k by target/computed psa at the
/// period of the line; phases stay as drawn. The best iterate is kept, by the larger of the two mean misfits. Lines
/// fade out between the longest period and 1.5 times it, so displacement stays below about 1.7 times the target's sd
/// there. Iteration lowers the level part, where the peaks are, more than what follows: against the envelope the mean
/// power of matched waves is up to 1.4 times too large at the end of the decay (amplitude 1.18); unmatched waves hold
/// it to 1 %.
class SpectrumMatcher {
  public:
    struct Component {
        std::vector<double> acceleration_mps2;
        MatchReport match;
    };

    explicit SpectrumMatcher(SpectrumMatcherInput input);

    /// \param component which stream of the wave: 0 horizontal, 1 vertical.
    [[nodiscard]] Component make(std::uint64_t seed, std::uint64_t wave, std::uint64_t component) const;

    /// Periods the match is judged at, 75 a decade [s].
    [[nodiscard]] std::vector<double> const& periods_s() const { return periods_s_; }

  private:
    using Lines = std::vector<std::complex<double>>;

    [[nodiscard]] Lines draw(std::uint64_t seed, std::uint64_t wave, std::uint64_t component) const;
    [[nodiscard]] std::vector<double> synthesise(Lines const& lines) const;
    [[nodiscard]] std::vector<double> ratios(std::span<double const> acceleration_mps2) const;
    void adjust(Lines& lines, std::span<double const> ratios) const;

    SpectrumMatcherInput input_;
    RealFft fft_;
    std::vector<double> envelope_;
    std::vector<double> periods_s_;
    std::vector<double> target_mps_;      // pseudo-velocity, or V_E
    std::vector<double> line_amplitude_;  // of the first draw, root mean square times sqrt 2
    std::vector<double> line_place_;      // where a line's period lies among periods_s_, in fractions of a gap
};

/// Figures of computed/target ratios at periods within [from, to].
[[nodiscard]] MatchFigures match_figures(std::span<double const> periods_s, std::span<double const> ratios,
                                         double from_s, double to_s);

}  // namespace overturn
