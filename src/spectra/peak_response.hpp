/// Peak displacements of many oscillators under a wave and behind it, with sign and instant: the values of
/// displacement_spectrum, in half its time at the damping of spectra.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "spectra/detail/oscillator_sweep.hpp"
#include "spectra/oscillator.hpp"

namespace overturn {

struct CloseReading;
struct TileBound;
struct TileGround;

/// The largest displacement of one oscillator.
struct PeakDisplacement {
    double displacement_m = 0;  ///< with its sign [m]
    double time_s = 0;          ///< [s], beyond the last sample where the oscillator swings on
};

/// Runs oscillators of rising period over waves, but reads them closely (at every sample, and between samples as
/// PeakRule asks) only in tiles of samples that may hold the peak, by bounds that no wave escapes. Agrees with
/// displacement_spectrum to rounding.
class PeakResponse {
  public:
    /// \param periods_s rising, none below two time steps \param damping ratio to critical, at most 5: beyond it a step
    /// forgets what went before and the recursions their digits
    PeakResponse(std::vector<double> const& periods_s, double damping, double time_step_s);

    /// One per period; zero for a wave of fewer than two samples.
    [[nodiscard]] std::vector<PeakDisplacement> peaks(std::span<double const> acceleration_mps2) const;

  private:
    using LaneValues = OscillatorGroup::LaneValues;
    // |C|, over a step from (y, v), of the free vibration about the ground's line p: |y''| <= w^2 |C|, so that y strays
    // from the straight line between two samples by dt^2/8 times that.
    struct ChordError {
        double real_a0, real_a1, imaginary_y, imaginary_v, imaginary_a0, imaginary_a1, scale;
        ChordError(double w, double damping, double dt);
    };
    struct Oscillator {
        double w;
        int steps;               // per sample
        OscillatorStep sample;   // over one sample
        OscillatorStep fine;     // over one of `steps` parts of it
        ChordError chord_error;  // of infinite scale in other forms: no bound, or none needed
    };
    struct Group {
        std::size_t first, count;  // of the oscillators
        OscillatorGroup swept;
    };
    struct Searched;  // a wave, a group of oscillators and the tiles that it was swept into

    [[nodiscard]] TileBound bound_of(Group const& group) const;
    [[nodiscard]] LaneValues limits(Group const& group, SweepTiles const& tiles, double peak_mps2) const;
    struct State {
        double y, v;
    };
    [[nodiscard]] State state_before(Searched const& searched, std::size_t lane, std::size_t tile) const;
    void read_to_end(Searched const& searched) const;
    [[nodiscard]] State state_at_end(Searched const& searched, std::size_t lane) const;
    void swing_on(Searched const& searched, std::span<PeakDisplacement> found) const;
    void search_swept(Searched const& searched, TileGround const& ground, std::span<PeakDisplacement> found) const;
    void search(Searched const& searched, LaneValues limit, std::span<PeakDisplacement> found) const;
    void add(Searched const& searched, std::size_t lane, std::size_t tile) const;
    void add_states(Searched const& searched, std::size_t lane, std::size_t tile, CloseReading& reading) const;
    static void add_recursion(Searched const& searched, std::size_t lane, std::size_t tile, CloseReading& reading);
    void read(Searched const& searched, std::span<PeakDisplacement> found) const;
    void look(Searched const& searched, std::size_t at, PeakDisplacement& found) const;
    void look_between(Searched const& searched, Oscillator const& o, State state, std::size_t sample,
                      PeakDisplacement& found) const;

    double damping_, time_step_s_;
    std::vector<Oscillator> oscillators_;
    std::vector<Group> groups_;
};

}  // namespace overturn
