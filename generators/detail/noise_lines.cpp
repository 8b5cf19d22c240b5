#include "generators/detail/noise_lines.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "generators/detail/spectral_density.hpp"

namespace overturn {
namespace {

constexpr double cutoff = 1.5;  // no line beyond this many times the longest period

// 1 up to the longest period, 0 from `cutoff` times it, a half cosine in log period between.
double long_period_fade(double period_s, double longest_s) {
    double const beyond = std::log(period_s / longest_s) / std::log(cutoff);
    return beyond <= 0 ? 1.0 : beyond >= 1 ? 0.0 : 0.5 * (1 + std::cos(pi * beyond));
}

// Values between periods in equal ratios, straight in log period, at the periods of lines.
class AtLines {
  public:
    AtLines(double spacing_radps, std::span<double const> periods_s, std::span<double const> values)
        : log_first_(std::log(2 * pi / spacing_radps / periods_s.front())),
          per_gap_(static_cast<double>(periods_s.size() - 1) / std::log(periods_s.back() / periods_s.front())),
          values_(values) {}

    [[nodiscard]] double operator()(std::size_t line) const {
        double const place = std::clamp((log_first_ - std::log(static_cast<double>(line))) * per_gap_, 0.0,
                                        static_cast<double>(values_.size() - 1));
        auto const left = std::min(static_cast<std::size_t>(place), values_.size() - 2);
        double const share = place - static_cast<double>(left);
        return (1 - share) * values_[left] + share * values_[left + 1];
    }

  private:
    double log_first_, per_gap_;
    std::span<double const> values_;
};

}  // namespace

NoiseLines::NoiseLines(NoiseInput const& input)
    : time_step_s_(input.time_step_s),
      longest_s_(input.longest_s),
      amplitudes_(input.amplitudes),
      fft_(RealFft::good_length(input.samples)),
      spacing_radps_(2 * pi / (time_step_s_ * static_cast<double>(fft_.length()))),
      envelope_(input.envelope.samples(input.time_step_s, input.samples)),
      baseline_(input.samples, input.time_step_s, input.longest_s) {
    strong_s_ = time_step_s_ * std::inner_product(envelope_.begin(), envelope_.end(), envelope_.begin(), 0.0);
    std::vector<double> frequencies;
    for (std::size_t k = 1; k < fft_.length() / 2; ++k) {
        frequencies.push_back(spacing_radps_ * static_cast<double>(k));
    }
    auto density = density_of(input.target, frequencies, strong_s_);
    for (std::size_t i = 0; i < density.size(); ++i) {
        double const fade = long_period_fade(2 * pi / frequencies[i], longest_s_);
        density[i] *= fade * fade;
    }
    if (input.refined && !input.target.is_energy()) {
        refine_density(density, input.target, frequencies, strong_s_, longest_s_);
    }
    amplitude_.push_back(0);
    for (double const value : density) {
        amplitude_.push_back(std::sqrt(2 * value * spacing_radps_));
    }
    first_ = std::find_if(amplitude_.begin(), amplitude_.end(), [](double a) { return a > 0; }) - amplitude_.begin();
}

std::vector<double> NoiseLines::synthesise(Lines const& lines, std::span<double const> envelope) const {
    std::vector<double> series(fft_.length());
    fft_.synthesise(lines, series);
    series.resize(envelope.size());
    for (std::size_t i = 0; i < series.size(); ++i) {
        series[i] *= envelope[i];
    }
    baseline_.correct(series);
    return series;
}

Lines NoiseLines::analyse(std::span<double const> acceleration_mps2) const {
    std::vector<double> padded(fft_.length(), 0.0);
    auto const kept = acceleration_mps2.first(std::min(acceleration_mps2.size(), envelope_.size()));
    std::copy(kept.begin(), kept.end(), padded.begin());
    Lines lines(amplitude_.size());
    fft_.analyse(padded, lines);
    lines[0] = 0;
    for (std::size_t k = 1; k < lines.size(); ++k) {
        lines[k] *= long_period_fade(2 * pi / (spacing_radps_ * static_cast<double>(k)), longest_s_);
    }
    return lines;
}

Lines NoiseLines::products(std::span<double const> weights, std::size_t count) const {
    std::vector<double> padded(fft_.length(), 0.0);
    std::ranges::copy(weights, padded.begin());
    Lines lines(amplitude_.size());
    fft_.analyse(padded, lines);  // 2 / length sum weights exp(-i w t)
    lines.resize(count);
    for (auto& line : lines) {
        line = std::conj(line) * (static_cast<double>(fft_.length()) / 2);
    }
    return lines;
}

std::pair<double, double> NoiseLines::lowest_power(std::span<double const> acceleration_mps2) const {
    constexpr double from_hz = 0.3;
    constexpr double to_hz = 24;
    constexpr double window = 0.2;
    std::vector<double> padded(fft_.length(), 0.0);
    std::copy(acceleration_mps2.begin(), acceleration_mps2.end(), padded.begin());
    Lines lines(amplitude_.size());
    fft_.analyse(padded, lines);
    double const length_s = 2 * pi / spacing_radps_;
    std::vector<double> power(lines.size() + 1, 0.0);  // sums over lines below each
    std::vector<double> wanted(lines.size() + 1, 0.0);
    for (std::size_t k = 0; k < lines.size(); ++k) {
        power[k + 1] = power[k] + std::norm(lines[k]);
        wanted[k + 1] = wanted[k] + amplitude_[k] * amplitude_[k] * strong_s_ / length_s;
    }
    std::pair<double, double> lowest{0, 0};
    for (std::size_t k = 1; k < lines.size(); ++k) {
        double const hz = static_cast<double>(k) / length_s;
        auto const last = static_cast<std::size_t>((1 + window) * static_cast<double>(k)) + 1;
        if (hz < from_hz || hz > to_hz || last > lines.size()) {
            continue;
        }
        auto const first = static_cast<std::size_t>(std::ceil((1 - window) * static_cast<double>(k)));
        double const ratio = (power[last] - power[first]) / (wanted[last] - wanted[first]);
        if (lowest.second == 0 || ratio < lowest.first) {
            lowest = {ratio, hz};
        }
    }
    return lowest;
}

void NoiseLines::divide(std::span<double const> periods_s, std::span<double const> divisors) {
    AtLines const divisor(spacing_radps_, periods_s, divisors);
    for (std::size_t k = 1; k < amplitude_.size(); ++k) {
        amplitude_[k] /= divisor(k);
    }
}

void divide_lines(Lines& lines, double spacing_radps, std::span<double const> periods_s,
                  std::span<double const> divisors) {
    AtLines const divisor(spacing_radps, periods_s, divisors);
    for (std::size_t k = 1; k < lines.size(); ++k) {
        lines[k] /= divisor(k);
    }
}

}  // namespace overturn
