#include "generators/detail/line_gains.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.hpp"
#include "core/units.hpp"
#include "generators/detail/line_sums.hpp"

namespace overturn {
namespace {

constexpr double bands_per_decade = 100;
constexpr double reach = 4;  // lines beyond this many times an oscillator's frequency move it by 7 % of what they could

float dot(float const* a, float const* b, std::size_t count) {
    constexpr std::size_t width = 8;
    std::array<float, width> part{};
    std::size_t i = 0;
    for (; i + width <= count; i += width) {
        for (std::size_t j = 0; j < width; ++j) {
            part[j] += a[i + j] * b[i + j];
        }
    }
    float sum = ((part[0] + part[4]) + (part[1] + part[5])) + ((part[2] + part[6]) + (part[3] + part[7]));
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
                                           std::span<PeakDisplacement const> peaks,
                                           std::span<double const> envelope) const {
    auto const bands = band_end_.size();
    Matrix matrix{std::vector<float>(periods_s_.size() * bands), {}};
    matrix.used.reserve(periods_s_.size());
    std::vector<float> block(bands * simd::sweep_lanes);
    for (std::size_t begin = 0; begin < periods_s_.size(); begin += simd::sweep_lanes) {
        std::size_t const count = std::min(simd::sweep_lanes, periods_s_.size() - begin);
        LineOscillators oscillators{};
        auto const set = [](float& to, double value) { to = static_cast<float>(value); };
        for (std::size_t lane = 0; lane < simd::sweep_lanes; ++lane) {
            std::size_t const i = begin + std::min(lane, count - 1);
            double const frequency = 2 * pi / (periods_s_[i] * spacing_radps_);
            double const turn = spacing_radps_ * peaks[i].time_s;
            double const start = turn * static_cast<double>(first_line_);
            set(oscillators.frequency.at(lane), frequency);
            set(oscillators.twice_damped.at(lane), 2 * damping_ * frequency);
            set(oscillators.turn_cos.at(lane), std::cos(turn));
            set(oscillators.turn_sin.at(lane), std::sin(turn));
            set(oscillators.start_cos.at(lane), std::cos(start));
            set(oscillators.start_sin.at(lane), std::sin(start));
        }
        double const highest = reach * 2 * pi / (periods_s_[begin] * spacing_radps_);
        auto const used =
            static_cast<std::size_t>(std::find_if(band_end_.begin(), band_end_.end(),
                                                  [&](std::size_t end) { return static_cast<double>(end) > highest; })
                                     - band_end_.begin());
        sum_lines(lines, std::span(band_end_).first(used), first_line_, oscillators, block);
        double const unit = 1 / (spacing_radps_ * spacing_radps_);
        for (std::size_t lane = 0; lane < count; ++lane) {
            std::size_t const i = begin + lane;
            matrix.used.push_back(used);
            double total = 0;
            for (std::size_t band = 0; band < used; ++band) {
                total += unit * block[band * simd::sweep_lanes + lane];
            }
            constexpr double trusted = 3;  // beyond it the peak is not what the stationary sum says at all
            double const stated = peaks[i].displacement_m / total;
            bool const sound = stated > envelope[i] / trusted && stated < envelope[i] * trusted;
            double const peak = peaks[i].displacement_m;
            auto const scale = static_cast<float>(peak == 0 ? 0 : unit * (sound ? stated : envelope[i]) / peak);
            for (std::size_t band = 0; band < used; ++band) {
                matrix.values[i * bands + band] = scale * block[band * simd::sweep_lanes + lane];
            }
        }
    }
    return matrix;
}

std::vector<float> LineGains::solve(Matrix const& matrix, std::vector<float> residual, Trust trust) const {
    // Of the normal equations, whose diagonal is about 0.1 to 1. Little damping fits better, at the price of the
    // wave's own phases and envelope: only waves that would fail otherwise pay it.
    bool const much = trust == Trust::much;
    float const damping = much ? 0.002F : 0.02F;
    int const steps = much ? 24 : 12;
    auto const bands = band_end_.size();
    auto const rows = residual.size();
    auto const row = [&](std::size_t i) { return matrix.values.data() + i * bands; };
    auto const add = [&](std::vector<float>& to, std::size_t i, float share) {
        for (std::size_t j = 0; j < matrix.used[i]; ++j) {
            to[j] += row(i)[j] * share;
        }
    };
    std::vector<float> gains(bands, 0.0F);
    std::vector<float> slope(bands, 0.0F);  // M' residual - damping gains
    for (std::size_t i = 0; i < rows; ++i) {
        add(slope, i, residual[i]);
    }
    auto direction = slope;
    std::vector<float> bent(bands);  // M' M direction
    float size = dot(slope.data(), slope.data(), bands);
    for (int step = 0; step < steps && size > 0; ++step) {
        std::fill(bent.begin(), bent.end(), 0.0F);
        for (std::size_t i = 0; i < rows; ++i) {
            add(bent, i, dot(row(i), direction.data(), matrix.used[i]));
        }
        float const curvature =
            dot(bent.data(), direction.data(), bands) + damping * dot(direction.data(), direction.data(), bands);
        float const length = size / curvature;
        for (std::size_t j = 0; j < bands; ++j) {
            gains[j] += length * direction[j];
            slope[j] -= length * (bent[j] + damping * direction[j]);
        }
        float const next = dot(slope.data(), slope.data(), bands);
        for (std::size_t j = 0; j < bands; ++j) {
            direction[j] = slope[j] + next / size * direction[j];
        }
        size = next;
    }
    return gains;
}

void LineGains::apply(std::span<std::complex<double>> lines, std::span<PeakDisplacement const> peaks,
                      std::span<double const> envelope, std::span<double const> ratios, Trust trust) const {
    constexpr double most = 0.4;  // no step changes a band by more: the sum is of first order
    std::vector<float> residual;
    residual.reserve(ratios.size());
    for (double const value : ratios) {
        residual.push_back(static_cast<float>(std::clamp(value - 1, -most, most)));
    }
    auto const gains = solve(contributions(lines, peaks, envelope), std::move(residual), trust);
    std::size_t k = first_line_;
    for (std::size_t band = 0; band < gains.size(); ++band) {
        for (; k < band_end_[band]; ++k) {
            lines[k] *= 1 + std::clamp(static_cast<double>(gains[band]), -most, most);
        }
    }
}

}  // namespace overturn
