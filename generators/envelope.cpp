#include "generators/envelope.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace overturn {

std::span<config::Entry<EnvelopeShape> const> envelope_shapes() {
    static constexpr std::array entries{
        config::Entry<EnvelopeShape>{"jennings", "parabolic rise, level part, exponential decay",
                                     EnvelopeShape::jennings},
        config::Entry<EnvelopeShape>{"constant", "stationary from beginning to end", EnvelopeShape::constant},
    };
    return entries;
}

double Envelope::at(double time_s) const {
    if (shape == EnvelopeShape::constant) {
        return 1;
    }
    if (time_s < rise_s) {
        return (time_s / rise_s) * (time_s / rise_s);
    }
    return time_s <= level_end_s ? 1.0 : std::exp(-std::numbers::ln10 * (time_s - level_end_s) / (end_s - level_end_s));
}

std::vector<double> Envelope::samples(double time_step_s, std::size_t count) const {
    std::vector<double> values(count);
    double const duration = time_step_s * static_cast<double>(count - 1);
    double const fade = std::min(1.0, 0.02 * duration);
    for (std::size_t i = 0; i < count; ++i) {
        double const left = time_step_s * static_cast<double>(count - 1 - i);
        values[i] = at(time_step_s * static_cast<double>(i));
        if (left < fade) {
            values[i] *= 0.5 * (1 - std::cos(pi * left / fade));
        }
    }
    return values;
}

Envelope read_envelope(config::Table const& table, double duration_s) {
    auto const time = config::Range{.low = 0, .high = duration_s, .low_open = true};
    Envelope envelope;
    envelope.shape = table.choice("shape", envelope_shapes(), EnvelopeShape::jennings);
    if (envelope.shape == EnvelopeShape::jennings) {
        envelope.rise_s = table.number("rise", Dimension::time, time, 0.1 * duration_s);
        envelope.level_end_s = table.number("level_end", Dimension::time, time, 0.5 * duration_s);
        envelope.end_s = table.number("end", Dimension::time, time, 0.9 * duration_s);
        if (!(envelope.rise_s <= envelope.level_end_s && envelope.level_end_s < envelope.end_s)) {
            table.fail({}, fmt::format("rise {} s, level_end {} s, end {} s (must follow each other). Mend the order",
                                       envelope.rise_s, envelope.level_end_s, envelope.end_s));
        }
    }
    table.finish();
    return envelope;
}

}  // namespace overturn
