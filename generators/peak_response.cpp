#include "generators/peak_response.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/units.hpp"
#include "spectra/response_spectrum.hpp"
#include "spectra/wide.hpp"

namespace overturn {

// Per block of samples: the largest x^2 in it, x before it, and x one sample earlier; 16 of each.
struct PeakResponse::Sweep {
    static constexpr std::size_t block_samples = 32;
    static constexpr std::size_t values_per_block = 3 * wide::lanes;

    std::span<double const> acceleration;
    Group const* group;
    double* blocks;

    template <int bytes> OVERTURN_INLINE void run() const {
        using R = wide::Registers<bytes>;
        R ahead, behind, now, last, x, before, square;
        R::load(ahead, group->ahead.data());
        R::load(behind, group->behind.data());
        R::load(now, group->now.data());
        R::load(last, group->last.data());
        R::clear(x);
        R::clear(before);
        double a0 = 0;
        double a1 = acceleration[0];
        double* block = blocks;
        for (std::size_t n = 1; n < acceleration.size(); block += values_per_block) {
            R::store(block + wide::lanes, x);
            R::store(block + 2 * wide::lanes, before);
            R::clear(square);
            for (std::size_t const end = std::min(n + block_samples, acceleration.size()); n < end; ++n) {
                double const a2 = acceleration[n];
                auto const filled = wide::filled<typename R::Vector>(a2);
#pragma GCC unroll 8
                for (int r = 0; r < R::count; ++r) {
                    auto const forced = wide::fma(now.at[r], a1, wide::fma(last.at[r], a0, filled));
                    auto const next = wide::fma(x.at[r], ahead.at[r], wide::fma(before.at[r], behind.at[r], forced));
                    before.at[r] = x.at[r];
                    x.at[r] = next;
                    square.at[r] = wide::max(next * next, square.at[r]);
                }
                a0 = a1;
                a1 = a2;
            }
            R::store(block, square);
        }
    }
};

namespace {

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
    constexpr double points_per_period = 24;
    double const room = std::log2(period_s / (points_per_period * time_step_s));
    return room < 1 ? 0 : static_cast<std::size_t>(room);
}

// Straight lines between samples pass a sinusoid with sinc^2.
double straight_line_gain(double step_s, double period_s) {
    double const x = pi * step_s / period_s;
    double const sinc = std::sin(x) / x;
    return sinc * sinc;
}

// The extremum of the parabola through three points, the middle one the highest, beyond its own value.
double beyond_middle(double left, double middle, double right) {
    double const curvature = left - 2 * middle + right;
    double const slope = (right - left) / 2;
    return curvature != 0 ? -slope * slope / (2 * curvature) : 0.0;
}

}  // namespace

PeakResponse::PeakResponse(std::vector<double> const& periods_s, double damping, double time_step_s) {
    constexpr double least_margin = 0.6;
    for (std::size_t i = 0; i < periods_s.size(); ++i) {
        double const period = periods_s[i];
        OVERTURN_EXPECT(i == 0 || period > periods_s[i - 1]);
        auto const thinning = thinning_of(period, time_step_s);
        if (groups_.empty() || groups_.back().count == wide::lanes || groups_.back().thinning != thinning) {
            groups_.push_back(
                {i, 0, thinning, std::ldexp(time_step_s, static_cast<int>(thinning)), {}, {}, {}, {}, {}});
        }
        auto& group = groups_.back();
        double const w = 2 * pi / period;
        int const steps = steps_per_sample(period, group.sample_s, {});
        double const turn = std::cos(std::min(pi * group.sample_s / period, pi / 2));
        oscillators_.push_back(
            {.sample = OscillatorStep(w, damping, group.sample_s),
             .fine = OscillatorStep(w, damping, group.sample_s / steps),
             .steps = steps,
             .gain = straight_line_gain(time_step_s, period) / straight_line_gain(group.sample_s, period),
             .margin = std::max(least_margin, turn * turn)});
        auto const& c = oscillators_.back().sample;
        for (std::size_t lane = group.count; lane < wide::lanes; ++lane) {  // idle lanes repeat the last
            group.ahead.at(lane) = c.yy + c.vv;
            group.behind.at(lane) = c.yv * c.vy - c.yy * c.vv;
            group.now.at(lane) = (c.ya0 - c.vv * c.ya1 + c.yv * c.va1) / c.ya1;
            group.last.at(lane) = (c.yv * c.va0 - c.vv * c.ya0) / c.ya1;
            group.unit.at(lane) = c.ya1;
        }
        ++group.count;
    }
}

