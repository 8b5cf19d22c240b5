// The rare-event problem whose probabilities were measured with tens of millions of plain trials: a block of b .45 m,
// h 1.045 m, e .85 under filtered noise that one factor scales.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/units.hpp"
#include "model/chunk_extremes.hpp"
#include "rare/detail/normals.hpp"
#include "rare/peak.hpp"
#include "rare/problem.hpp"
#include "rocking/planar_rocking.hpp"
#include "spectra/response_spectrum.hpp"
#include "spectra/transform.hpp"

namespace overturn::testing {

/// Waves of `samples` samples at 0.01 s; factor 1 has a standard deviation of 1 m/s2 where the envelope is 1.
class RockingNoise : public rare::Problem {
  public:
    /// peak_scaled: each wave to its own peak, factor times g tan alpha. matched: each to the median spectrum of linear
    /// ones, 3 times at 16 periods of 0.1 s to 8 s, 5 % damping.
    enum class Map { linear, peak_scaled, matched };

    explicit RockingNoise(std::size_t samples = 4096, Map map = Map::linear) : map_(map), envelope_(samples) {
        auto const duration = static_cast<double>(samples) * step_s;
        double squares = 0;
        for (std::size_t k = 1; k <= samples / 4; ++k) {
            double const f = static_cast<double>(k) / duration;
            std::complex<double> const i(0, 1);
            double const r = f / 0.5;
            double const q = f / 0.1;
            amplitude_.push_back(std::abs((1.0 + i * r) / (1 - r * r + i * r))
                                 * std::abs(q * q / (1 - q * q + 1.4 * i * q)) / (1 + std::pow(f / 8, 4)));
            squares += amplitude_.back() * amplitude_.back();
        }
        for (double& amplitude : amplitude_) {
            amplitude /= std::sqrt(squares);
        }
        for (std::size_t n = 0; n < samples; ++n) {
            double const t = step_s * static_cast<double>(n);
            double const strength = t < 8                ? (t / 8) * (t / 8)
                                    : t < 0.6 * duration ? 1.0
                                                         : std::exp(-.15 * (t - 0.6 * duration));
            double const left = step_s * static_cast<double>(samples - 1 - n);
            envelope_[n] = strength * std::min(1.0, left / 2);
        }
        if (map_ == Map::matched) {
            find_median_spectrum();
        }
    }

    static constexpr double step_s = 0.01;
    [[nodiscard]] static RockingBlock block() {
        double const radius = std::hypot(.45, 1.045);
        return {.alpha_rad = std::atan(.45 / 1.045), .p_radps = std::sqrt(0.75 * g0 / radius), .restitution = 0.85};
    }
    [[nodiscard]] std::vector<double> const& amplitude() const { return amplitude_; }
    [[nodiscard]] std::size_t normals() const override { return 2 * amplitude_.size(); }

    [[nodiscard]] std::optional<rare::PulseFrame> frame() const override {
        double const duration = step_s * static_cast<double>(envelope_.size());
        double const body_period = 2 * pi / block().p_radps;
        return rare::PulseFrame{.lines = static_cast<std::size_t>(7.5 / body_period * duration),
                                .spacing_radps = 2 * pi / duration,
                                .duration_s = duration,
                                .body_period_s = body_period};
    }

    /// The wave at factor 1, or with a peak of g tan alpha.
    [[nodiscard]] std::vector<double> wave(std::span<double const> normals) const {
        if (map_ == Map::matched) {
            return matched_wave(normals);
        }
        auto made = enveloped(normals, amplitude_);
        if (map_ == Map::peak_scaled) {
            double const peak = rare::peak_of_wave(made);
            for (double& a : made) {
                a *= g0 * std::tan(block().alpha_rad) / peak;
            }
        }
        return made;
    }
    void respond(std::span<double const> normals, std::span<double const> factors,
                 std::span<rare::Answer> answers) const override {
        auto const made = wave(normals);
        double const peak = rare::peak_of_wave(made);
        double const threshold = g0 * std::tan(block().alpha_rad);
        for (std::size_t f = 0; f < factors.size(); ++f) {
            if (factors[f] * peak <= threshold) {
                answers[f] = {factors[f] * peak / threshold - 1, false, false};
                continue;
            }
            auto const outcome = simulate_rocking(block(), excitation(made, factors[f]));
            answers[f] = {outcome.peak_energy_ratio, outcome.verdict == Verdict::overturned, false};
        }
    }

