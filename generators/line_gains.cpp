#include "generators/line_gains.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.hpp"
#include "core/units.hpp"
#include "spectra/wide.hpp"

namespace overturn {
namespace {

constexpr double bands_per_decade = 100;
constexpr double reach = 4;  // lines beyond this many times an oscillator's frequency move it by 7 % of what they could

using LaneValues = std::array<double, wide::lanes>;

// Sixteen oscillators over all lines that matter to them: per band, Re(H L exp(i w t)) at each one's own instant.
struct Contributions {
    std::span<std::complex<double> const> lines;
    std::span<std::size_t const> band_end;
    std::size_t first_line;
    double spacing;
    LaneValues const* frequency;
    LaneValues const* twice_damped;  // 2 zeta w
    LaneValues const* turn_cos;      // of spacing times the instant
    LaneValues const* turn_sin;
    LaneValues const* start_cos;  // of the first line's frequency times the instant
    LaneValues const* start_sin;
    double* to;  // bands x 16

    template <int bytes> OVERTURN_INLINE void run() const {
        using R = wide::Registers<bytes>;
        R w, damped, tc, ts, pc, ps, w2, sum;
        R::load(w, frequency->data());
        R::load(damped, twice_damped->data());
        R::load(tc, turn_cos->data());
        R::load(ts, turn_sin->data());
        R::load(pc, start_cos->data());
        R::load(ps, start_sin->data());
        for (int r = 0; r < R::count; ++r) {
            w2.at[r] = w.at[r] * w.at[r];
        }
        std::size_t k = first_line;
        for (std::size_t band = 0; band < band_end.size(); ++band) {
            R::clear(sum);
            for (; k < band_end[band]; ++k) {
                double const x = spacing * static_cast<double>(k);
                double const re = -lines[k].real();
                double const im = -lines[k].imag();
#pragma GCC unroll 8
                for (int r = 0; r < R::count; ++r) {
                    auto const d = w2.at[r] - x * x;
                    auto const q = damped.at[r] * x;
                    auto const a = wide::fma(ps.at[r], -im, pc.at[r] * re);
                    auto const b = wide::fma(ps.at[r], re, pc.at[r] * im);
                    sum.at[r] += wide::fma(a, d, b * q) / wide::fma(d, d, q * q);
                    auto const c = wide::fma(pc.at[r], tc.at[r], -ps.at[r] * ts.at[r]);
                    ps.at[r] = wide::fma(pc.at[r], ts.at[r], ps.at[r] * tc.at[r]);
                    pc.at[r] = c;
                }
            }
            R::store(to + band * wide::lanes, sum);
        }
    }
};

double dot(double const* a, double const* b, std::size_t count) {
    std::array<double, 4> part{};
    std::size_t i = 0;
    for (; i + 4 <= count; i += 4) {
        for (std::size_t j = 0; j < 4; ++j) {
            part[j] += a[i + j] * b[i + j];
        }
    }
    double sum = (part[0] + part[1]) + (part[2] + part[3]);
    for (; i < count; ++i) {
        sum += a[i] * b[i];
    }
    return sum;
}

}  // namespace

LineGains::LineGains(std::vector<double> periods_s, double damping, double spacing_radps, std::size_t first_line,
                     std::size_t last_line)
    : periods_s_(std::move(periods_s)), damping_(damping), spacing_radps_(spacing_radps), first_line_(first_line) {
    OVERTURN_EXPECT(first_line >= 1 && last_line > first_line);
    double const ratio = std::pow(10.0, 1 / bands_per_decade);
    double const highest = reach * 2 * pi / periods_s_.front() / spacing_radps;
    auto const last = static_cast<std::size_t>(std::min(highest, static_cast<double>(last_line)));
    for (std::size_t k = first_line; k < last;) {
        k = std::min(last, std::max(k + 1, static_cast<std::size_t>(ratio * static_cast<double>(k))));
        band_end_.push_back(k);
    }
}

LineGains::Matrix LineGains::contributions(std::span<std::complex<double> const> lines,
                                           std::span<PeakSwing const> swings, std::span<double const> envelope) const {
    auto const bands = band_end_.size();
    Matrix matrix{std::vector<double>(periods_s_.size() * bands), {}};
    matrix.used.reserve(periods_s_.size());
    std::vector<double> block(bands * wide::lanes);
    for (std::size_t begin = 0; begin < periods_s_.size(); begin += wide::lanes) {
        std::size_t const count = std::min(wide::lanes, periods_s_.size() - begin);
        LaneValues w{}, damped{}, turn_cos{}, turn_sin{}, start_cos{}, start_sin{};
        for (std::size_t lane = 0; lane < wide::lanes; ++lane) {
            std::size_t const i = begin + std::min(lane, count - 1);
            w.at(lane) = 2 * pi / periods_s_[i];
            damped.at(lane) = 2 * damping_ * w.at(lane);
            double const turn = spacing_radps_ * swings[i].time_s;
            turn_cos.at(lane) = std::cos(turn);
            turn_sin.at(lane) = std::sin(turn);
            start_cos.at(lane) = std::cos(turn * static_cast<double>(first_line_));
            start_sin.at(lane) = std::sin(turn * static_cast<double>(first_line_));
        }
        double const highest = reach * w[0] / spacing_radps_;
        auto const used =
            static_cast<std::size_t>(std::find_if(band_end_.begin(), band_end_.end(),
                                                  [&](std::size_t end) { return static_cast<double>(end) > highest; })
                                     - band_end_.begin());
        wide::dispatch(Contributions{lines, std::span(band_end_).first(used), first_line_, spacing_radps_, &w, &damped,
                                     &turn_cos, &turn_sin, &start_cos, &start_sin, block.data()});
        for (std::size_t lane = 0; lane < count; ++lane) {
            std::size_t const i = begin + lane;
            matrix.used.push_back(used);
            double total = 0;
            for (std::size_t band = 0; band < used; ++band) {
                total += block[band * wide::lanes + lane];
            }
            constexpr double trusted = 3;  // beyond it the swing is not what the stationary sum says at all
            double const stated = swings[i].displacement_m / total;
            bool const sound = stated > envelope[i] / trusted && stated < envelope[i] * trusted;
            double const swing = swings[i].displacement_m;
            double const scale = swing == 0 ? 0 : (sound ? stated : envelope[i]) / swing;
            for (std::size_t band = 0; band < used; ++band) {
                matrix.values[i * bands + band] = scale * block[band * wide::lanes + lane];
            }
        }
    }
    return matrix;
}

std::vector<double> LineGains::solve(Matrix const& matrix, std::vector<double> residual, Trust trust) const {
    // Of the normal equations, whose diagonal is about 0.1 to 1. Little damping fits better, at the price of the
    // wave's own phases and envelope: only waves that would fail otherwise pay it.
    bool const much = trust == Trust::much;
    double const damping = much ? 0.002 : 0.02;
    int const steps = much ? 24 : 12;
    auto const bands = band_end_.size();
    auto const rows = residual.size();
    std::vector<double> gains(bands, 0.0);
    std::vector<double> along(rows);
    auto const gradient = [&] {
        std::vector<double> sum(bands, 0.0);
        for (std::size_t i = 0; i < rows; ++i) {
            double const* const row = matrix.values.data() + i * bands;
            double const share = residual[i];
            for (std::size_t j = 0; j < matrix.used[i]; ++j) {
                sum[j] += row[j] * share;
            }
        }
        for (std::size_t j = 0; j < bands; ++j) {
            sum[j] -= damping * gains[j];
        }
        return sum;
    };
    auto slope = gradient();
    auto direction = slope;
    double size = dot(slope.data(), slope.data(), bands);
    for (int step = 0; step < steps && size > 0; ++step) {
        for (std::size_t i = 0; i < rows; ++i) {
            along[i] = dot(matrix.values.data() + i * bands, direction.data(), matrix.used[i]);
        }
        double const curvature =
            dot(along.data(), along.data(), rows) + damping * dot(direction.data(), direction.data(), bands);
        double const length = size / curvature;
        for (std::size_t j = 0; j < bands; ++j) {
            gains[j] += length * direction[j];
        }
        for (std::size_t i = 0; i < rows; ++i) {
            residual[i] -= length * along[i];
        }
        slope = gradient();
        double const next = dot(slope.data(), slope.data(), bands);
        for (std::size_t j = 0; j < bands; ++j) {
            direction[j] = slope[j] + next / size * direction[j];
        }
        size = next;
    }
    return gains;
}

void LineGains::apply(std::span<std::complex<double>> lines, std::span<PeakSwing const> swings,
                      std::span<double const> envelope, std::span<double const> ratios, Trust trust) const {
    constexpr double most = 0.4;  // no step changes a band by more: the sum is of first order
    std::vector<double> residual(ratios.begin(), ratios.end());
    for (double& value : residual) {
        value = std::clamp(value - 1, -most, most);
    }
    auto const gains = solve(contributions(lines, swings, envelope), std::move(residual), trust);
    std::size_t k = first_line_;
    for (std::size_t band = 0; band < gains.size(); ++band) {
        for (; k < band_end_[band]; ++k) {
            lines[k] *= 1 + std::clamp(gains[band], -most, most);
        }
    }
}

}  // namespace overturn