PeakSwing PeakResponse::peak(std::span<double const> series, Group const& group, std::size_t lane,
                             std::vector<double> const& blocks) const {
    auto const& o = oscillators_[group.first + lane];
    std::size_t const count = blocks.size() / Sweep::values_per_block;
    double highest = 0;
    for (std::size_t b = 0; b < count; ++b) {
        highest = std::max(highest, blocks[b * Sweep::values_per_block + lane]);
    }
    PeakSwing found;
    double best = 0;
    for (std::size_t b = 0; b < count; ++b) {
        double const* const block = blocks.data() + b * Sweep::values_per_block;
        if (block[lane] < o.margin * highest || highest == 0) {
            continue;
        }
        std::size_t const first = 1 + b * Sweep::block_samples;
        double y = group.unit.at(lane) * block[wide::lanes + lane];
        double v = 0;
        if (first > 1) {
            double const a0 = series[first - 2];
            double const a1 = series[first - 1];
            double const y0 = group.unit.at(lane) * block[2 * wide::lanes + lane];
            double const v0 = (y - o.sample.yy * y0 - o.sample.ya0 * a0 - o.sample.ya1 * a1) / o.sample.yv;
            v = o.sample.vy * y0 + o.sample.vv * v0 + o.sample.va0 * a0 + o.sample.va1 * a1;
        }
        double before = y;
        for (std::size_t n = first; n < std::min(first + Sweep::block_samples, series.size()); ++n) {
            double const rise = (series[n] - series[n - 1]) / o.steps;
            for (int s = 0; s < o.steps; ++s) {
                double const a0 = series[n - 1] + rise * s;
                double const a1 = series[n - 1] + rise * (s + 1);
                double const next = o.fine.yy * y + o.fine.yv * v + (o.fine.ya0 * a0 + o.fine.ya1 * a1);
                v = o.fine.vy * y + o.fine.vv * v + (o.fine.va0 * a0 + o.fine.va1 * a1);
                double const earlier = before;
                before = y;
                y = next;
                if (std::abs(y) > best) {
                    best = std::abs(y);
                    found.time_s = group.sample_s * (static_cast<double>(n - 1) + (s + 1.0) / o.steps);
                    found.displacement_m = y;
                } else if (group.thinning > 0 && std::abs(before) == best && std::abs(earlier) <= best) {
                    found.displacement_m = before + beyond_middle(earlier, before, y);
                }
            }
        }
    }
    found.displacement_m *= o.gain;
    return found;
}

std::vector<PeakSwing> PeakResponse::swings(std::span<double const> acceleration_mps2) const {
    std::vector<std::vector<double>> thinner;
    std::vector<PeakSwing> found;
    found.reserve(oscillators_.size());
    std::vector<double> blocks;
    for (auto const& group : groups_) {
        while (thinner.size() < group.thinning) {
            thinner.push_back(thinned(thinner.empty() ? acceleration_mps2 : std::span<double const>(thinner.back())));
        }
        auto const series =
            group.thinning == 0 ? acceleration_mps2 : std::span<double const>(thinner[group.thinning - 1]);
        blocks.resize(Sweep::values_per_block * ((series.size() + Sweep::block_samples - 2) / Sweep::block_samples));
        wide::dispatch(Sweep{series, &group, blocks.data()});
        for (std::size_t lane = 0; lane < group.count; ++lane) {
            found.push_back(peak(series, group, lane, blocks));
        }
    }
    return found;
}

}  // namespace overturn
