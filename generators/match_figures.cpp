#include "generators/match_figures.hpp"

#include <algorithm>
#include <cmath>

namespace overturn {

MatchFigures match_figures(std::span<double const> periods_s, std::span<double const> ratios, double from_s,
                           double to_s) {
    MatchFigures figures;
    double count = 0, sum = 0, squares = 0;
    int below = 0;
    for (std::size_t i = 0; i < ratios.size(); ++i) {
        if (periods_s[i] < from_s || periods_s[i] > to_s) {
            continue;
        }
        double const misfit = std::abs(ratios[i] - 1);
        if (count == 0 || ratios[i] < figures.lowest_ratio) {
            figures.lowest_ratio = ratios[i];
            figures.lowest_period_s = periods_s[i];
        }
        if (ratios[i] > figures.highest_ratio) {
            figures.highest_ratio = ratios[i];
            figures.highest_period_s = periods_s[i];
        }
        below = ratios[i] < 1 ? below + 1 : 0;
        if (below > figures.longest_below) {
            figures.longest_below = below;
            figures.longest_below_to_s = periods_s[i];
        }
        count += 1;
        sum += ratios[i];
        squares += ratios[i] * ratios[i];
        figures.mean_misfit += misfit;
        figures.below_fraction += ratios[i] < 1 ? 1 : 0;
        if (misfit > figures.max_misfit) {
            figures.max_misfit = misfit;
            figures.max_misfit_period_s = periods_s[i];
        }
    }
    if (count > 0) {
        figures.mean_misfit /= count;
        figures.below_fraction /= count;
        figures.mean_ratio = sum / count;
        double const variance = std::max(0.0, squares / count - figures.mean_ratio * figures.mean_ratio);
        figures.cov = figures.mean_ratio > 0 ? std::sqrt(variance) / figures.mean_ratio : 0.0;
    }
    return figures;
}

double worst_decade_misfit(std::span<double const> periods_s, std::span<double const> ratios) {
    constexpr double decade = 10 * (1 - 1e-9);  // a grid of whole decades must not miss its last point by rounding
    double sum = 0;
    double worst = 0;
    std::size_t first = 0;
    for (std::size_t last = 0; last < ratios.size(); ++last) {
        sum += std::abs(ratios[last] - 1);
        bool const whole = periods_s[last] >= decade * periods_s[first];
        if (whole || (last + 1 == ratios.size() && worst == 0)) {
            worst = std::max(worst, sum / static_cast<double>(last - first + 1));
        }
        while (first < last && periods_s[last] >= decade * periods_s[first]) {
            sum -= std::abs(ratios[first] - 1);
            ++first;
        }
    }
    return worst;
}

double spectral_intensity_ratio(std::span<double const> periods_s, std::span<double const> ratios,
                                TargetSpectrum const& target) {
    constexpr double from_s = 0.1;
    constexpr double to_s = 2.5;
    if (periods_s.empty() || periods_s.front() > from_s || periods_s.back() < to_s) {
        return 0;
    }
    double wave = 0;
    double wanted = 0;
    for (std::size_t i = 1; i < periods_s.size(); ++i) {
        double const left = std::max(from_s, periods_s[i - 1]);
        double const right = std::min(to_s, periods_s[i]);
        if (right <= left) {
            continue;
        }
        auto const ratio_at = [&](double period) {
            double const share = (period - periods_s[i - 1]) / (periods_s[i] - periods_s[i - 1]);
            return ratios[i - 1] + share * (ratios[i] - ratios[i - 1]);
        };
        double const psv_left = target.psv_mps(left);
        double const psv_right = target.psv_mps(right);
        wave += (right - left) / 2 * (ratio_at(left) * psv_left + ratio_at(right) * psv_right);
        wanted += (right - left) / 2 * (psv_left + psv_right);
    }
    return wave / wanted;
}

}  // namespace overturn
