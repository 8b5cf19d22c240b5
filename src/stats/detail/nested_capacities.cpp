#include "stats/detail/nested_capacities.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include <gsl/gsl_cdf.h>

#include "stats/detail/extended_real.hpp"

namespace overturn {
namespace {

constexpr double golden = 0.6180339887498949;

// Where f is highest between two ends, by golden sections.
template <class Function> double highest(Function const& f, double low, double high) {
    constexpr int sections = 34;
    double a = high - golden * (high - low);
    double b = low + golden * (high - low);
    double at_a = f(a);
    double at_b = f(b);
    for (int i = 0; i < sections; ++i) {
        if (at_a < at_b) {
            low = std::exchange(a, b);
            at_a = at_b;
            b = low + golden * (high - low);
            at_b = f(b);
        } else {
            high = std::exchange(b, a);
            at_b = at_a;
            a = high - golden * (high - low);
            at_a = f(a);
        }
    }
    return (low + high) / 2;
}

// From the best one outwards to where the profile falls to `least`, by false positions (Illinois: Dowell and Jarratt
// 1971).
template <class Profile> double end_of(Profile const& profile, double from, double step, double least) {
    constexpr int most_doublings = 12;
    constexpr int most_steps = 60;
    constexpr double precision = 1e-12;
    double inside = from;
    double above = profile(from) - least;
    double outside = from + step;
    double below = profile(outside) - least;
    for (int i = 0; below > 0; ++i) {
        if (i == most_doublings) {
            return step > 0 ? infinite : -infinite;
        }
        step *= 2;
        inside = std::exchange(outside, outside + step);
        above = std::exchange(below, profile(outside) - least);
    }
    for (int i = 0; i < most_steps && std::abs(outside - inside) > precision; ++i) {
        double const x = inside + (outside - inside) * above / (above - below);
        double const y = profile(x) - least;
        if (y > 0) {
            inside = x;
            above = y;
            below /= 2;
        } else {
            outside = x;
            below = y;
            above /= 2;
        }
        if (y == 0) {
            break;
        }
    }
    return outside;
}

// Without cancellation: both ends on the side of the nearer tail.
double share_between(double low, double high) {
    return low > 0 ? gsl_cdf_ugaussian_Q(low) - gsl_cdf_ugaussian_Q(high)
                   : gsl_cdf_ugaussian_P(high) - gsl_cdf_ugaussian_P(low);
}

}  // namespace

std::vector<CapacityRange> ranges_of(std::span<SingleTrial const> trials) {
    std::vector<SingleTrial> sorted(trials.begin(), trials.end());
    std::ranges::sort(sorted, {}, [](SingleTrial const& trial) {
        return std::tuple(trial.wave, trial.id, trial.intensity, !trial.overturned);
    });
    std::map<std::pair<double, double>, double> counts;
    for (std::size_t wave = 0; wave < sorted.size();) {
        std::vector<std::pair<double, double>> components;
        std::size_t i = wave;
        while (i < sorted.size() && sorted[i].wave == sorted[wave].wave) {
            auto const id = sorted[i].id;
            std::pair range{-infinite, infinite};
            for (; i < sorted.size() && sorted[i].wave == sorted[wave].wave && sorted[i].id == id; ++i) {
                double const x = std::log(sorted[i].intensity);
                if (sorted[i].overturned) {
                    range.second = std::min(range.second, x);
                } else if (std::isinf(range.second)) {
                    range.first = x;
                }
            }
            components.push_back(range);
        }
        for (auto const& range : components) {
            counts[range] += 1 / static_cast<double>(components.size());
        }
        wave = i;
    }
    std::vector<CapacityRange> ranges;
    ranges.reserve(counts.size());
    for (auto const& [range, waves] : counts) {
        ranges.push_back({range.first, range.second, waves});
    }
    return ranges;
}

std::vector<CapacityRange> ranges_of(std::span<FragilityPoint const> points, double waves) {
    std::vector<CapacityRange> ranges;
    ranges.reserve(points.size() + 1);
    double low = -infinite;
    double share = 0;
    for (auto const& point : points) {
        double const higher = std::max(share, point.probability());
        ranges.push_back({low, point.log_intensity, waves * (higher - share)});
        low = point.log_intensity;
        share = higher;
    }
    ranges.push_back({low, infinite, waves * (1 - share)});
    return ranges;
}

NestedCapacities::NestedCapacities(std::vector<CapacityRange> ranges, ProbitLine const& near, double confidence)
    : ranges_(std::move(ranges)), log_median_(near.log_median()), log_beta_(std::log(near.beta())) {
    double const width = 4 * near.beta();
    log_median_ = highest([&](double x) { return best_through(x, 0); }, log_median_ - width, log_median_ + width);
    constexpr double reach = 3;
    log_beta_ = highest([&](double log_beta) { return log_likelihood(log_median_, std::exp(log_beta)); },
                        log_beta_ - reach, log_beta_ + reach);
    least_ = log_likelihood(log_median_, std::exp(log_beta_)) - gsl_cdf_chisq_Pinv(confidence, 1) / 2;
}

double NestedCapacities::log_likelihood(double log_median, double beta) const {
    constexpr double least_share = 1e-300;
    double sum = 0;
    for (auto const& [low, high, waves] : ranges_) {
        if (waves > 0) {
            sum +=
                waves
                * std::log(std::max(share_between((low - log_median) / beta, (high - log_median) / beta), least_share));
        }
    }
    return sum;
}

double NestedCapacities::best_through(double x, double z) const {
    constexpr double reach = 3;
    auto const value = [&](double log_beta) { return log_likelihood(x - z * std::exp(log_beta), std::exp(log_beta)); };
    return value(highest(value, log_beta_ - reach, log_beta_ + reach));
}

double NestedCapacities::best_of_beta(double beta) const {
    double const width = 4 * std::max(beta, std::exp(log_beta_));
    auto const value = [&](double log_median) { return log_likelihood(log_median, beta); };
    return value(highest(value, log_median_ - width, log_median_ + width));
}

Interval NestedCapacities::intensity(double probability) const {
    double const z = gsl_cdf_ugaussian_Pinv(probability);
    double const beta = std::exp(log_beta_);
    double const best = log_median_ + z * beta;
    auto const profile = [&](double x) { return best_through(x, z); };
    return {std::exp(end_of(profile, best, -beta / 4, least_)), std::exp(end_of(profile, best, beta / 4, least_))};
}

Interval NestedCapacities::beta() const {
    auto const profile = [&](double log_beta) { return best_of_beta(std::exp(log_beta)); };
    constexpr double step = 0.1;
    return {std::exp(end_of(profile, log_beta_, -step, least_)), std::exp(end_of(profile, log_beta_, step, least_))};
}

Interval NestedCapacities::probability(double intensity) const {
    double const x = std::log(intensity);
    double const best = (x - log_median_) / std::exp(log_beta_);
    auto const profile = [&](double z) { return best_through(x, z); };
    constexpr double step = 0.1;
    return {gsl_cdf_ugaussian_P(end_of(profile, best, -step, least_)),
            gsl_cdf_ugaussian_P(end_of(profile, best, step, least_))};
}

}  // namespace overturn
