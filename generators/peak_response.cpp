#include "generators/peak_response.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.hpp"
#include "core/units.hpp"
#include "spectra/oscillator.hpp"
#include "spectra/response_spectrum.hpp"
#include "spectra/wide.hpp"

namespace overturn {
namespace {

using LaneValues = std::array<double, wide::lanes>;

// y[n+1] = ahead y[n] + behind y[n-1] + next a[n+1] + now a[n] + last a[n-1]: OscillatorStep without its velocity. It
// loses digits where a step is a small part of the period, which thinning keeps it from being.
struct Recurrence {
    double ahead, behind, next, now, last;

    explicit Recurrence(OscillatorStep const& c)
        : ahead(c.yy + c.vv),
          behind(c.yv * c.vy - c.yy * c.vv),
          next(c.ya1),
          now(c.ya0 - c.vv * c.ya1 + c.yv * c.va1),
          last(c.yv * c.va0 - c.vv * c.ya0) {}
};

constexpr std::size_t block_samples = 64;

struct Lanes {
    LaneValues ahead, behind, next, now, last;
    LaneValues square, block;    // the largest y^2, and the block of samples it lies in
    std::vector<double> states;  // per block: y before it, and one step earlier
};

struct PeakSweep {
    std::span<double const> acceleration;
    int steps;
    Lanes* lanes;

