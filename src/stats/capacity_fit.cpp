#include "stats/capacity_fit.hpp"

#include <algorithm>
#include <cmath>

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_rng.h>
#include <gsl/gsl_sf_erf.h>

#include "core/error.hpp"
#include "core/random_stream.hpp"
#include "stats/detail/curve_fit.hpp"
#include "stats/detail/extended_real.hpp"
#include "stats/detail/few_capacities.hpp"

namespace overturn {
namespace {

double log_censored(double z) { return gsl_sf_log_erfc(z / std::sqrt(2.0)) - std::log(2.0); }

// Value, gradient and curvature by intercept and slope.
struct CapacityScores {
    double value = 0, d_intercept = 0, d_slope = 0, ii = 0, is = 0, ss = 0;

    void add(double value_of_one, double first, double second, double x) {
        value += value_of_one;
        d_intercept += first;
        d_slope += first * x;
        ii += second;
        is += second * x;
        ss += second * x * x;
    }
};

CapacityScores scores_of(std::span<Capacity const> capacities, ProbitLine const& line) {
    CapacityScores sum;
    for (auto const& capacity : capacities) {
        double const x = std::log(capacity.intensity);
        double const z = line.at(x);
        if (capacity.reached) {
            sum.add(std::log(line.slope) - z * z / 2, -z, -1, x);
            sum.d_slope += 1 / line.slope;
            sum.ss -= 1 / (line.slope * line.slope);
        } else {
            double const hazard = gsl_sf_hazard(z);
            sum.add(log_censored(z), -hazard, -hazard * (hazard - z), x);
        }
    }
    return sum;
}

// From the reached ones alone, which lie too low where others are censored.
std::optional<ProbitLine> start_of(std::span<Capacity const> capacities) {
    double n = 0;
    double sum = 0;
    double squares = 0;
    for (auto const& capacity : capacities) {
        double const x = std::log(capacity.intensity);
        n += capacity.reached ? 1 : 0;
        sum += capacity.reached ? x : 0;
        squares += capacity.reached ? x * x : 0;
    }
    double const variance = n > 0 ? squares / n - sum * sum / (n * n) : 0;
    constexpr double rounding = 1e-14;
    if (n < 2 || !(variance > rounding)) {
        return std::nullopt;
    }
    double const beta = std::sqrt(variance);
    return ProbitLine{-sum / n / beta, 1 / beta};
}

// The likelihood is concave: a step that does not raise it is too long.
std::optional<ProbitLine> step_from(std::span<Capacity const> capacities, ProbitLine const& line,
                                    CapacityScores const& at) {
    double const determinant = at.ii * at.ss - at.is * at.is;
    double const intercept = -(at.ss * at.d_intercept - at.is * at.d_slope) / determinant;
    double const slope = -(at.ii * at.d_slope - at.is * at.d_intercept) / determinant;
    constexpr int most_halvings = 40;
    double part = 1;
    for (int i = 0; i < most_halvings; ++i, part /= 2) {
        ProbitLine const tried{line.intercept + part * intercept, line.slope + part * slope};
        if (tried.slope > 0 && log_likelihood(capacities, tried) >= at.value) {
            return tried;
        }
    }
    return std::nullopt;
}

// The best slope where the line passes z at x, by golden sections of its logarithm.
double best_through(std::span<Capacity const> capacities, double x, double z, double near) {
    auto const value = [&](double log_slope) {
        double const slope = std::exp(log_slope);
        return log_likelihood(capacities, {z - slope * x, slope});
    };
    constexpr double golden = 0.6180339887498949;
    constexpr double reach = 3;
    constexpr int sections = 45;
    double low = std::log(near) - reach;
    double high = std::log(near) + reach;
    for (int i = 0; i < sections; ++i) {
        double const a = high - golden * (high - low);
        double const b = low + golden * (high - low);
        bool const rises = value(a) < value(b);
        (rises ? low : high) = rises ? a : b;
    }
    return value((low + high) / 2);
}

// From the maximum outwards to where the profile has fallen by half the allowed deviance.
template <class Profile> double end_of(Profile const& profile, double from, double step, double least) {
    constexpr int most_doublings = 40;
    constexpr int halvings = 40;
    double inside = from;
    double outside = from + step;
    for (int i = 0; profile(outside) > least; ++i, step *= 2) {
        if (i == most_doublings) {
            return step > 0 ? infinite : -infinite;
        }
        inside = outside;
        outside += step;
    }
    for (int i = 0; i < halvings; ++i) {
        double const middle = (inside + outside) / 2;
        (profile(middle) > least ? inside : outside) = middle;
    }
    return (inside + outside) / 2;
}

std::vector<Replicate> refits_of(std::span<Capacity const> capacities, BootstrapKey const& key) {
    std::vector<Replicate> replicates;
    std::vector<Capacity> drawn(capacities.size());
    for (int r = 0; r < key.replicates; ++r) {
        RandomStream stream(key.seed, r, Purpose::bootstrap, key.stream);
        for (auto& capacity : drawn) {
            capacity = capacities[gsl_rng_uniform_int(stream.gsl(), capacities.size())];
        }
        auto const line = fit_capacities(drawn);
        replicates.push_back(line ? Replicate{line->log_median(), line->beta()} : Replicate{unknown, unknown});
    }
    return replicates;
}

FragilityFit::Intervals intervals_of(Interval median, Interval beta, Interval five, FragilityRequest const& request) {
    FragilityFit::Intervals ends{median, beta, five, std::nullopt};
    if (request.beta_u > 0) {
        double const margin = std::exp(-hclpf_score * request.beta_u);
        ends.hclpf = Interval{five.lower * margin, five.upper * margin};
    }
    return ends;
}

void take_beta_u(FragilityFit& fit, FragilityRequest const& request) {
    fit.beta_u = fit.beta_u_stated = request.beta_u;
    fit.beta_u_known = request.beta_u > 0;
}

void raise_flags(FragilityFit& fit, std::size_t capacities) {
    fit.flags |= static_cast<std::int64_t>(capacities) < waves_enough_to_resample ? bit(FragilityFlag::few_waves) : 0;
    fit.flags |= fit.beta_u_known ? 0 : bit(FragilityFlag::no_beta_u);
    double const median = std::exp(fit.line->log_median());
    fit.flags |= median < fit.lowest || median > fit.highest ? bit(FragilityFlag::median_outside_data) : 0;
    auto const hclpf = fit.hclpf();
    fit.flags |= hclpf && *hclpf < fit.lowest ? bit(FragilityFlag::hclpf_outside_data) : 0;
}

}  // namespace

std::optional<CapacityMoments> moments_of(std::span<Capacity const> capacities) {
    auto const n = static_cast<double>(capacities.size());
    if (std::ssize(capacities) < least_waves || !std::ranges::all_of(capacities, &Capacity::reached)) {
        return std::nullopt;
    }
    double mean = 0;
    for (auto const& capacity : capacities) {
        mean += std::log(capacity.intensity) / n;
    }
    auto const [lowest, highest] = std::ranges::minmax(capacities, {}, &Capacity::intensity);
    if (lowest.intensity == highest.intensity) {  // else a mean's rounding is taken for a spread
        return CapacityMoments{lowest.intensity, 0};
    }
    double squares = 0;
    for (auto const& capacity : capacities) {
        squares += std::pow(std::log(capacity.intensity) - mean, 2);
    }
    return CapacityMoments{std::exp(mean), std::sqrt(squares / (n - 1))};
}

double log_likelihood(std::span<Capacity const> capacities, ProbitLine const& line) {
    double sum = 0;
    for (auto const& capacity : capacities) {
        double const z = line.at(std::log(capacity.intensity));
        sum += capacity.reached ? std::log(line.slope) - z * z / 2 : log_censored(z);
    }
    return sum;
}

std::optional<ProbitLine> fit_capacities(std::span<Capacity const> capacities) {
    auto line = start_of(capacities);
    constexpr int most_steps = 200;
    constexpr double small = 1e-12;
    for (int i = 0; line && i < most_steps; ++i) {
        auto const at = scores_of(capacities, *line);
        auto const next = step_from(capacities, *line, at);
        if (!next) {
            return line;  // nothing near is higher: the maximum, to rounding
        }
        bool const done = std::abs(next->slope - line->slope) <= small * line->slope
                          && std::abs(next->log_median() - line->log_median()) <= small;
        line = next;
        if (done) {
            return line;
        }
    }
    return std::nullopt;
}

Interval profile_intensity(std::span<Capacity const> capacities, ProbitLine const& best, double probability,
                           double confidence) {
    double const z = gsl_cdf_ugaussian_Pinv(probability);
    double const least = log_likelihood(capacities, best) - gsl_cdf_chisq_Pinv(confidence, 1) / 2;
    auto const profile = [&](double x) { return best_through(capacities, x, z, best.slope); };
    double const from = (z - best.intercept) / best.slope;
    double const step = 0.1 * best.beta();
    return {std::exp(end_of(profile, from, -step, least)), std::exp(end_of(profile, from, step, least))};
}

Interval profile_beta(std::span<Capacity const> capacities, ProbitLine const& best, double confidence) {
    double const least = log_likelihood(capacities, best) - gsl_cdf_chisq_Pinv(confidence, 1) / 2;
    // Of one slope the likelihood is concave in the intercept.
    auto const profile = [&](double log_slope) {
        double const slope = std::exp(log_slope);
        double intercept = -slope * best.log_median();
        constexpr int steps = 25;
        for (int i = 0; i < steps; ++i) {
            auto const at = scores_of(capacities, {intercept, slope});
            intercept -= at.d_intercept / at.ii;
        }
        return log_likelihood(capacities, {intercept, slope});
    };
    double const from = std::log(best.slope);
    constexpr double step = 0.05;
    return {std::exp(-end_of(profile, from, step, least)), std::exp(-end_of(profile, from, -step, least))};
}

std::vector<Stripe> stripes_of(std::span<Capacity const> capacities) {
    std::vector<Capacity> sorted(capacities.begin(), capacities.end());
    std::ranges::sort(sorted, {}, &Capacity::intensity);
    std::int64_t const waves = sorted.size();
    std::vector<Stripe> stripes;
    std::int64_t fallen = 0;
    std::int64_t censored_below = 0;
    for (std::size_t i = 0; i < sorted.size();) {
        std::int64_t censored_here = 0;
        double const at = sorted[i].intensity;
        for (; i < sorted.size() && sorted[i].intensity == at; ++i) {
            ++(sorted[i].reached ? fallen : censored_here);
        }
        stripes.push_back({.amplitude = at, .trials = waves, .overturned = fallen, .failed = censored_below});
        censored_below += censored_here;
    }
    return stripes;
}

FragilityFit fragility_of(std::span<Capacity const> capacities, FragilityRequest const& request) {
    OVERTURN_EXPECT(!capacities.empty());
    if (std::ssize(capacities) < least_waves) {
        FragilityFit fit;
        take_beta_u(fit, request);
        fit.state = FragilityState::few_waves;
        fit.passing = request.passing;
        fit.trials = static_cast<double>(capacities.size());
        fit.overturned = static_cast<double>(std::ranges::count_if(capacities, &Capacity::reached));
        fit.waves = std::ssize(capacities);
        return fit;
    }
    auto const line = fit_capacities(capacities);
    if (!line) {
        auto data = FragilityData::of_stripes(stripes_of(capacities));
        data.waves_shared = true;
        return fit_fragility(data, request);
    }
    FragilityFit fit;
    fit.state = FragilityState::fitted;
    fit.passing = request.passing;
    fit.trials = static_cast<double>(capacities.size());
    fit.overturned = static_cast<double>(std::ranges::count_if(capacities, &Capacity::reached));
    fit.waves = capacities.size();
    auto const [lowest, highest] = std::ranges::minmax(capacities, {}, &Capacity::intensity);
    fit.lowest = lowest.intensity;
    fit.highest = highest.intensity;
    fit.line = line;
    take_beta_u(fit, request);
    double const five_percent = gsl_cdf_ugaussian_P(-hclpf_score);
    auto const c = request.confidence;
    fit.profile = intervals_of(profile_intensity(capacities, *line, 0.5, c), profile_beta(capacities, *line, c),
                               profile_intensity(capacities, *line, five_percent, c), request);
    Bootstrap const refits(refits_of(capacities, request.bootstrap), *line, *line);
    fit.refits = refits.replicates();
    fit.replicates = refits.size();
    fit.replicates_without_curve = refits.without_curve();
    fit.bootstrap = intervals_of(refits.intensity(0.5, c), refits.beta(c), refits.intensity(five_percent, c), request);
    fit.ends = fit.profile;
    if (std::ssize(capacities) < waves_enough_to_resample) {  // the profile likelihood of so few is short too
        FewCapacities const few(*line, std::ssize(capacities), c);
        fit.method = FragilityFit::Method::widest;
        widen(*fit.ends, intervals_of(few.median(), few.beta(), few.intensity(five_percent), request));
    }
    raise_flags(fit, capacities.size());
    return fit;
}

}  // namespace overturn
