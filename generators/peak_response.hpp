/// Where and how high oscillators swing, quickly: the sweep inside an iteration, not the judge of a finished wave.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "spectra/oscillator.hpp"

namespace overturn {

/// The largest swing of one oscillator.
struct PeakSwing {
    double displacement_m = 0;  ///< with its sign [m]
    double time_s = 0;          ///< [s]
};

/// Runs oscillators of rising period over waves. Long periods see the wave low-passed (half-band filters) and thinned
/// by powers of two, to no fewer than 24 points a period, with the gain that straight lines between thinned samples
/// lose given back and a parabola through each peak. Short ones take one step a sample, and smaller ones only in blocks
/// of samples that may hold the peak. Against displacement_spectrum on matched waves: 0.1 % on the mean, 3 % at most.
class PeakResponse {
  public:
    /// \param periods_s rising \param damping ratio to critical
    PeakResponse(std::vector<double> const& periods_s, double damping, double time_step_s);

    /// One swing per period.
    [[nodiscard]] std::vector<PeakSwing> swings(std::span<double const> acceleration_mps2) const;

  private:
    struct Oscillator {
        OscillatorStep sample;  // over one thinned sample
        OscillatorStep fine;    // over one of `steps` parts of it
        int steps;
        double gain;    // what thinning took, given back
        double margin;  // of y^2: how much lower than the peak itself the samples around it may be
    };
    using LaneValues = std::array<double, 16>;
    // Up to 16 neighbours that share a thinning, and x[n+1] = ahead x[n] + behind x[n-1] + a[n+1] + now a[n] +
    // last a[n-1] for them, y = unit x: OscillatorStep without its velocity. It loses digits where a step is a small
    // part of the period, which thinning keeps it from being.
    struct Group {
        std::size_t first, count;
        std::size_t thinning;  // a power of two, as its exponent
        double sample_s;
        LaneValues ahead, behind, now, last, unit;
    };
    struct Sweep;

    [[nodiscard]] PeakSwing peak(std::span<double const> series, Group const& group, std::size_t lane,
                                 std::vector<double> const& blocks) const;

    std::vector<Oscillator> oscillators_;
    std::vector<Group> groups_;
};

}  // namespace overturn