    template <int bytes> OVERTURN_INLINE void run() const {
        using R = wide::Registers<bytes>;
        R ahead, behind, next, now, last, y, before, square, best, at;
        R::load(ahead, lanes->ahead.data());
        R::load(behind, lanes->behind.data());
        R::load(next, lanes->next.data());
        R::load(now, lanes->now.data());
        R::load(last, lanes->last.data());
        for (auto* state : {&y, &before, &best, &at}) {
            R::clear(*state);
        }
        double const part = 1.0 / steps;
        double a0 = 0;
        double a1 = acceleration[0];
        double* states = lanes->states.data();
        double block = 0;
        for (std::size_t n = 1; n < acceleration.size(); block += 1) {
            R::store(states, y);
            R::store(states + wide::lanes, before);
            states += 2 * wide::lanes;
            R::clear(square);
            for (std::size_t const end = std::min(n + block_samples, acceleration.size()); n < end; ++n) {
                double const rise = acceleration[n] - acceleration[n - 1];
                for (int s = 1; s <= steps; ++s) {
                    double const a2 = s == steps ? acceleration[n] : acceleration[n - 1] + rise * (s * part);
#pragma GCC unroll 8
                    for (int r = 0; r < R::count; ++r) {
                        auto const forced = (next.at[r] * a2 + now.at[r] * a1) + last.at[r] * a0;
                        auto const y1 = (ahead.at[r] * y.at[r] + forced) + behind.at[r] * before.at[r];
                        before.at[r] = y.at[r];
                        y.at[r] = y1;
                        auto const y2 = y1 * y1;
                        square.at[r] = y2 > square.at[r] ? y2 : square.at[r];
                    }
                    a0 = a1;
                    a1 = a2;
                }
            }
            typename R::Vector const here = typename R::Vector{} + block;
            for (int r = 0; r < R::count; ++r) {
                auto const higher = square.at[r] > best.at[r];
                best.at[r] = higher ? square.at[r] : best.at[r];
                at.at[r] = higher ? here : at.at[r];
            }
        }
        R::store(lanes->square.data(), best);
        R::store(lanes->block.data(), at);
    }
};

// Runs one lane through the block of its peak again: how high, which side, which step (from 1).
std::pair<double, double> peak_in_block(std::span<double const> acceleration, int steps, Lanes const& lanes,
                                        std::size_t lane) {
    auto const block = static_cast<std::size_t>(lanes.block.at(lane));
    double y = lanes.states[2 * wide::lanes * block + lane];
    double before = lanes.states[2 * wide::lanes * block + wide::lanes + lane];
    std::size_t const first = 1 + block * block_samples;
    double const part = 1.0 / steps;
    double a1 = acceleration[first - 1];
    double a0 = 0;
    if (first > 1) {
        double const rise = acceleration[first - 1] - acceleration[first - 2];
        a0 = steps == 1 ? acceleration[first - 2] : acceleration[first - 2] + rise * ((steps - 1) * part);
    }
    std::pair<double, double> peak{0, 0};
    for (std::size_t n = first; n < std::min(first + block_samples, acceleration.size()); ++n) {
        double const rise = acceleration[n] - acceleration[n - 1];
        for (int s = 1; s <= steps; ++s) {
            double const a2 = s == steps ? acceleration[n] : acceleration[n - 1] + rise * (s * part);
            double const forced = (lanes.next.at(lane) * a2 + lanes.now.at(lane) * a1) + lanes.last.at(lane) * a0;
            double const y1 = (lanes.ahead.at(lane) * y + forced) + lanes.behind.at(lane) * before;
            before = y;
            y = y1;
            if (std::abs(y1) > std::abs(peak.first)) {
                peak = {y1, static_cast<double>((n - 1) * static_cast<std::size_t>(steps)) + s};
            }
            a0 = a1;
            a1 = a2;
        }
    }
    return peak;
}

// Odd taps of a half-band low-pass, sinc under a Hamming window; the even ones are 0, the middle one is 1/2.
constexpr std::size_t odd_taps = 6;
std::array<double, odd_taps> half_band_taps() {
    std::array<double, odd_taps> taps{};
    double sum = 0;
    for (std::size_t m = 0; m < odd_taps; ++m) {
        auto const k = static_cast<double>(2 * m + 1);
        double const window = 0.54 + 0.46 * std::cos(pi * k / (2 * odd_taps));
        taps.at(m) = std::sin(pi * k / 2) / (pi * k) * window;
        sum += 2 * taps.at(m);
    }
    for (double& tap : taps) {
        tap *= 0.5 / sum;
    }
    return taps;
}

// Every second sample of the low-passed series; nothing lies beyond its ends.
std::vector<double> thinned(std::span<double const> series) {
    static std::array<double, odd_taps> const taps = half_band_taps();
    constexpr std::size_t reach = 2 * odd_taps - 1;
    std::vector<double> padded(series.size() + 2 * reach + 1, 0.0);
    std::copy(series.begin(), series.end(), padded.begin() + reach);
    std::vector<double> half(series.size() / 2 + 1);
    for (std::size_t i = 0; i < half.size(); ++i) {
        double const* const middle = padded.data() + reach + 2 * i;
        double sum = 0.5 * *middle;
        for (std::size_t m = 0; m < odd_taps; ++m) {
            auto const k = static_cast<std::ptrdiff_t>(2 * m + 1);
            sum += taps[m] * (middle[-k] + middle[k]);
        }
        half[i] = sum;
    }
    return half;
}

std::size_t thinning_of(double period_s, double time_step_s) {
    constexpr double points_per_period = 32;
    double const room = std::log2(period_s / (points_per_period * time_step_s));
    return room < 1 ? 0 : static_cast<std::size_t>(room);
}

// Straight lines between samples pass a sinusoid with sinc^2.
double straight_line_gain(double step_s, double period_s) {
    double const x = pi * step_s / period_s;
    double const sinc = std::sin(x) / x;
    return sinc * sinc;
}

}  // namespace

PeakResponse::PeakResponse(std::vector<double> periods_s, double damping, double time_step_s)
    : periods_s_(std::move(periods_s)), damping_(damping), time_step_s_(time_step_s) {
    for (std::size_t i = 0; i < periods_s_.size(); ++i) {
        OVERTURN_EXPECT(i == 0 || periods_s_[i] > periods_s_[i - 1]);
        auto const thinning = thinning_of(periods_s_[i], time_step_s);
        auto const steps = steps_per_sample(periods_s_[i], time_step_s, {});
        if (groups_.empty() || groups_.back().count == wide::lanes || groups_.back().thinning != thinning
            || groups_.back().steps != steps) {
            groups_.push_back({i, 0, thinning, steps});
        }
        ++groups_.back().count;
    }
}

std::vector<PeakSwing> PeakResponse::swings(std::span<double const> acceleration_mps2) const {
    std::vector<std::vector<double>> thinner;
    std::vector<PeakSwing> found(periods_s_.size());
    for (auto const& group : groups_) {
        while (thinner.size() < group.thinning) {
            thinner.push_back(thinned(thinner.empty() ? acceleration_mps2 : std::span<double const>(thinner.back())));
        }
        double const sample_s = std::ldexp(time_step_s_, static_cast<int>(group.thinning));
        double const step_s = sample_s / group.steps;
        auto const series =
            group.thinning == 0 ? acceleration_mps2 : std::span<double const>(thinner[group.thinning - 1]);
        Lanes lanes{};
        lanes.states.resize(2 * wide::lanes * (series.size() / block_samples + 1));
        for (std::size_t lane = 0; lane < wide::lanes; ++lane) {
            double const period = periods_s_[group.first + std::min(lane, group.count - 1)];
            Recurrence const c(OscillatorStep(2 * pi / period, damping_, step_s));
            lanes.ahead.at(lane) = c.ahead;
            lanes.behind.at(lane) = c.behind;
            lanes.next.at(lane) = c.next;
            lanes.now.at(lane) = c.now;
            lanes.last.at(lane) = c.last;
        }
        wide::dispatch(PeakSweep{series, group.steps, &lanes});
        for (std::size_t lane = 0; lane < group.count; ++lane) {
            double const period = periods_s_[group.first + lane];
            double const gain = straight_line_gain(time_step_s_, period) / straight_line_gain(sample_s, period);
            auto const [swing, step] = peak_in_block(series, group.steps, lanes, lane);
            found[group.first + lane] = {gain * swing, step_s * step};
        }
    }
    return found;
}

}  // namespace overturn
