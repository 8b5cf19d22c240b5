/// Envelopes of artificial waves: strength over time.
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "config/table.hpp"

namespace overturn {

enum class EnvelopeShape { jennings, saragoni_hart, points, constant, noda };

/// The shapes under the names users write.
[[nodiscard]] std::span<config::Entry<EnvelopeShape> const> envelope_shapes();

/// jennings (Jennings, Housner and Tsai 1968): (t/rise)^2, then 1 to level_end, then exp(-ln 10 (t-level_end)/
/// (end-level_end)), so a tenth at `end`. saragoni-hart (Saragoni and Hart 1974): the mean square goes with
/// t^gamma exp(-alpha t), here by its peak time gamma/alpha: ((t/peak) exp(1 - t/peak))^(gamma/2). points: straight
/// lines through a table, held beyond its ends, as a share of its largest value. constant: 1. noda-2002 (Noda et al.
/// 2002, as Japanese design-basis motions use it): that of jennings with rise = 10^(0.5 M - 2.93), level_end - rise =
/// 10^(0.3 M - 1.0) and end - level_end = 10^(0.17 M + 0.54 log10 X - 0.6) seconds, M the magnitude and X the
/// equivalent hypocentral distance in km. The paper could not be consulted for these coefficients; the first two give
/// the 8.3 s and 28.8 s that are quoted for M 7.7.
struct Envelope {
    EnvelopeShape shape = EnvelopeShape::jennings;
    double rise_s = 0;
    double level_end_s = 0;
    double end_s = 0;
    double peak_s = 0;
    double gamma = 0;
    std::vector<std::pair<double, double>> points{};  ///< time [s], largest value 1

    [[nodiscard]] double at(double time_s) const;

    /// At every sample, faded to 0 over the last second (or 2 % of the wave, if that is shorter) by half a cosine.
    [[nodiscard]] std::vector<double> samples(double time_step_s, std::size_t count) const;
};

/// Keys of an envelope.
extern config::KeyTable const envelope_table;

/// Calls finish(). \throws InputError unless 0 < rise <= level_end < end <= duration, 0 < peak <= duration and gamma >
/// 0, or times rise from 0 or more and values are not negative and not all 0.
[[nodiscard]] Envelope read_envelope(config::Table const& table, double duration_s);

}  // namespace overturn
