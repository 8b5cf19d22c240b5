#include "generators/envelope.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace overturn {
namespace {

double on_lines(std::span<std::pair<double, double> const> points, double time_s) {
    auto const after = std::find_if(points.begin(), points.end(), [&](auto const& p) { return p.first > time_s; });
    if (after == points.begin() || after == points.end()) {
        return after == points.begin() ? points.front().second : points.back().second;
    }
    auto const [t0, v0] = *(after - 1);
    auto const [t1, v1] = *after;
    return v0 + (v1 - v0) * (time_s - t0) / (t1 - t0);
}

constexpr config::Keys envelope_keys{
    config::word_key<envelope_shapes>("shape", "envelope of the amplitude over time").otherwise("jennings"),
    config::number_key("rise", Dimension::time, config::Range::positive(), "end of the parabolic rise")
        .otherwise_in_words("1/10 of the duration")
        .only("shape = jennings"),
    config::number_key("level_end", Dimension::time, config::Range::positive(), "end of the level part")
        .otherwise_in_words("1/2 of the duration")
        .only("shape = jennings"),
    config::number_key("end", Dimension::time, config::Range::positive(),
                       "time at which the amplitude has decayed to 1/10")
        .otherwise_in_words("9/10 of the duration")
        .only("shape = jennings"),
    config::number_key("peak", Dimension::time, config::Range::positive(), "time of the largest amplitude")
        .otherwise_in_words("1/5 of the duration")
        .only("shape = saragoni-hart"),
    config::number_key("gamma", Dimension::none, {.low = 0, .high = 100, .low_open = true},
                       "exponent of the rise of the squared amplitude")
        .otherwise(3)
        .only("shape = saragoni-hart"),
    config::number_key("magnitude", Dimension::none, {.low = 4, .high = 9.5}, "magnitude that determines the durations")
        .only("shape = noda-2002"),
    config::number_key("distance", Dimension::length, {.low = 1e3, .high = 1e6}, "equivalent hypocentral distance")
        .only("shape = noda-2002"),
    config::pairs_key("points", Dimension::time, Dimension::none, "pairs [time, amplitude], scaled to a maximum of 1")
        .only("shape = points")};

std::vector<std::pair<double, double>> read_points(config::Table const& table) {
    auto points = table.pairs(envelope_keys["points"]);
    double largest = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (points[i].first < 0 || points[i].second < 0 || (i > 0 && points[i].first <= points[i - 1].first)) {
            table.fail("points",
                       fmt::format("[{}, {}] (times must rise from 0 on, values must not be negative). Mend it",
                                   points[i].first, points[i].second));
        }
        largest = std::max(largest, points[i].second);
    }
    if (largest == 0) {
        table.fail("points", "no value above 0 (the wave would be silent). Add one");
    }
    for (auto& point : points) {
        point.second /= largest;
    }
    return points;
}

void read_noda(config::Table const& table, double duration_s, Envelope& envelope) {
    constexpr double m_per_km = 1000;
    double const magnitude = table.number(envelope_keys["magnitude"]);
    double const distance_km = table.number(envelope_keys["distance"]) / m_per_km;
    envelope.rise_s = std::pow(10, 0.5 * magnitude - 2.93);
    envelope.level_end_s = envelope.rise_s + std::pow(10, 0.3 * magnitude - 1.0);
    envelope.end_s = envelope.level_end_s + std::pow(10, 0.17 * magnitude + 0.54 * std::log10(distance_km) - 0.6);
    if (envelope.end_s > duration_s) {
        table.fail("magnitude", fmt::format("{:g} at {:g} km needs {:.1f} s (longer than the wave of {:g} s). Raise "
                                            "waves.duration",
                                            magnitude, distance_km, envelope.end_s, duration_s));
    }
}

}  // namespace

std::span<config::Entry<EnvelopeShape> const> envelope_shapes() {
    static constexpr std::array entries{
        config::Entry<EnvelopeShape>{"jennings", "parabolic rise, level part, exponential decay",
                                     EnvelopeShape::jennings},
        config::Entry<EnvelopeShape>{"saragoni-hart", "gamma function: power rise, exponential decay",
                                     EnvelopeShape::saragoni_hart},
        config::Entry<EnvelopeShape>{
            "noda-2002", "jennings with durations from magnitude and distance (Noda et al. 2002)", EnvelopeShape::noda},
        config::Entry<EnvelopeShape>{"points", "straight lines through a table", EnvelopeShape::points},
        config::Entry<EnvelopeShape>{"constant", "stationary from beginning to end", EnvelopeShape::constant},
    };
    return entries;
}

double Envelope::at(double time_s) const {
    switch (shape) {
        case EnvelopeShape::constant:
            return 1;
        case EnvelopeShape::saragoni_hart: {
            double const u = std::max(0.0, time_s / peak_s);
            return std::pow(u * std::exp(1 - u), gamma / 2);
        }
        case EnvelopeShape::points:
            return on_lines(points, time_s);
        case EnvelopeShape::jennings:
        case EnvelopeShape::noda:
            break;
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

constinit config::KeyTable const envelope_table{.meaning = "envelope of the amplitude of noise over time",
                                                .keys = envelope_keys.all};

Envelope read_envelope(config::Table const& table, double duration_s) {
    auto const within = [&](double share) {
        return config::Given{.otherwise = share * duration_s,
                             .range = config::Range{.low = 0, .high = duration_s, .low_open = true}};
    };
    Envelope envelope;
    envelope.shape = table.choice(envelope_keys["shape"], envelope_shapes());
    if (envelope.shape == EnvelopeShape::jennings) {
        envelope.rise_s = table.number(envelope_keys["rise"], within(0.1));
        envelope.level_end_s = table.number(envelope_keys["level_end"], within(0.5));
        envelope.end_s = table.number(envelope_keys["end"], within(0.9));
        if (!(envelope.rise_s <= envelope.level_end_s && envelope.level_end_s < envelope.end_s)) {
            table.fail({}, fmt::format("rise {} s, level_end {} s, end {} s (must follow each other). Mend the order",
                                       envelope.rise_s, envelope.level_end_s, envelope.end_s));
        }
    } else if (envelope.shape == EnvelopeShape::saragoni_hart) {
        envelope.peak_s = table.number(envelope_keys["peak"], within(0.2));
        envelope.gamma = table.number(envelope_keys["gamma"]);
    } else if (envelope.shape == EnvelopeShape::noda) {
        read_noda(table, duration_s, envelope);
    } else if (envelope.shape == EnvelopeShape::points) {
        envelope.points = read_points(table);
    }
    table.finish();
    return envelope;
}

}  // namespace overturn