    [[nodiscard]] rare::Moment moment(std::span<double const> normals, double factor) const override {
        struct Watch : RockingObserver {
            rare::Moment last;
            double before = 0;
            void at(RockingInstant const& now) override {
                double const critical = block().alpha_rad;
                if (std::abs(before) < critical && std::abs(now.rotation_rad) >= critical) {
                    last = {now.time_s, now.rotation_rad > 0 ? 1.0 : -1.0};
                }
                before = now.rotation_rad;
            }
        } watch;
        auto const made = wave(normals);
        (void)simulate_rocking(block(), excitation(made, factor), {}, {}, &watch);
        return watch.last;
    }

  private:
    [[nodiscard]] std::vector<double> enveloped(std::span<double const> normals,
                                                std::span<double const> amplitude) const {
        auto const transform = real_synthesis(envelope_.size());
        std::fill(transform.in.begin(), transform.in.end(), 0.0);
        for (std::size_t k = 1; k <= amplitude.size(); ++k) {
            transform.in[k] = 0.5 * amplitude[k - 1] * std::complex<double>(normals[2 * k - 2], normals[2 * k - 1]);
        }
        transform.run();
        std::vector<double> made(envelope_.size());
        for (std::size_t n = 0; n < made.size(); ++n) {
            made[n] = envelope_[n] * transform.out[n];
        }
        return made;
    }

    [[nodiscard]] std::vector<double> spectrum(std::span<double const> made) const {
        return displacement_spectrum(made, step_s, periods_s_, 0.05);
    }

    void find_median_spectrum() {
        constexpr std::uint64_t waves = 1001;
        std::vector<std::vector<double>> seen(periods_s_.size());
        std::vector<double> x(normals());
        for (std::uint64_t i = 0; i < waves; ++i) {
            rare::draw_normals({.seed = 16, .index = i}, x);
            auto const found = spectrum(enveloped(x, amplitude_));
            for (std::size_t p = 0; p < found.size(); ++p) {
                seen[p].push_back(found[p]);
            }
        }
        for (auto& values : seen) {
            std::ranges::nth_element(values, values.begin() + waves / 2);
            median_m_.push_back(values[waves / 2]);
        }
    }

    // Ratios are straight lines in logarithms between the periods, and what they are at the ends beyond them.
    [[nodiscard]] std::vector<double> matched_wave(std::span<double const> normals) const {
        auto amplitude = amplitude_;
        auto made = enveloped(normals, amplitude);
        double const spacing = std::log(periods_s_[1] / periods_s_[0]);
        auto const last = static_cast<double>(periods_s_.size() - 1);
        for (int pass = 0; pass < 3; ++pass) {
            auto const found = spectrum(made);
            for (std::size_t k = 0; k < amplitude.size(); ++k) {
                double const period = step_s * static_cast<double>(envelope_.size()) / static_cast<double>(k + 1);
                double const place = std::clamp(std::log(period / periods_s_.front()) / spacing, 0.0, last);
                auto const left = std::min(static_cast<std::size_t>(place), periods_s_.size() - 2);
                double const share = place - static_cast<double>(left);
                amplitude[k] *= std::pow(median_m_[left] / found[left], 1 - share)
                                * std::pow(median_m_[left + 1] / found[left + 1], share);
            }
            made = enveloped(normals, amplitude);
        }
        return made;
    }

    [[nodiscard]] static Excitation excitation(std::span<double const> made, double factor) {
        return {.horizontal_mps2 = made, .time_step_s = step_s, .scale = factor};
    }

    Map map_;
    std::vector<double> amplitude_, envelope_;
    std::vector<double> periods_s_ = log_periods(0.1, 8, 16);
    std::vector<double> median_m_;
};

}  // namespace overturn::testing
