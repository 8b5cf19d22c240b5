#include "generators/detail/ensemble_calibration.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "generators/detail/high_pass_baseline.hpp"
#include "spectra/input_energy.hpp"
#include "spectra/peak_response.hpp"

namespace overturn {
namespace {

// Draws at every `stride`-th sample, and the periods that so many samples still show.
class ThinnedDraws {
  public:
    ThinnedDraws(NoiseLines const& lines, TargetSpectrum const& target, std::vector<double> periods_s,
                 std::size_t stride)
        : lines_(lines),
          target_(target),
          stride_(stride),
          fft_(lines.length() / stride),
          periods_s_(std::move(periods_s)),
          sweep_(periods_s_, target.damping(), step_s()),
          baseline_((lines.envelope().size() + stride - 1) / stride, step_s(), lines.longest_s()) {
        for (std::size_t i = 0; i < lines.envelope().size(); i += stride) {
            envelope_.push_back(lines.envelope()[i]);
        }
    }

    /// Per period, the median of computed over target of `draws` waves from the `first` on.
    [[nodiscard]] std::vector<double> medians(std::uint64_t first, std::int64_t draws, ShareRows const& share) const {
        auto const rows = share(draws, periods_s_.size(), [&](std::int64_t wave, std::span<double> ratios) {
            auto const computed = pseudo_velocities(draw(first + wave));
            for (std::size_t i = 0; i < computed.size(); ++i) {
                ratios[i] = computed[i] / target_.psv_mps(periods_s_[i]);
            }
        });
        std::vector<double> medians;
        for (std::size_t i = 0; i < periods_s_.size(); ++i) {
            std::vector<double> values;
            for (std::size_t at = i; at < rows.size(); at += periods_s_.size()) {
                values.push_back(rows[at]);
            }
            auto const middle = values.begin() + (values.size() / 2);
            std::nth_element(values.begin(), middle, values.end());
            medians.push_back(*middle);
        }
        return medians;
    }

  private:
    [[nodiscard]] double step_s() const { return lines_.time_step_s() * static_cast<double>(stride_); }

    [[nodiscard]] std::vector<double> draw(std::uint64_t wave) const {
        constexpr std::uint64_t seed = 0x0ca11b8a7e;
        std::vector<double> series(fft_.length());
        fft_.synthesise(lines_.draw(LineStreams::of_calibration(seed, wave), fft_.length() / 2), series);
        series.resize(envelope_.size());
        for (std::size_t i = 0; i < series.size(); ++i) {
            series[i] *= envelope_[i];
        }
        baseline_.correct(series);
        return series;
    }

    [[nodiscard]] std::vector<double> pseudo_velocities(std::vector<double> const& wave) const {
        if (target_.is_energy()) {
            return input_energy_velocities(wave, step_s(), periods_s_, target_.damping());
        }
        std::vector<double> values;
        for (auto const& peak : sweep_.peaks(wave)) {
            values.push_back(std::abs(peak.displacement_m) * 2 * pi / periods_s_[values.size()]);
        }
        return values;
    }

    NoiseLines const& lines_;
    TargetSpectrum const& target_;
    std::size_t stride_;
    RealFft fft_;
    std::vector<double> periods_s_;
    std::vector<double> envelope_;
    PeakResponse sweep_;
    HighPassBaseline baseline_;
};

// The largest stride up to 10 that leaves whole waves, at least 32 samples a period of `from_s` and an even length.
std::size_t widest_stride(NoiseLines const& lines, double from_s) {
    constexpr std::size_t most = 10;
    constexpr double points_per_period = 32;
    for (std::size_t stride = most; stride > 1; --stride) {
        if (lines.length() % (2 * stride) == 0
            && points_per_period * static_cast<double>(stride) * lines.time_step_s() <= from_s) {
            return stride;
        }
    }
    return 1;
}

// Means over as many neighbours as there are on both sides, up to two, below `fine_from`: slopes stay, what is random
// does not. At 50 periods a decade two are 10 %, an oscillator's own width.
std::vector<double> smoothed(std::span<double const> values, std::size_t fine_from) {
    std::vector<double> means;
    for (std::size_t i = 0; i < values.size(); ++i) {
        std::size_t const near = i < fine_from ? std::min({std::size_t{2}, i, values.size() - 1 - i}) : 0;
        double sum = 0;
        for (std::size_t j = i - near; j <= i + near; ++j) {
            sum += values[j];
        }
        means.push_back(sum / static_cast<double>(2 * near + 1));
    }
    return means;
}

}  // namespace

MatchFigures calibrate(NoiseLines& lines, TargetSpectrum const& target, std::span<double const> periods_s,
                       ShareRows const& share) {
    constexpr double long_from_s = 3;
    // Neighbours blur what a line can do: at a bend of the target, first rounds ask for more than they see.
    struct Round {
        std::int64_t draws, long_draws;
        double power;
    };
    constexpr std::array rounds{Round{48, 400, 2}, Round{48, 400, 2}, Round{64, 600, 2}, Round{64, 800, 1.5},
                                Round{128, 4000, 1}};
    auto const split = std::lower_bound(periods_s.begin(), periods_s.end(), long_from_s);
    std::optional<ThinnedDraws> brief;
    std::optional<ThinnedDraws> slow;
    if (split != periods_s.begin()) {
        brief.emplace(lines, target, std::vector<double>{periods_s.begin(), split}, 1);
    }
    if (split != periods_s.end()) {
        slow.emplace(lines, target, std::vector<double>{split, periods_s.end()}, widest_stride(lines, long_from_s));
    }
    auto const medians_of = [&](std::uint64_t first, std::int64_t draws, std::int64_t long_draws) {
        std::vector<double> medians;
        if (brief) {
            medians = brief->medians(first, draws, share);
        }
        if (slow) {
            auto const rest = slow->medians(first, long_draws, share);
            medians.insert(medians.end(), rest.begin(), rest.end());
        }
        return medians;
    };
    for (auto const& round : rounds) {
        auto divisors = smoothed(medians_of(0, round.draws, round.long_draws), split - periods_s.begin());
        for (double& value : divisors) {
            value = std::pow(value, round.power);
        }
        lines.divide(periods_s, divisors);
    }
    constexpr std::uint64_t fresh = 1'000'000;  // draws that no correction has seen
    return match_figures(periods_s, medians_of(fresh, rounds.back().draws, 1000), 0, periods_s.back());
}

}  // namespace overturn
