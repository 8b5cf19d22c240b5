/// How the strength of an artificial wave grows and fades.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "config/table.hpp"

namespace overturn {

enum class EnvelopeShape { jennings, constant };

/// The shapes under the names users write.
[[nodiscard]] std::span<config::Entry<EnvelopeShape> const> envelope_shapes();

/// jennings (Jennings, Housner and Tsai 1968): (t/rise)^2, then 1 to level_end, then exp(-ln 10 (t-level_end)/
/// (end-level_end)), so a tenth at `end`. constant: 1.
struct Envelope {
    EnvelopeShape shape = EnvelopeShape::jennings;
    double rise_s = 0;
    double level_end_s = 0;
    double end_s = 0;

    [[nodiscard]] double at(double time_s) const;

    /// At every sample, faded to 0 over the last second (or 2 % of the wave, if that is shorter) by half a cosine.
    [[nodiscard]] std::vector<double> samples(double time_step_s, std::size_t count) const;
};

/// Reads shape, rise, level_end, end; by default jennings with 10, 50 and 90 % of the duration. Calls finish().
/// \throws InputError unless 0 < rise <= level_end < end <= duration.
[[nodiscard]] Envelope read_envelope(config::Table const& table, double duration_s);

}  // namespace overturn
