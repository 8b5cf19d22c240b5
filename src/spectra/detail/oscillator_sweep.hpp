/// Sixteen oscillators at a time over a whole wave: for each tile of samples how high each may have swung in it, and
/// the state from which it can be looked at closely.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "simd/lane_values.hpp"
#include "spectra/oscillator.hpp"

namespace overturn {

/// Form in which a group's oscillators are swept. y is the displacement, a the acceleration of the ground.
enum class SweepForm {
    /// The free vibration about the line p which the ground alone would draw, y - p = Re(unit turned C): C turns and
    /// decays, and its imaginary part jumps by the second difference of a. For periods that swing between samples.
    amplitude,
    /// y = unit x: x[n+1] = ahead x[n] + behind x[n-1] + a[n+1] + now a[n] + last a[n-1]. It loses digits where a
    /// sample is a small part of the period.
    samples,
    /// w[n+1] = w[n] + d[n+1], d[n+1] = ahead d[n] + behind w[n-1] + a[n+1], of which x[n+1] = d[n+1] + now w[n]
    /// + last w[n-1]; looked at in every stride-th sample. It keeps its digits.
    strided
};

struct OscillatorGroup {
    using LaneValues = simd::LaneValues<>;

    SweepForm form = SweepForm::samples;
    std::size_t stride = 1;
    LaneValues ahead{}, behind{};       ///< amplitude: cosine and sine, both with the decay, of a step's turn
    LaneValues now{}, last{};           ///< amplitude: real and imaginary part of `turned`
    LaneValues unit{};                  ///< displacement per x, or per |C|
    LaneValues state_a0{}, other_a0{};  ///< the state before sample 1, at rest, over a[0]
    LaneValues state_a1{}, other_a1{};  ///< and over a[1]

    void set(std::size_t lane, double w, double damping, OscillatorStep const& sample, double time_step_s);

  private:
    void set_amplitude(std::size_t lane, double w, double damping, double dt);
    void set_samples(std::size_t lane, OscillatorStep const& c);
    void set_strided(std::size_t lane, double w, double damping, OscillatorStep const& c, double dt);
};

/// Per tile of samples [1 + b samples, ...) and lane: the largest x^2 or |C|^2 in it, and the state before it: x and
/// the x before that; w of the sample before and d; or C, its real and its imaginary part, of the step to its first.
struct SweepTiles {
    static constexpr std::size_t samples = 32;
    static constexpr std::size_t values = 3 * simd::sweep_lanes;

    std::vector<double> value;
    OscillatorGroup::LaneValues highest{};  ///< of the largest

    [[nodiscard]] std::size_t count() const { return value.size() / values; }
    [[nodiscard]] double* at(std::size_t tile) { return value.data() + tile * values; }
    [[nodiscard]] double const* at(std::size_t tile) const { return value.data() + tile * values; }
};

/// \param tiles every value is overwritten
void sweep(OscillatorGroup const& group, std::span<double const> acceleration_mps2, SweepTiles& tiles);

/// The same of two groups that may go side by side, which takes less time than one after the other.
void sweep(std::array<OscillatorGroup const*, 2> groups, std::span<double const> acceleration_mps2,
           std::array<SweepTiles, 2>& tiles);
/// Are they of one form and stride, and is there time to win?
[[nodiscard]] bool go_side_by_side(OscillatorGroup const& one, OscillatorGroup const& other);

}  // namespace overturn
